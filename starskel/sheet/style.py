"""Colours and sizes of a sheet. The colours stay apart for people who see no red or no green."""

from starskel.sheet.drawing import Colour, Stroke

PAPER: Colour = "#ffffff"
INK: Colour = "#20262e"
FAINT: Colour = "#6b7480"
RULE: Colour = "#d5d9de"
SOURCE: Colour = "#9cc9ec"
MIDDLE: Colour = "#d9c6e4"
TARGET: Colour = "#f8c58a"
SIMPLE: Colour = "#00705c"
NATURAL: Colour = "#8a5a00"
CROSSING: Colour = "#b0003a"
PIECES: tuple[Colour, ...] = ("#a6d5f2", "#f7d98b", "#a3dcc6", "#e6bcd4", "#f3f0a9", "#c3c8ee", "#f2b99a")
SKELETON: Colour = "#3b2a7a"

OUTLINE = Stroke(INK, 0.7)
CROSSING_OUTLINE = Stroke(CROSSING, 1.1)
PIECE_OUTLINE = Stroke(INK, 0.3)
SKELETON_LINE = Stroke(SKELETON, 0.8)
JOINT_OUTLINE = Stroke(SKELETON, 0.5)
HAIRLINE = Stroke(RULE, 0.5)

CELL = 96.0
"""The longer side of a cell, in points."""

GAP = 16.0
MARGIN = 18.0

TITLE_SIZE = 13.0
NAME_SIZE = 10.5
TEXT_SIZE = 8.0
PIN_SIZE = 4.4


def fill(t: float) -> Colour:
    """Give the colour of the frame at time t: by way of a third, since a mixture of the two is grey."""
    return _mix(SOURCE, MIDDLE, 2 * t) if t < 0.5 else _mix(MIDDLE, TARGET, 2 * t - 1)


def _mix(source: Colour, target: Colour, t: float) -> Colour:
    channels = [(int(source[i : i + 2], 16), int(target[i : i + 2], 16)) for i in (1, 3, 5)]
    return "#" + "".join(f"{round((1 - t) * a + t * b):02x}" for a, b in channels)
