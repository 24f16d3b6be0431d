"""Playing and editing for a long time: memory does not grow."""

import gc
import os
from itertools import count
from pathlib import Path

import pytest
from PySide6.QtTest import QTest

from app.view.collecting import collecting_here
from starskel.files.projects.examples import example
from tests.app.driver import Driver

FRAME = 16
"""Milliseconds."""

FRAMES = 60
"""Of one round: about a second."""

WARM_UP = 120
"""Rounds after which everything is loaded and every store is full; of few rounds, the first half."""

MOST = 10e6
"""Bytes by which memory may grow afterwards."""

STATUS = Path("/proc/self/statm")

EXAMPLES = ("arm", "star", "letters-b-8", "figure-9-fish")


def resident() -> int:
    """Give the bytes that the program takes, all garbage collected."""
    gc.collect()
    return int(STATUS.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def play_and_edit(driver: Driver, number: int) -> None:
    """Open an example now and then, drag a vertex to and fro while it plays, undo at times."""
    if number % 10 == 0:
        driver.session.show_project(example(EXAMPLES[number // 10 % len(EXAMPLES)]))
        driver.window.player.play()
        driver.session.choose_tool("select")
    x, y = driver.document.vertices("source")[number % len(driver.document.vertices("source"))]
    driver.press("source", x, y)
    for frame in range(FRAMES):
        driver.hover("source", x + 0.01 * frame, y + 0.02 * (frame % 7))
        QTest.qWait(FRAME)
    driver.release("source", x, y + 0.01)
    if number % 3 == 0:
        driver.session.undo()


@pytest.mark.skipif(not STATUS.exists(), reason="only Linux tells by a file what memory a program takes")
@pytest.mark.endurance(usual=8, long=1200)
def test_memory_does_not_grow_while_it_is_played_and_edited(driver: Driver, rounds: int) -> None:
    ticks = count()
    driver.window.player.t_changed.connect(lambda _: next(ticks))
    curve: list[int] = []
    with collecting_here():
        for number in range(rounds):
            play_and_edit(driver, number)
            curve.append(resident())
    told = " ".join(f"{size / 1e6:.1f}" for size in curve[:: max(rounds // 40, 1)])
    shown = next(ticks)
    print(f"{shown} frames; MB: {told}")
    warm = curve[min(rounds // 2, WARM_UP) :]
    assert shown > rounds
    assert max(warm) - warm[0] < MOST
