"""Sheets of keyframes: in rows as in the paper's figures, or one a page. A sheet has one scale."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats
from starskel.errors import StarskelError, told
from starskel.sheet import style
from starskel.sheet.cell import Placement, cell, cross_sign
from starskel.sheet.drawing import Area, Drawing, Group, Item, Label, Place
from starskel.sheet.keyframe import Keyframe
from starskel.sheet.style import USUAL, Look

LONGEST = 12
"""Frames that stand in one row before a new one begins."""

CELL = 96.0
"""The longer side of the largest frame of a row, in points."""

PAGE = 360.0
"""The longer side of the box of all frames where each stands alone, in points."""

_CAPTION = 14.0


@dataclass(frozen=True)
class Grid:
    """The measures of a sheet's cells.

    Attributes
    ----------
    scale : float
        Points for one of the user's units.
    width, height : float
        The box, in points, that every frame fits into.
    look : Look
        How frames are drawn.
    """

    scale: float
    width: float
    height: float
    look: Look = USUAL

    @classmethod
    def of(cls, frames: Sequence[Keyframe], look: Look = USUAL) -> "Grid":
        """Give the grid whose largest frame fills a cell.

        Raises
        ------
        StarskelError
            If all that is to be seen is a point.
        """
        width, height = np.max([np.ptp(frame.box, axis=0) for frame in frames], axis=0).tolist()
        scale = _scale(look.size or CELL, max(width, height))
        return cls(scale, width * scale, height * scale, look)

    def cell(self, name: str, frame: Keyframe, middle: Place) -> Group:
        """Give a frame with the middle of its box there, and a sign at the corner where it meets itself."""
        on_paper = Placement(self.scale, frame.box.mean(axis=0), np.array(middle))
        items = list(cell(frame, on_paper, self.look))
        if self.look.signs and not frame.simple:
            x, y = on_paper(frame.box)[1].tolist()
            items += cross_sign((x + 4, y + 4), 4)
        return Group(name, tuple(items))


def row_sheet(
    title: str, frames: Sequence[Keyframe], look: Look = USUAL, columns: int | None = None
) -> Drawing:
    """Give the frames in rows of so many columns; by default in one, which goes on below after `LONGEST`."""
    grid = Grid.of(frames, look)
    columns = columns or min(len(frames), LONGEST)
    rows = -(-len(frames) // columns)
    pitch = grid.height + look.gap + (_CAPTION if look.captions else 0)
    width = 2 * look.margin + columns * (grid.width + look.gap) - look.gap
    height = 2 * look.margin + rows * pitch - look.gap

    def items() -> Iterator[Item]:
        yield from paper(width, height, look)
        for number, frame in enumerate(frames):
            row, column = divmod(number, columns)
            x = look.margin + column * (grid.width + look.gap) + grid.width / 2
            y = height - look.margin - row * pitch - grid.height / 2
            yield grid.cell(f"frame-{number}", frame, (x, y))
            if look.captions:
                yield caption(frame, (x, y - grid.height / 2 - _CAPTION))

    return Drawing(title, width, height, tuple(items()))


@dataclass(frozen=True, eq=False)
class Stage:
    """One view of the user's plane for pictures that lie on one another, so that they can be flipped.

    Attributes
    ----------
    box : (2, 2) array
        The lower left and the upper right corner of what is seen, in the user's units.
    names : tuple of str
        What stands side by side, each in its own copy of the view; several are named.
    look : Look
        How frames are drawn.
    """

    box: Floats
    names: tuple[str, ...] = ("",)
    look: Look = USUAL

    @property
    def longer_side(self) -> float:
        """The longer side of the box on paper, in points."""
        return self.look.size or PAGE

    def picture(self, title: str, name: str, frames: Sequence[Keyframe]) -> Drawing:
        """Give one picture; as many frames as there are names stand in it.

        Raises
        ------
        StarskelError
            If the box is a point.
        """
        scale = _scale(self.longer_side, float(np.ptp(self.box, axis=0).max()))
        (width, height), margin = (np.ptp(self.box, axis=0) * scale).tolist(), self.look.margin
        head = _CAPTION if len(self.names) > 1 else 0.0
        foot = _CAPTION if self.look.captions else 0.0
        pitch = width + self.look.gap
        whole = 2 * margin + len(frames) * pitch - self.look.gap, 2 * margin + foot + height + head

        def items() -> Iterator[Item]:
            yield from paper(*whole, self.look)
            for number, frame in enumerate(frames):
                left = margin + number * pitch
                on_paper = Placement(scale, self.box[0], np.array([left, margin + foot]))
                own = name if len(frames) == 1 else f"{name}-{self.names[number]}"
                yield Group(own, tuple(cell(frame, on_paper, self.look)))
                if self.look.captions:
                    yield caption(frame, (left + width / 2, margin))
                if head:
                    place = (left + width / 2, whole[1] - margin - style.TEXT_SIZE)
                    text = self.names[number]
                    yield Label(text, place, style.NAME_SIZE, style.INK, "middle", bold=True)

        return Drawing(title, *whole, tuple(items()))


def _scale(side: float, extent: float) -> float:
    """Give how many points are as long as one of the user's units where an extent fills a side."""
    if not extent:
        raise StarskelError(told("all that is to be seen is a point"), told("choose other times"))
    return side / extent


def box_of(frames: Sequence[Keyframe]) -> Floats:
    """Give the lower left and the upper right corner of a box that all frames fit into, as rows."""
    corners = np.concatenate([frame.box for frame in frames])
    return np.array([corners.min(axis=0), corners.max(axis=0)])


def paper(width: float, height: float, look: Look) -> Iterator[Area]:
    """Give what is behind a sheet, where there is something."""
    if look.paper is not None:
        corners = np.array([[0, 0], [width, 0], [width, height], [0, height]], dtype=np.float64)
        yield Area(corners, look.paper)


def caption(frame: Keyframe, place: Place) -> Label:
    """Give the time of a frame as a line of text, in the colour of warning where the frame meets itself."""
    colour = style.FAINT if frame.simple else style.CROSSING
    return Label(f"t = {frame.t:.3g}", place, style.TEXT_SIZE, colour, "middle")
