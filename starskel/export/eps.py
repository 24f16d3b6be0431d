"""EPS out: each drawing as a file that a page can include."""

from collections.abc import Iterator

from starskel.export.film import Film
from starskel.export.postscript import eps_text
from starskel.task import Task


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give each drawing as a file."""
    for drawing in film.drawings():
        task.reach(0)
        yield eps_text(drawing).encode("ascii")
