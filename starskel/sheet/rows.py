"""Sheets of keyframes: in rows as in the paper's figures, or one a page. A sheet has one scale."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from starskel.sheet import style
from starskel.sheet.cell import Placement, cell, cross_sign
from starskel.sheet.drawing import Drawing, Group, Item, Label, Place
from starskel.sheet.keyframe import Keyframe
from starskel.sheet.shape_keyframe import ShapeKeyframe

LONGEST = 12
"""Frames that stand in one row before a new one begins."""

_CAPTION = 14.0
_PAGE = 360.0


@dataclass(frozen=True)
class Grid:
    """The measures of a sheet's cells.

    Attributes
    ----------
    scale : float
        Points for one of the user's units.
    width, height : float
        The box, in points, that every frame fits into.
    """

    scale: float
    width: float
    height: float

    @classmethod
    def of(cls, frames: Sequence[Keyframe | ShapeKeyframe]) -> "Grid":
        """Give the grid whose largest frame fills a cell."""
        width, height = np.max([np.ptp(frame.box, axis=0) for frame in frames], axis=0).tolist()
        scale = style.CELL / max(width, height)
        return cls(scale, width * scale, height * scale)

    def cell(self, name: str, frame: Keyframe | ShapeKeyframe, middle: Place) -> Group:
        """Give a frame with the middle of its box there, and a sign at the corner where it meets itself."""
        on_paper = Placement(self.scale, frame.box.mean(axis=0), np.array(middle))
        items = list(cell(frame, on_paper))
        if not frame.simple:
            x, y = on_paper(frame.box)[1].tolist()
            items += cross_sign((x + 4, y + 4), 4)
        return Group(name, tuple(items))


def row_sheet(title: str, frames: Sequence[Keyframe | ShapeKeyframe], captions: bool = True) -> Drawing:
    """Give the frames in a row; after `LONGEST` of them another one begins."""
    grid = Grid.of(frames)
    columns = min(len(frames), LONGEST)
    rows = -(-len(frames) // LONGEST)
    pitch = grid.height + style.GAP + (_CAPTION if captions else 0)
    width = 2 * style.MARGIN + columns * (grid.width + style.GAP) - style.GAP
    height = 2 * style.MARGIN + rows * pitch - style.GAP

    def items() -> Iterator[Item]:
        for number, frame in enumerate(frames):
            row, column = divmod(number, LONGEST)
            x = style.MARGIN + column * (grid.width + style.GAP) + grid.width / 2
            y = height - style.MARGIN - row * pitch - grid.height / 2
            yield grid.cell(f"frame-{number}", frame, (x, y))
            if captions:
                yield caption(frame, (x, y - grid.height / 2 - _CAPTION))

    return Drawing(title, width, height, tuple(items()))


def page_sheets(
    title: str, frames: Sequence[Keyframe | ShapeKeyframe], captions: bool = True
) -> tuple[Drawing, ...]:
    """Give a page for each frame, all with one view of the user's plane, so that they can be flipped."""
    corners = np.concatenate([frame.box for frame in frames])
    low, high = corners.min(axis=0), corners.max(axis=0)
    scale = _PAGE / float((high - low).max())
    foot = _CAPTION if captions else 0.0
    margin = np.array([style.MARGIN, style.MARGIN + foot])
    on_paper = Placement(scale, low, margin)
    width, height = (on_paper(high) + style.MARGIN).tolist()

    def page(number: int, frame: Keyframe | ShapeKeyframe) -> Drawing:
        items: list[Item] = [Group(f"frame-{number}", tuple(cell(frame, on_paper)))]
        if captions:
            items.append(caption(frame, (width / 2, style.MARGIN)))
        return Drawing(title, width, height, tuple(items))

    return tuple(page(number, frame) for number, frame in enumerate(frames))


def caption(frame: Keyframe | ShapeKeyframe, place: Place) -> Label:
    """Give the time of a frame as a line of text, in the colour of warning where the frame meets itself."""
    colour = style.FAINT if frame.simple else style.CROSSING
    return Label(f"t = {frame.t:.3g}", place, style.TEXT_SIZE, colour, "middle")
