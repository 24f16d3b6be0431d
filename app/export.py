"""From blends to files: what to draw, and how it is laid out."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from app.compute import Result
from starskel.easing import EVEN, Easing
from starskel.export import formats
from starskel.export.film import Film, Scene, Track
from starskel.export.settings import Settings, even_times
from starskel.export.write import write
from starskel.sheet.keyframe import Shown

Layout = Literal["row", "frame", "pages", "sheet"]

OUTPUTS: dict[Layout, formats.Layout] = {
    "row": "row",
    "frame": "frames",
    "pages": "frames",
    "sheet": "sheet",
}
"""What the library calls them."""

ENDINGS: dict[Layout, tuple[str, ...]] = {
    layout: formats.endings_of(output, numbered=False if layout == "pages" else None)
    for layout, output in OUTPUTS.items()
}
"""The endings of the formats that each layout can be written in, the usual one first."""


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
    def settings(self) -> Settings:
        """The same in the library's words."""
        single = self.layout == "frame"
        return Settings(
            layout=OUTPUTS[self.layout],
            times=(self.t,) if single else even_times(self.frames),
            eased=not single,
            shown=Shown(self.marks, self.pieces, self.skeleton),
        )


def write_choice(path: Path, name: str, choice: Choice, results: Sequence[Result]) -> None:
    """Write what was chosen; the ending of the file's name tells the format.

    Raises
    ------
    InvalidFile
        If the ending does not go with the layout, or the file cannot be written.
    """
    wanted = [result for result in results if choice.layout == "sheet" or result.method == choice.method]
    tracks = tuple(
        Track(result.method, (Scene(result.blend, result.report, easing=choice.easing),)) for result in wanted
    )
    write(path, Film(name, tracks, choice.settings))
