"""Colours and sizes of a sheet. The colours stay apart for people who see no red or no green."""

from dataclasses import dataclass

from starskel.sheet.drawing import Colour, Stroke, channels

PAPER: Colour = "#ffffff"
INK: Colour = "#20262e"
FAINT: Colour = "#6b7480"
RULE: Colour = "#d5d9de"
WAY: tuple[Colour, ...] = ("#9cc9ec", "#d9c6e4", "#f8c58a")
SIMPLE: Colour = "#00705c"
NATURAL: Colour = "#8a5a00"
CROSSING: Colour = "#b0003a"
PIECES: tuple[Colour, ...] = ("#a6d5f2", "#f7d98b", "#a3dcc6", "#e6bcd4", "#f3f0a9", "#c3c8ee", "#f2b99a")
SKELETON: Colour = "#3b2a7a"

OUTLINE = Stroke(INK, 0.7)
CROSSING_OUTLINE = Stroke(CROSSING, 1.1)
PIECE_OUTLINE = Stroke(INK, 0.3)
SKELETON_LINE = Stroke(SKELETON, 0.8)
VERTEX_OUTLINE = Stroke(INK, 0.4)
JOINT_OUTLINE = Stroke(SKELETON, 0.5)
HAIRLINE = Stroke(RULE, 0.5)

TITLE_SIZE = 13.0
NAME_SIZE = 10.5
TEXT_SIZE = 8.0
PIN_SIZE = 4.4
VERTEX_SIZE = 0.9


@dataclass(frozen=True)
class Look:
    """How frames are drawn; lengths are points.

    Attributes
    ----------
    colours : tuple of str
        What frames are filled with, evenly spread from t = 0 to 1 and mixed in between; none leaves them
        empty. The usual ones go by way of a third, since a mixture of the two at the ends is grey.
    outline : Stroke or None
        How outlines are drawn.
    paper : str or None
        What is behind the frames; None leaves it open.
    gap, margin : float
        What is between the frames of a sheet, and round all that is drawn.
    size : float or None
        The longer side of the largest frame; None is the usual one of the layout.
    signs : bool
        Whether frames that meet themselves show it.
    captions : bool
        Whether the time of each frame is written below it.
    """

    colours: tuple[Colour, ...] = WAY
    outline: Stroke | None = OUTLINE
    paper: Colour | None = None
    gap: float = 16.0
    margin: float = 18.0
    size: float | None = None
    signs: bool = True
    captions: bool = True

    def fill(self, t: float) -> Colour | None:
        """Give the colour of the frame at time t."""
        if len(self.colours) < 2:
            return next(iter(self.colours), None)
        way = t * (len(self.colours) - 1)
        number = min(int(way), len(self.colours) - 2)
        return _mix(self.colours[number], self.colours[number + 1], way - number)


@dataclass(frozen=True)
class PartLook:
    """How a part of a shape is drawn on its way.

    Attributes
    ----------
    colours : (str, str)
        Its own, "#rrggbb", at the start and at the end; empty for those that the whole has there.
    visible : bool
        Whether it is shown.
    """

    colours: tuple[Colour, Colour] = ("", "")
    visible: bool = True

    def fill(self, look: Look, t: float) -> Colour | None:
        """Give the colour of the part at time t, where the whole looks like this."""
        usual = look.fill(0.0), look.fill(1.0)
        if self.colours == ("", "") or None in usual:
            return look.fill(t)
        start, end = (own or given for own, given in zip(self.colours, usual, strict=True))
        return None if start is None or end is None else _mix(start, end, t)


USUAL = Look()
"""How frames look where nothing else is asked for."""

USUAL_PART = PartLook()


def _mix(source: Colour, target: Colour, t: float) -> Colour:
    mixed = (round((1 - t) * a + t * b) for a, b in zip(channels(source), channels(target), strict=True))
    return "#" + bytes(mixed).hex()
