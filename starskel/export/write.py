"""Write a film: the one way out, for the editor, the command and scripts."""

from pathlib import Path

from starskel.export.film import Film
from starskel.export.formats import format_for
from starskel.export.settings import Settings
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

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import mkdtemp
    >>> import starskel
    >>> from starskel.export.film import Film, Scene, Track
    >>> from starskel.export.settings import Settings, even_times
    >>> square, kite = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (3, 2), (1, 5), (-1, 2)]
    >>> scene = Scene(starskel.blend(square, kite, marks=[(0, 0)]))
    >>> film = Film("Kite", (Track("stitched", (scene,)),), Settings("frames", even_times(3)))
    >>> [path.name for path in write(Path(mkdtemp()) / "kite.svg", film)]
    ['kite-0001.svg', 'kite-0002.svg', 'kite-0003.svg']
    """
    paths = paths_of(path, film.settings)
    contents = format_for(path, film.settings.layout).writer.files(film, task)
    for own, content in zip(paths, contents, strict=True):
        write_bytes(own, content)
    task.reach(1)
    return paths


def paths_of(path: Path, settings: Settings) -> tuple[Path, ...]:
    """Give the files that `write` writes where a film goes to a path, with these settings.

    Raises
    ------
    InvalidFile
        If the ending does not go with the layout.
    """
    count = len(settings.times)
    if settings.layout != "frames" or count == 1 or not format_for(path, settings.layout).numbered:
        return (path,)
    return tuple(path.with_name(f"{path.stem}-{number:04}{path.suffix}") for number in range(1, count + 1))
