"""From blends to files: what to draw, and how it is laid out."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from app.compute import Result
from starskel.easing import EVEN, Easing
from starskel.errors import InvalidFile, either, told
from starskel.files.postscript import write_eps, write_postscript
from starskel.files.svg import write_svg
from starskel.sheet.comparison import Row, comparison_sheet
from starskel.sheet.drawing import Drawing
from starskel.sheet.keyframe import Shown, keyframes
from starskel.sheet.rows import page_sheets, row_sheet

Layout = Literal["row", "frame", "pages", "sheet"]

ENDINGS: dict[Layout, tuple[str, ...]] = {
    "row": (".svg", ".eps"),
    "frame": (".svg", ".eps"),
    "pages": (".ps",),
    "sheet": (".svg", ".eps"),
}
"""The formats that each layout can be written in, the usual one first."""


@dataclass(frozen=True)
class Choice:
    """What the user wants exported.

    Attributes
    ----------
    layout : {"row", "frame", "pages", "sheet"}
        A row of keyframes, one frame, a page for each keyframe, or a row for each method.
    method : str
        The method, for all layouts but the sheet.
    frames : int
        How many keyframes, from t = 0 to 1.
    t : float
        The moment, for the layout of one frame.
    marks, pieces, skeleton : bool
        What is shown on the frames.
    easing : Easing
        How t runs over the time: keyframes are evenly apart in time.
    """

    layout: Layout
    method: str
    frames: int = 6
    t: float = 0.5
    marks: bool = False
    pieces: bool = False
    skeleton: bool = False
    easing: Easing = EVEN

    @property
    def times(self) -> list[float]:
        """The moments to draw."""
        if self.layout == "frame":
            return [self.t]
        return [self.easing.t(time) for time in np.linspace(0, 1, self.frames).tolist()]


def write(path: Path, name: str, choice: Choice, results: Sequence[Result]) -> None:
    """Write what was chosen; the ending of the file's name tells the format.

    Raises
    ------
    InvalidFile
        If the ending does not go with the layout, or the file cannot be written.
    """
    ending = path.suffix.lower()
    if ending not in ENDINGS[choice.layout]:
        raise InvalidFile(
            told('{name} ends in "{ending}"', name=path.name, ending=path.suffix),
            told("end it in {endings}", endings=either(ENDINGS[choice.layout])),
        )
    drawings = _drawings(name, choice, results)
    if ending == ".svg":
        write_svg(path, drawings[0])
    elif ending == ".eps":
        write_eps(path, drawings[0])
    else:
        write_postscript(path, drawings)


def _drawings(name: str, choice: Choice, results: Sequence[Result]) -> Sequence[Drawing]:
    shown = Shown(choice.marks, choice.pieces, choice.skeleton)
    if choice.layout == "sheet":
        return (comparison_sheet(name, [_row(result, choice.times, shown) for result in results]),)
    blend = next(result.blend for result in results if result.method == choice.method)
    frames = keyframes(blend, choice.times, shown)
    title = f"{name}: {choice.method}"
    if choice.layout == "row":
        return (row_sheet(title, frames),)
    return page_sheets(title, frames)


def _row(result: Result, times: list[float], shown: Shown) -> Row:
    return Row.of(result.method, result.report, keyframes(result.blend, times, shown))
