"""What is on the screen of one step and of several, while a gesture is under way and when it ends."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from app.compute import Blends, Failure, Result, Subject
from starskel import Polygon
from tests.app.compute.subjects import subject
from tests.families import two_opt

CROSSING = subject(Polygon(two_opt(12, 0)), Polygon(two_opt(12, 1000)), tuple((k, k) for k in range(12)))
METHODS = ("vertex", "edge-angle")
SHAPES = tuple(Polygon([(0, 0), (10, 0), (10, 10 + k), (0, 10)]) for k in range(6))


def step(k: int, *marks: tuple[int, int]) -> Subject:
    return subject(SHAPES[k], SHAPES[k + 1], marks)


@pytest.fixture
def blends(qapp) -> Iterator[Blends]:  # type: ignore[no-untyped-def]
    blends = Blends()
    yield blends
    blends.close()


@pytest.fixture
def computed(blends: Blends) -> list[Subject]:
    """What is computed, in order, once for each method."""
    subjects: list[Subject] = []

    def take(subject: Subject, outcome: Result | Failure) -> None:
        assert isinstance(outcome, Result)
        subjects.append(subject)

    blends._computer.delivered.connect(take)
    return subjects


def wait(blends: Blends, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not blends.busy)
    assert not any(state.stale for states in blends.steps for state in states.values())


def test_the_step_on_the_canvases_is_computed_before_those_after_and_before_it(
    blends: Blends, computed: list[Subject], qtbot: QtBot
) -> None:
    blends.show((step(0), step(1), step(2)), 1, METHODS)
    wait(blends, qtbot)
    assert computed[::2] == [step(1), step(2), step(0)]
    assert blends.results is blends.steps[1]


def test_an_edit_of_one_step_computes_no_other(blends: Blends, computed: list[Subject], qtbot: QtBot) -> None:
    blends.show((step(0), step(1), step(2)), 0, METHODS)
    wait(blends, qtbot)
    held = blends.steps
    del computed[:]
    blends.show((step(0), step(1, (0, 0)), step(2)), 1, METHODS)
    assert blends.steps[1]["vertex"].stale
    assert blends.steps[1]["vertex"].result is held[1]["vertex"].result, "until there is a newer one"
    wait(blends, qtbot)
    assert computed == [step(1, (0, 0))] * 2
    assert (blends.steps[0], blends.steps[2]) == (held[0], held[2])


def test_results_follow_their_steps_when_these_come_in_another_order(
    blends: Blends, computed: list[Subject], qtbot: QtBot
) -> None:
    blends.show((step(0), step(1), step(2)), 0, METHODS)
    wait(blends, qtbot)
    first, second, third = blends.steps
    blends.show((step(2), None, step(0), step(1)), 1, METHODS)
    assert not blends.busy
    assert (blends.steps[0], blends.steps[2], blends.steps[3]) == (third, first, second)
    assert blends.results["vertex"].result is None


def test_no_result_of_a_step_on_the_screen_is_forgotten(
    blends: Blends, computed: list[Subject], qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.compute.blends.REMEMBERED", 1)
    blends.show((step(0), step(1), step(2)), 0, METHODS)
    wait(blends, qtbot)
    blends.show((step(0, (0, 0)), step(1), step(2)), 0, METHODS)
    wait(blends, qtbot)
    assert len(blends._memory) == 3 * len(METHODS) + 1


def test_equal_steps_are_computed_once(blends: Blends, computed: list[Subject], qtbot: QtBot) -> None:
    blends.show((step(0), step(1), step(0)), 0, METHODS)
    wait(blends, qtbot)
    assert computed[::2] == [step(0), step(1)]


def simple(blends: Blends) -> bool:
    result = blends.results["stitched"].result
    return result is not None and result.report.simple


def test_what_a_gesture_left_unsettled_is_improved_when_it_ends(blends: Blends, qtbot: QtBot) -> None:
    blends.show((CROSSING,), 0, ("stitched",), live=True)
    qtbot.waitUntil(lambda: not blends.busy)
    assert not blends.results["stitched"].stale
    assert not blends.results["stitched"].settled
    assert not simple(blends)
    blends.show((CROSSING,), 0, ("stitched",))
    assert blends.busy
    assert not blends.results["stitched"].stale  # the first one stays on the screen meanwhile
    qtbot.waitUntil(lambda: not blends.busy, timeout=20_000)
    assert blends.results["stitched"].settled
    assert simple(blends)


def test_what_is_settled_is_not_computed_again(blends: Blends, qtbot: QtBot) -> None:
    blends.show((CROSSING,), 0, ("stitched",))
    qtbot.waitUntil(lambda: not blends.busy, timeout=20_000)
    settled = blends.results["stitched"].result
    blends.show((CROSSING,), 0, ("stitched",))
    assert not blends.busy
    blends.show((None,), 0, ("stitched",))
    blends.show((CROSSING,), 0, ("stitched",))
    assert not blends.busy
    assert blends.results["stitched"].result is settled


def test_what_is_large_is_blended_when_that_is_asked_for(
    blends: Blends, computed: list[Subject], qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.compute.blends.LARGE", 7)
    blends.show((step(0),), 0, METHODS)
    assert not blends.busy
    assert blends.held == 8
    blends.recompute()
    assert blends.busy
    assert blends.held == 0
    wait(blends, qtbot)
    assert computed == [step(0), step(0)]
    blends.show((step(1),), 0, METHODS)  # an edit of something large is not blended at once, either
    assert not blends.busy
    assert blends.held == 8
    assert all(state.stale for state in blends.results.values())


def test_what_is_not_large_is_blended_beside_it(blends: Blends, qtbot: QtBot, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    monkeypatch.setattr("app.compute.blends.LARGE", 8)
    large = subject(CROSSING.source[0], CROSSING.target[0])
    blends.show((large, step(0)), 0, METHODS)
    qtbot.waitUntil(lambda: not blends.busy)
    assert [all(state.fresh for state in states.values()) for states in blends.steps] == [False, True]
    assert blends.held == 24
