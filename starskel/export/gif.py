"""GIF out: an animation of at most 255 colours a picture; each pixel is either opaque or not there."""

from collections.abc import Iterator

from starskel.export.film import Film
from starskel.export.pixels import durations, moving
from starskel.files.raster_writing import animation_of
from starskel.task import Task


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give the film as one file, which plays over and over."""
    yield animation_of(".gif", moving(film, task), durations(film))
