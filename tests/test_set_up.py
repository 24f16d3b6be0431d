"""What the set-up does about system packages that are missing."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[1] / ".ci" / "system_packages.py"
RENDERERS = ["ghostscript", "librsvg2-bin", "chromium", "xvfb", "xauth"]
ROOT, SOMEBODY = 0, 1000

pytestmark = pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="only Linux lets packages be missing"
)


def set_up(path, user, *sets):
    """Run the script as this user, where programs are found in one folder only."""
    program = (
        f"import os, runpy; os.geteuid = lambda: {user}; runpy.run_path({str(SCRIPT)!r}, run_name='__main__')"
    )
    command = [sys.executable, "-c", program, *sets]
    environment = {**os.environ, "PATH": str(path)}
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


@pytest.fixture
def apt(tmp_path):
    """A folder with a package manager that only writes down what it is told."""
    folder = tmp_path / "bin"
    folder.mkdir()
    (folder / "apt-get").write_text(f'#!/bin/sh\necho "$@" >> {tmp_path}/told\n')
    (folder / "apt-get").chmod(0o755)
    return folder


def test_root_installs_what_is_missing_and_nothing_else(apt, tmp_path):
    (apt / "gs").symlink_to("/bin/sh")
    assert set_up(apt, ROOT, "renderers").returncode == 0
    update, install = (tmp_path / "told").read_text().splitlines()
    assert update.split()[0] == "update"
    assert install.split()[-len(RENDERERS[1:]) :] == RENDERERS[1:]
    assert "--no-install-recommends" in install
    assert "ghostscript" not in install


def test_others_are_told_what_to_install(apt, tmp_path):
    done = set_up(apt, SOMEBODY, "renderers")
    assert done.returncode == 1
    assert done.stderr.split()[-len(RENDERERS) :] == RENDERERS
    assert not (tmp_path / "told").exists()


def test_nothing_is_done_where_nothing_is_missing(apt, tmp_path):
    for name in ("gs", "rsvg-convert", "chromium", "Xvfb", "xauth"):
        (apt / name).symlink_to("/bin/sh")
    done = set_up(apt, ROOT, "renderers", "venv")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert not (tmp_path / "told").exists()
