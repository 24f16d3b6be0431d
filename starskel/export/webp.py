"""WebP out: an animation in full colours, with smooth edges on any ground, smaller than APNG."""

from collections.abc import Iterator

from starskel.export.film import Film
from starskel.export.pixels import durations, moving
from starskel.files.raster_writing import animation_of
from starskel.task import Task


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give the film as one file, which plays over and over."""
    yield animation_of(".webp", moving(film, task), durations(film))
