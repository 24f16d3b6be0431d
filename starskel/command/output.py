"""From drawings to the file that the user asked for: the ending of its name tells the format."""

from argparse import Namespace
from collections.abc import Callable, Sequence
from pathlib import Path

from starskel.errors import InvalidFile
from starskel.files.postscript import write_eps, write_postscript
from starskel.files.svg import write_svg
from starskel.sheet.drawing import Drawing
from starskel.sheet.keyframe import Keyframe
from starskel.sheet.rows import page_sheets, row_sheet
from starskel.sheet.shape_keyframe import ShapeKeyframe

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


def write_keyframes(
    arguments: Namespace, ending: str, title: str, frames: Sequence[Keyframe | ShapeKeyframe]
) -> None:
    """Write keyframes as the ending and the options ask: in a row, or one on each page."""
    captions = not arguments.plain
    if ending == ".ps":
        write_postscript(arguments.output, page_sheets(title, frames, captions))
    elif len(frames) == 1:
        WRITERS[ending](arguments.output, page_sheets(title, frames, captions)[0])
    else:
        WRITERS[ending](arguments.output, row_sheet(title, frames, captions))
