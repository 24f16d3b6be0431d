"""Animation: a film as one picture that moves."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from starskel.export.film import Film, Track
from starskel.sheet.drawing import Drawing
from starskel.sheet.keyframe import ALONE, Keyframe
from starskel.sheet.rows import Stage, box_of

_LOOKS = 101
"""So many frames of each scene are looked at to see how much room an animation needs."""


@dataclass(frozen=True, eq=False)
class Animation:
    """A film that is played.

    Attributes
    ----------
    film : Film
    """

    film: Film

    @cached_property
    def shots(self) -> "tuple[Shot, ...]":
        """Its parts, one after another: in each of them all that is drawn only moves."""
        bounds = self.film.tracks[0].bounds
        return tuple(
            Shot(self, number, bounds[number], bounds[number + 1])
            for number in range(len(self.film.tracks[0].scenes))
        )

    def pictures(self) -> Iterator[Drawing]:
        """Give a drawing for each picture, for formats that are made of pictures."""
        wanted, tracks = self.film.settings, self.film.tracks
        for time in wanted.moments:
            frames = [track.frames([time], wanted.eased, wanted.shown) for track in tracks]
            yield self.stage.picture(self.film.title, "frame", [own for (own,) in frames])

    @cached_property
    def stage(self) -> Stage:
        """The view that all pictures have; what is drawn in it only moves."""
        ts = np.linspace(0, 1, _LOOKS).tolist()
        scenes = [scene for track in self.film.tracks for scene in track.scenes]
        box = box_of([frame for scene in scenes for frame in scene.frames(ts, ALONE, moving=True)])
        return self.film.stage(box, replace(self.film.settings.look, signs=False, captions=False))


@dataclass(frozen=True, eq=False)
class Shot:
    """A part of an animation in which the same items are drawn at all times, only elsewhere.

    Attributes
    ----------
    animation : Animation
    number : int
        Which of the scenes it shows.
    start, end : float
        When it begins and ends, as shares of the whole way.
    """

    animation: Animation
    number: int
    start: float
    end: float

    def drawings(self, shares: Sequence[float]) -> tuple[Drawing, ...]:
        """Give the pictures at shares of this part's time, all of the same items."""
        film, stage = self.animation.film, self.animation.stage
        frames = [self._frames(track, shares) for track in film.tracks]
        return tuple(stage.picture(film.title, "frame", own) for own in zip(*frames, strict=True))

    def _frames(self, track: Track, shares: Sequence[float]) -> tuple[Keyframe, ...]:
        scene, wanted = track.scenes[self.number], self.animation.film.settings
        ts = [scene.easing.t(share) if wanted.eased else share for share in shares]
        return scene.frames(ts, replace(wanted.shown, pictures=False), moving=True)
