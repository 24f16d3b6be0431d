"""Write a film: the one way out, for the editor, the command and scripts."""

from pathlib import Path

from starskel.export.film import Film
from starskel.export.formats import format_for
from starskel.files.disk import write_bytes
from starskel.task import UNWATCHED, Task


def write(path: Path, film: Film, task: Task = UNWATCHED) -> tuple[Path, ...]:
    """Write a film, and give the files written; the layout and the ending of the file's name tell the format.

    Where a format holds one drawing a file and there are several, they are numbered: "walk.svg" becomes
    "walk-0001.svg", "walk-0002.svg" and so on.

    Parameters
    ----------
    path : Path
        Where to.
    film : Film
        What.
    task : Task
        Watches it, and may stop it.

    Raises
    ------
    InvalidFile
        If the ending does not go with the layout, or a file cannot be written.
    Cancelled
        If the task is to stop; files written so far stay.
    """
    chosen = format_for(path, film.settings.layout)
    single = not chosen.numbered or film.settings.layout != "frames" or len(film.settings.times) == 1
    written = []
    for number, content in enumerate(chosen.writer.files(film, task), 1):
        own = path if single else path.with_name(f"{path.stem}-{number:04}{path.suffix}")
        write_bytes(own, content)
        written.append(own)
    task.reach(1)
    return tuple(written)
