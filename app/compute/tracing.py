"""Outlines traced in the picture behind a shape, as the user sets it."""

from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING

from starskel.files.projects.picture import Picture
from starskel.task import Task

if TYPE_CHECKING:  # what traces is loaded by the worker, so that the window opens sooner
    from starskel import Shape
    from starskel.images.placed import PlacedImage
    from starskel.images.tracing import By

LEVEL = 0.5
"""Where nobody says so: half opaque, or half as bright as white."""


@dataclass(frozen=True)
class TraceSettings:
    """What is to be traced, and how much of it.

    Attributes
    ----------
    by : {"alpha", "dark", "light"} or None
        None for what suggests itself.
    level : float
        From 0 to 1.
    tolerance : float
        How far the outline may be from the contour, in pixels of the picture.
    several, holes : bool
        Whether all parts are traced or the largest alone, and whether with their holes.
    """

    by: "By | None" = None
    level: float = LEVEL
    tolerance: float = 1.0
    several: bool = False
    holes: bool = True


@dataclass(frozen=True, eq=False)
class Traced:
    """What was found.

    Attributes
    ----------
    shape : Shape
    by : {"alpha", "dark", "light"}
        What was traced.
    """

    shape: "Shape"
    by: "By"


class Tracer:
    """Traces one picture; its pixels are read once."""

    def __init__(self, picture: Picture) -> None:
        self._picture = picture
        self._placed: PlacedImage | None = None

    def trace(self, settings: TraceSettings, task: Task) -> Traced:
        """Trace the picture.

        Raises
        ------
        StarskelError
            If nothing is found, the outline is too rugged, or the picture is damaged.
        Cancelled
            If the task is to stop.
        """
        if self._placed is None:
            self._placed = import_module("starskel.files.image_pairs").placed_image(self._picture)
        assert self._placed is not None
        task.reach(0)
        tracing = import_module("starskel.images.tracing")
        by = settings.by or tracing.usual(self._placed.pixels, settings.level)
        parts = "all" if settings.several else "largest"
        found = tracing.trace(
            self._placed, by, settings.level, settings.tolerance, parts=parts, holes=settings.holes
        )
        task.reach(1)
        return Traced(found, by)
