"""PNG out: each drawing as a picture."""

from collections.abc import Iterator

from starskel.export.film import Film
from starskel.export.pixels import pixels_of
from starskel.files.raster_writing import png_of
from starskel.task import Task


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give each drawing as a file."""
    for drawing in film.drawings(pictured=True):
        task.reach(0)
        yield png_of(pixels_of(drawing, film.settings.pixels))
