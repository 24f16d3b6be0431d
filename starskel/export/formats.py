"""The formats, found by what is to be drawn and by the ending of the file's name."""

from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, cast

from starskel.errors import told
from starskel.export.layouts import PICTURES, Layout
from starskel.files.disk import wrong_ending

if TYPE_CHECKING:  # the command's words are known before anything is drawn
    from starskel.export.film import Film
    from starskel.task import Task


class Writer(Protocol):
    """What the module of a format offers."""

    def files(self, film: "Film", task: "Task") -> Iterator[bytes]:
        """Give the content of each file: one, or of numbered formats one for each drawing of the film.

        Equal films give equal bytes.
        """


@dataclass(frozen=True)
class OutputFormat:
    """A format.

    Attributes
    ----------
    name : str
        What people call it; a text that was `told` where it is not the same in every language.
    ending : str
        That of its files' names, with the dot.
    layouts : tuple of Layout
        What it can hold, the usual one first.
    module : str
        The module in this package that is its `Writer`.
    numbered : bool
        Whether each drawing is a file by itself, numbered where there are several.
    """

    name: str
    ending: str
    layouts: tuple[Layout, ...]
    module: str
    numbered: bool = False

    @property
    def writer(self) -> Writer:
        """The module, loaded when it is first used."""
        return cast(Writer, import_module(f"starskel.export.{self.module}"))


FORMATS = (
    OutputFormat("SVG", ".svg", PICTURES, "svg", numbered=True),
    OutputFormat(told("animated SVG"), ".svg", ("animation",), "svg_animation"),
    OutputFormat("EPS", ".eps", PICTURES, "eps", numbered=True),
    OutputFormat("PostScript", ".ps", ("frames", "row", "sheet"), "postscript"),
    OutputFormat("PDF", ".pdf", ("frames", "row", "sheet"), "pdf"),
    OutputFormat("PNG", ".png", PICTURES, "png", numbered=True),
    OutputFormat("GIF", ".gif", ("animation",), "gif"),
    OutputFormat("APNG", ".apng", ("animation",), "apng"),
    OutputFormat("WebP", ".webp", ("animation",), "webp"),
    OutputFormat("MP4", ".mp4", ("animation",), "mp4"),
    OutputFormat("Lottie", ".json", ("animation",), "lottie"),
    OutputFormat("JSON", ".json", ("numbers",), "frames"),
    OutputFormat("CSV", ".csv", ("numbers",), "table"),
)


def formats_of(layout: Layout, numbered: bool | None = None) -> tuple[OutputFormat, ...]:
    """Give the formats that can hold a layout, only those that are numbered or are not."""
    return tuple(found for found in FORMATS if layout in found.layouts and numbered in (None, found.numbered))


def endings_of(layout: Layout) -> tuple[str, ...]:
    """Give the endings of the formats that can hold a layout, the usual one first."""
    return tuple(found.ending for found in formats_of(layout))


def layouts_of(path: Path) -> tuple[Layout, ...]:
    """Give what a file of this name can hold, the usual one first; numbers before pictures that move.

    Raises
    ------
    InvalidFile
        If no format has its ending.
    """
    own = [layout for found in FORMATS if found.ending == path.suffix.lower() for layout in found.layouts]
    if not own:
        raise wrong_ending(path, tuple(dict.fromkeys(found.ending for found in FORMATS)))
    return tuple(sorted(own, key=lambda layout: layout == "animation"))


def format_for(path: Path, layout: Layout) -> OutputFormat:
    """Give the format of a file.

    Raises
    ------
    InvalidFile
        If its ending does not go with the layout.
    """
    for found in FORMATS:
        if found.ending == path.suffix.lower() and layout in found.layouts:
            return found
    raise wrong_ending(path, endings_of(layout))
