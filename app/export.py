"""From blends to files: what to draw, and how it is laid out."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from app.compute import Result
from app.model.sequence import USUAL
from starskel.easing import Easing
from starskel.export import formats, layouts, morphs
from starskel.export.film import Film, Scene, Track
from starskel.export.settings import Settings, even_times
from starskel.export.write import write
from starskel.files.image_pairs import placed_image
from starskel.files.projects.picture import Picture
from starskel.files.projects.step import Step
from starskel.images.morph import ImageMorph
from starskel.images.placed import SOLID, PlacedImage
from starskel.sheet.keyframe import Shown
from starskel.sheet.style import USUAL as USUAL_LOOK
from starskel.sheet.style import Look, PartLook
from starskel.task import UNWATCHED, Task

Layout = Literal["row", "frame", "pages", "sheet", "animation", "morph", "numbers"]

DRAWN: dict[Layout, layouts.Layout] = {
    "row": "row",
    "frame": "frames",
    "pages": "frames",
    "sheet": "sheet",
    "animation": "animation",
    "numbers": "numbers",
}
"""What the library calls those that are drawn; in a morph there are the pictures alone."""

FORMATS: dict[Layout, tuple[formats.OutputFormat, ...]] = {
    **{layout: formats.formats_of(output) for layout, output in DRAWN.items()},
    "morph": tuple(
        next(each for each in formats.FORMATS if each.ending == ending) for ending in morphs.ENDINGS
    ),
}
"""The formats that each layout can be written in, the usual one first."""

BARE = Shown()
"""Nothing besides the shapes, or the pictures in them."""

USUAL_SIDE = 512
"""Pixels of the longer side of a morph where nothing else is wanted."""


@dataclass(frozen=True)
class Choice:
    """What the user wants exported.

    Attributes
    ----------
    layout : {"row", "frame", "pages", "sheet", "animation", "morph", "numbers"}
        A row of keyframes, one frame, a page or a file for each keyframe, a row for each method, a picture
        that moves, the pictures inside the shapes alone, or the coordinates.
    method : str
        The method, for all layouts but the sheet.
    frames : int
        How many keyframes, from t = 0 to 1, for all layouts but the frame and what moves.
    t : float
        The moment, for the layout of one frame.
    shown : Shown
        What is seen on the frames; pictures only in formats that can hold them.
    eased : bool
        Whether keyframes are evenly apart in the time of playing, with easing; else in t.
    whole : bool
        Whether all steps of the sequence are wanted, for all layouts but the frame.
    seconds : float
        How long what moves takes one way.
    returning : bool
        Whether it comes back again.
    pixels : int or None
        The longer side of what is made of pixels; None for the usual.
    rate : float
        Pictures a second, of what moves and is made of them.
    look : Look
        Colours, outline, margin and size.
    times : tuple of float
        When the keyframes are, in the place of evenly spread ones; none leaves it at these.
    tolerance : float
        How far a vertex may stray between the keys of an animation, as a part of the box of all frames.
    """

    layout: Layout
    method: str
    frames: int = 6
    t: float = 0.5
    shown: Shown = BARE
    eased: bool = False
    whole: bool = False
    seconds: float = 3.0
    returning: bool = False
    pixels: int | None = None
    rate: float = 25.0
    look: Look = USUAL_LOOK
    times: tuple[float, ...] = ()
    tolerance: float = 0.001

    @property
    def settings(self) -> Settings:
        """The same in the library's words."""
        single = self.layout == "frame"
        return Settings(
            layout=DRAWN[self.layout],
            times=(self.t,) if single else self._keyframes,
            eased=self.eased and not single,
            look=self.look,
            shown=self.shown,
            duration=self.seconds,
            returning=self.returning,
            rate=self.rate,
            pixels=self.pixels,
            tolerance=self.tolerance,
        )

    @property
    def _keyframes(self) -> tuple[float, ...]:
        return self.times or even_times(self.frames)

    def morph(self, easing: Easing, hidden: Sequence[int], *, moving: bool) -> morphs.MorphSettings:
        """Give what is wanted of a morph, which moves or is a row of keyframes, without hidden parts."""
        whole = Settings("animation", duration=self.seconds, returning=self.returning, rate=self.rate)
        times = whole.moments if moving else self._keyframes
        ts = [easing.t(time) for time in times] if self.eased else times
        return morphs.MorphSettings(ts, self.pixels or USUAL_SIDE, self.rate, self.look.paper, hidden=hidden)


@dataclass(frozen=True, eq=False)
class ExportedStep:
    """A step of the sequence as it is exported.

    Attributes
    ----------
    results : tuple of Result
        Of each method its blend.
    step : Step
        How long it takes, and with which easing.
    name : str
        Which step it is; "" where there is but one.
    pictures : (Picture or None, Picture or None)
        What is behind its shapes.
    looks : tuple of PartLook
        How its parts look.
    """

    results: tuple[Result, ...]
    step: Step = USUAL
    name: str = ""
    pictures: tuple[Picture | None, Picture | None] = (None, None)
    looks: tuple[PartLook, ...] = ()

    def scene(self, method: str) -> Scene:
        """Give the blend by a method, as the library draws it."""
        result = next(each for each in self.results if each.method == method)
        return Scene(
            result.blend,
            result.report,
            self.step.duration,
            self.step.easing,
            self.name,
            self._placed,
            self.looks,
        )

    def _placed(self) -> tuple[PlacedImage | None, PlacedImage | None]:
        source, target = (None if each is None else placed_image(each) for each in self.pictures)
        return source, target


def write_choice(
    path: Path, name: str, choice: Choice, steps: Sequence[ExportedStep], task: Task = UNWATCHED
) -> tuple[Path, ...]:
    """Write what was chosen, and give the files written; the ending of the file's name tells the format.

    Parameters
    ----------
    path : Path
        Where to.
    name : str
        What the document is called.
    choice : Choice
    steps : sequence of ExportedStep
        One after another; all have the same methods. A morph is of the first.
    task : Task
        Watches it, and may stop it.

    Raises
    ------
    InvalidFile
        If the ending does not go with the layout, or the file cannot be written.
    Cancelled
        If the task is to stop.
    """
    if choice.layout == "morph":
        return _write_morph(path, choice, steps[0], task)
    methods = [result.method for result in steps[0].results] if choice.layout == "sheet" else [choice.method]
    if len(steps) == 1:  # of a step shown by itself the title tells which it is
        name, steps = f"{name} {steps[0].name}".strip(), [replace(steps[0], name="")]
    tracks = tuple(Track(method, tuple(each.scene(method) for each in steps)) for method in methods)
    return write(path, Film(name, tracks, choice.settings), task)


def _write_morph(path: Path, choice: Choice, step: ExportedStep, task: Task) -> tuple[Path, ...]:
    """Write the pictures alone, as `starskel morph` does."""
    morphs.check_ending(path)
    scene = step.scene(choice.method)
    source, target = scene.pictures()
    part = task.part(0, 0.1)
    morph = ImageMorph(
        scene.blend, source, target, solid=SOLID, progress=part.reach, should_stop=task.should_stop
    )
    wanted = choice.morph(scene.easing, scene.hidden, moving=path.suffix.lower() != morphs.PNG)
    return morphs.write_morph(path, morph, wanted, task.part(0.1, 1))
