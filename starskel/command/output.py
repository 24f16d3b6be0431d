"""From drawings to the file that the user asked for: the ending of its name tells the format."""

from collections.abc import Callable
from pathlib import Path

from starskel.errors import InvalidFile
from starskel.files.postscript import write_eps, write_postscript
from starskel.files.svg import write_svg
from starskel.sheet.drawing import Drawing

WRITERS: dict[str, Callable[[Path, Drawing], None]] = {
    ".svg": write_svg,
    ".eps": write_eps,
    ".ps": lambda path, drawing: write_postscript(path, [drawing]),
}


def ending_of(path: Path, known: tuple[str, ...]) -> str:
    """Give the ending of a file's name, in lower case.

    Raises
    ------
    InvalidFile
        If it is not one of those known.
    """
    ending = path.suffix.lower()
    if ending not in known:
        raise InvalidFile(f'{path} ends in "{path.suffix}"', "end it in " + ", ".join(known))
    return ending
