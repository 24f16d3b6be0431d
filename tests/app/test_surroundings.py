import subprocess
import sys

from app.surroundings import NO_DISPLAY, what_is_missing


def test_no_display_is_said_instead_of_a_crash() -> None:
    assert what_is_missing({}) == NO_DISPLAY


def test_a_display_that_does_not_answer_counts_as_none() -> None:
    assert what_is_missing({"DISPLAY": ":987"}) == NO_DISPLAY
    assert what_is_missing({"WAYLAND_DISPLAY": "wayland-987"}) == NO_DISPLAY


def test_a_platform_that_needs_no_display_is_left_alone() -> None:
    assert what_is_missing({"QT_QPA_PLATFORM": "offscreen"}) == ""
    assert what_is_missing({"QT_QPA_PLATFORM": "xcb"}) == NO_DISPLAY


def test_the_command_ends_with_status_2_and_a_message() -> None:
    environment = {"PATH": "/usr/bin:/bin"}
    done = subprocess.run(
        [sys.executable, "-m", "app"], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert done.stderr == f"starskel-editor: {NO_DISPLAY}\n"


def test_numpy_is_not_loaded_before_its_threads_are_limited() -> None:
    program = "import sys, app.__main__; sys.exit('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0
