"""Film: blends on their way from the first shape to the last, and the drawings of it."""

from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import accumulate

from starskel.arrays import Floats
from starskel.blending.frames import Blend
from starskel.easing import EVEN, Easing
from starskel.errors import InvalidFile, StarskelError, told
from starskel.export.settings import Settings
from starskel.images.morph import ImageMorph
from starskel.images.placed import SOLID, Pixels, PlacedImage
from starskel.quality import Report, ShapeReport
from starskel.shapes.shape_blend import ShapeBlend
from starskel.sheet import style
from starskel.sheet.comparison import Row, comparison_sheet
from starskel.sheet.drawing import Drawing
from starskel.sheet.keyframe import Keyframe, Shown
from starskel.sheet.keyframes import keyframes
from starskel.sheet.rows import Stage, box_of, row_sheet
from starskel.sheet.style import Look, PartLook

Pictures = Callable[[], tuple[PlacedImage | None, PlacedImage | None]]


def no_pictures() -> tuple[None, None]:
    """Say that neither source nor target has a picture."""
    return None, None


@dataclass(frozen=True, eq=False)
class Scene:
    """The way from one key shape to the next, by one method.

    Attributes
    ----------
    blend : Blend or ShapeBlend
    report : Report or ShapeReport or None
        What was measured of it; sheets need it.
    length : float
        How long it takes, beside the others.
    easing : Easing
        How t runs over its time.
    name : str
        Which of several steps it is; "" where there is but one.
    pictures : callable
        Gives the pictures of source and target, each where there is one; asked when they are to be seen.
    looks : tuple of PartLook
        For each ring of a frame its colours, and whether it is to be seen; none where all look as usual.

    Examples
    --------
    >>> import starskel
    >>> from starskel.export.film import Scene
    >>> square, kite = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (3, 2), (1, 5), (-1, 2)]
    >>> Scene(starskel.blend(square, kite, marks=[(0, 0)]), length=2.0).blend.at(0).tolist()
    [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]
    """

    blend: Blend | ShapeBlend
    report: Report | ShapeReport | None = None
    length: float = 1.0
    easing: Easing = EVEN
    name: str = ""
    pictures: Pictures = no_pictures
    looks: tuple[PartLook, ...] = ()

    def frames(self, ts: Sequence[float], shown: Shown, *, moving: bool = False) -> tuple[Keyframe, ...]:
        """Give the frames at each t; those that move are drawn alike at all times."""
        frames = keyframes(self.blend, ts, shown, self.looks, moving=moving)
        if not shown.pictures or self.morph is None:
            return frames
        paint = partial(_painted, self.morph, self.hidden)
        return tuple(replace(frame, picture=partial(paint, frame.t)) for frame in frames)

    @property
    def hidden(self) -> tuple[int, ...]:
        """The rings of a frame that are not to be seen, by their numbers."""
        return tuple(number for number, look in enumerate(self.looks) if not look.visible)

    @cached_property
    def morph(self) -> ImageMorph | None:
        """What carries the pictures; None where there are none."""
        source, target = self.pictures()
        if source is None and target is None:
            return None
        return ImageMorph(self.blend, source, target, solid=SOLID)

    def row(self, method: str, ts: Sequence[float], shown: Shown) -> Row:
        """Give the row of a sheet.

        Raises
        ------
        StarskelError
            If nothing was measured.
        """
        name = ", ".join(filter(None, (method, self.name)))
        if self.report is None:
            raise StarskelError(
                f'a sheet tells how good a blend is, but "{name}" was not measured',
                "give its scene the report of `measure`",
            )
        return Row.of(name, self.report, self.frames(ts, shown))


@dataclass(frozen=True, eq=False)
class Track:
    """The whole way by one method.

    Attributes
    ----------
    name : str
        The method, or what else made it.
    scenes : tuple of Scene
        One after another.

    Examples
    --------
    Two scenes of which the second takes three times as long:

    >>> import starskel
    >>> from starskel.export.film import Scene, Track
    >>> square, kite = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (3, 2), (1, 5), (-1, 2)]
    >>> there = starskel.blend(square, kite, marks=[(0, 0)])
    >>> back = starskel.blend(kite, square, marks=[(0, 0)])
    >>> Track("stitched", (Scene(there), Scene(back, length=3.0))).bounds
    (0.0, 0.25, 1.0)
    """

    name: str
    scenes: tuple[Scene, ...]

    @cached_property
    def bounds(self) -> tuple[float, ...]:
        """The shares of the whole way at which scenes begin and end."""
        ends = list(accumulate((scene.length for scene in self.scenes), initial=0.0))
        return tuple(end / ends[-1] for end in ends)

    def at(self, time: float, eased: bool) -> tuple[int, float]:
        """Give the scene at a share of the whole way, and its t."""
        if len(self.scenes) == 1:
            return 0, self.scenes[0].easing.t(time) if eased else time
        number = min(bisect_right(self.bounds, time) - 1, len(self.scenes) - 1)
        start, end = self.bounds[number : number + 2]
        share = min((time - start) / (end - start), 1.0)
        return number, self.scenes[number].easing.t(share) if eased else share

    def frames(self, times: Sequence[float], eased: bool, shown: Shown) -> tuple[Keyframe, ...]:
        """Give the frames at shares of the whole way."""
        places = [self.at(time, eased) for time in times]
        found: dict[int, Keyframe] = {}
        for number, scene in enumerate(self.scenes):
            own = [k for k, (which, _) in enumerate(places) if which == number]
            if own:
                found.update(zip(own, scene.frames([places[k][1] for k in own], shown), strict=True))
        return tuple(found[k] for k in range(len(places)))


@dataclass(frozen=True, eq=False)
class Film:
    """What is to be drawn.

    Attributes
    ----------
    name : str
        What it shows.
    tracks : tuple of Track
        The methods; all go the same steps.
    settings : Settings
        How it is to be drawn.

    Examples
    --------
    `starskel.export.write.write` makes files of it; here the drawings themselves:

    >>> import starskel
    >>> from starskel.export.film import Film, Scene, Track
    >>> from starskel.export.settings import Settings, even_times
    >>> square, kite = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (3, 2), (1, 5), (-1, 2)]
    >>> track = Track("stitched", (Scene(starskel.blend(square, kite, marks=[(0, 0)])),))
    >>> len(list(Film("Kite", (track,), Settings("frames", even_times(3))).drawings()))
    3
    """

    name: str
    tracks: tuple[Track, ...]
    settings: Settings

    @property
    def title(self) -> str:
        """The name, and the method where it is not told otherwise."""
        if len(self.tracks) > 1 or self.settings.layout == "sheet":
            return self.name
        return f"{self.name}: {self.tracks[0].name}"

    def drawings(self, *, pictured: bool = False) -> Iterator[Drawing]:
        """Give the sheet, or a drawing for each frame, as the layout asks, with or without pictures."""
        if not pictured:
            yield from self._without_pictures.drawings(pictured=True)
            return
        wanted, look = self.settings, self.settings.look
        if wanted.layout == "row":
            frames = [frame for track in self.tracks for frame in self._frames(track)]
            columns = len(wanted.times) if len(self.tracks) > 1 else None
            yield row_sheet(self.title, frames, look, columns)
        elif wanted.layout == "sheet":
            paper = style.PAPER if look.paper is None else look.paper
            yield comparison_sheet(self.title, self._rows(), look=replace(look, paper=paper))
        else:
            tracks = [self._frames(track) for track in self.tracks]
            stage = self.stage(box_of([frame for frames in tracks for frame in frames]), look)
            for number, together in enumerate(zip(*tracks, strict=True)):
                yield stage.picture(self.title, f"frame-{number}", together)

    def stage(self, box: Floats, look: Look) -> Stage:
        """Give the view of a box in which the methods stand side by side."""
        return Stage(box, tuple(track.name for track in self.tracks), look)

    @property
    def only(self) -> Track:
        """The one track, for formats that hold but one.

        Raises
        ------
        InvalidFile
            If there are several.
        """
        if len(self.tracks) > 1:
            raise InvalidFile(
                told("{count} methods do not go into one such file", count=len(self.tracks)),
                told("choose one method, and a file for each"),
            )
        return self.tracks[0]

    @property
    def _without_pictures(self) -> "Film":
        shown = replace(self.settings.shown, pictures=False)
        return replace(self, settings=replace(self.settings, shown=shown))

    def _frames(self, track: Track) -> tuple[Keyframe, ...]:
        return track.frames(self.settings.times, self.settings.eased, self.settings.shown)

    def _rows(self) -> list[Row]:
        wanted = self.settings
        rows = []
        for track in self.tracks:
            for scene in track.scenes:
                ts = [scene.easing.t(time) if wanted.eased else time for time in wanted.times]
                rows.append(scene.row(track.name, ts, wanted.shown))
        return rows


def _painted(
    morph: ImageMorph, hidden: tuple[int, ...], t: float, box: Floats, size: tuple[int, int]
) -> Pixels:
    (left, bottom), (right, top) = box.tolist()
    return morph.at(t, size, (left, bottom, right, top), hidden=hidden)
