"""What is on the screen, while a gesture is under way and when it ends."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from app.compute import Blends, Subject
from starskel import Polygon
from tests.families import two_opt

CROSSING = Subject(Polygon(two_opt(12, 0)), Polygon(two_opt(12, 1000)), tuple((k, k) for k in range(12)))


@pytest.fixture
def blends(qapp) -> Iterator[Blends]:  # type: ignore[no-untyped-def]
    blends = Blends()
    yield blends
    blends.close()


def simple(blends: Blends) -> bool:
    result = blends.results["stitched"].result
    return result is not None and result.report.simple


def test_what_a_gesture_left_unsettled_is_improved_when_it_ends(blends: Blends, qtbot: QtBot) -> None:
    blends.show(CROSSING, ("stitched",), live=True)
    qtbot.waitUntil(lambda: not blends.busy)
    assert not blends.results["stitched"].stale
    assert not blends.results["stitched"].settled
    assert not simple(blends)
    blends.show(CROSSING, ("stitched",))
    assert blends.busy
    assert not blends.results["stitched"].stale  # the first one stays on the screen meanwhile
    qtbot.waitUntil(lambda: not blends.busy, timeout=20_000)
    assert blends.results["stitched"].settled
    assert simple(blends)


def test_what_is_settled_is_not_computed_again(blends: Blends, qtbot: QtBot) -> None:
    blends.show(CROSSING, ("stitched",))
    qtbot.waitUntil(lambda: not blends.busy, timeout=20_000)
    settled = blends.results["stitched"].result
    blends.show(CROSSING, ("stitched",))
    assert not blends.busy
    blends.show(None, ("stitched",))
    blends.show(CROSSING, ("stitched",))
    assert not blends.busy
    assert blends.results["stitched"].result is settled
