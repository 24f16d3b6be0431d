"""From blends to files: what to draw, and how it is laid out."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from app.compute import Result
from app.model.sequence import USUAL
from starskel.export import formats
from starskel.export.film import Film, Scene, Track
from starskel.export.settings import Settings, even_times
from starskel.export.write import write
from starskel.files.step import Step
from starskel.sheet.keyframe import Shown

Layout = Literal["row", "frame", "pages", "sheet", "animation", "numbers"]

OUTPUTS: dict[Layout, formats.Layout] = {
    "row": "row",
    "frame": "frames",
    "pages": "frames",
    "sheet": "sheet",
    "animation": "animation",
    "numbers": "numbers",
}
"""What the library calls them."""

FORMATS: dict[Layout, tuple[formats.Format, ...]] = {
    layout: formats.formats_of(output, numbered=False if layout == "pages" else None)
    for layout, output in OUTPUTS.items()
}
"""The formats that each layout can be written in, the usual one first."""


@dataclass(frozen=True)
class Choice:
    """What the user wants exported.

    Attributes
    ----------
    layout : {"row", "frame", "pages", "sheet", "animation", "numbers"}
        A row of keyframes, one frame, a page for each keyframe, a row for each method, a picture that moves,
        or the coordinates.
    method : str
        The method, for all layouts but the sheet.
    frames : int
        How many keyframes, from t = 0 to 1, for all layouts but the frame and the animation.
    t : float
        The moment, for the layout of one frame.
    marks, pieces, skeleton : bool
        What is shown on the frames.
    eased : bool
        Whether keyframes are evenly apart in the time of playing, with easing; else in t.
    whole : bool
        Whether all steps of the sequence are wanted, for all layouts but the frame.
    seconds : float
        How long an animation takes one way.
    returning : bool
        Whether an animation comes back again.
    """

    layout: Layout
    method: str
    frames: int = 6
    t: float = 0.5
    marks: bool = False
    pieces: bool = False
    skeleton: bool = False
    eased: bool = False
    whole: bool = False
    seconds: float = 3.0
    returning: bool = False

    @property
    def settings(self) -> Settings:
        """The same in the library's words."""
        single = self.layout == "frame"
        return Settings(
            layout=OUTPUTS[self.layout],
            times=(self.t,) if single else even_times(self.frames),
            eased=self.eased and not single,
            shown=Shown(self.marks, self.pieces, self.skeleton),
            duration=self.seconds,
            returning=self.returning,
        )


@dataclass(frozen=True, eq=False)
class Stretch:
    """A step of the sequence as it is exported.

    Attributes
    ----------
    results : tuple of Result
        Of each method its blend.
    step : Step
        How long it takes, and with which easing.
    name : str
        Which step it is; "" where there is but one.
    """

    results: tuple[Result, ...]
    step: Step = USUAL
    name: str = ""

    def scene(self, method: str) -> Scene:
        """Give the blend by a method, as the library draws it."""
        result = next(each for each in self.results if each.method == method)
        return Scene(result.blend, result.report, self.step.duration, self.step.easing, self.name)


def write_choice(path: Path, name: str, choice: Choice, stretches: Sequence[Stretch]) -> None:
    """Write what was chosen; the ending of the file's name tells the format.

    Parameters
    ----------
    path : Path
        Where to.
    name : str
        What the document is called.
    choice : Choice
    stretches : sequence of Stretch
        One after another; all have the same methods.

    Raises
    ------
    InvalidFile
        If the ending does not go with the layout, or the file cannot be written.
    """
    methods = (
        [result.method for result in stretches[0].results] if choice.layout == "sheet" else [choice.method]
    )
    if len(stretches) == 1:  # of a step shown by itself the title tells which it is
        name, stretches = f"{name} {stretches[0].name}".strip(), [replace(stretches[0], name="")]
    tracks = tuple(Track(method, tuple(each.scene(method) for each in stretches)) for method in methods)
    write(path, Film(name, tracks, choice.settings))
