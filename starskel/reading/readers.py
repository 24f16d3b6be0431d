"""The readers, found by the ending of a file's name."""

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Protocol, cast

from starskel.errors import InvalidFile, either, told
from starskel.files.disk import read_bytes
from starskel.reading.named_shape import Reading
from starskel.reading.wanted import TOLERANCE, Wanted


class Reader(Protocol):
    """What the module of a format offers."""

    def read(self, content: bytes, wanted: Wanted) -> Reading:
        """Give the shapes in a file's content.

        Raises
        ------
        InvalidFile
            If it is damaged or of another format.
        """


@dataclass(frozen=True)
class InputFormat:
    """A format that shapes are read from: its name, the endings of its files, its module in this package."""

    name: str
    endings: tuple[str, ...]
    module: str

    @property
    def reader(self) -> Reader:
        """The module, loaded when it is first used."""
        return cast(Reader, import_module(f"starskel.reading.{self.module}"))


FORMATS = (
    InputFormat("SVG", (".svg",), "svg"),
    InputFormat("GeoJSON", (".geojson",), "geojson"),
    InputFormat("WKT", (".wkt",), "wkt"),
    InputFormat(told("picture"), (".png", ".jpg", ".jpeg", ".webp", ".bmp", ".gif"), "silhouette"),
    InputFormat(told("font"), (".ttf", ".otf", ".ttc"), "font"),
)

ENDINGS = tuple(ending for found in FORMATS for ending in found.endings)


def read_shapes(path: Path, tolerance: float = TOLERANCE, texts: Sequence[str] = ()) -> Reading:
    """Read the shapes of a drawing or a map, the silhouette in a picture, or letters of a font.

    Parameters
    ----------
    path : Path
        The ending of its name tells the format.
    tolerance : float
        How far lines may leave curves, as a part of the longer side of a shape's box.
    texts : sequence of str
        Of a font each of these texts is a shape; by default its usual letters.

    Returns
    -------
    Reading
        At least one shape, in the file's order, and what was mended.

    Raises
    ------
    InvalidFile
        If it cannot be read, is damaged, or holds no shape.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import mkdtemp
    >>> from starskel.reading.readers import read_shapes
    >>> path = Path(mkdtemp()) / "frame.wkt"
    >>> _ = path.write_text("POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 6 6, 2 6, 2 2))")
    >>> (found,) = read_shapes(path).shapes
    >>> found.name, found.shape
    ('shape 1', Shape of 1 part with 1 hole)
    """
    format_of(path)  # refuses before anything is read
    return read_content(read_bytes(path), path, tolerance, texts)


def read_content(
    content: bytes, path: Path, tolerance: float = TOLERANCE, texts: Sequence[str] = ()
) -> Reading:
    """Read the shapes that the content of a file holds, wherever it comes from, as `read_shapes` does.

    Parameters
    ----------
    content : bytes
    path : Path
        What errors call it; the ending tells the format.
    tolerance, texts
        As there.

    Raises
    ------
    InvalidFile
        If it is damaged, or holds no shape.
    """
    found = format_of(path)
    try:
        reading = found.reader.read(content, Wanted(tolerance, tuple(texts)))
    except InvalidFile as error:
        raise error.within(path) from error
    if not reading.shapes:
        raise InvalidFile(
            told("{path} holds no shape", path=path),
            told("give a file with at least one closed outline"),
        )
    return reading


def format_of(path: Path) -> InputFormat:
    """Give the format of a file by the ending of its name.

    Raises
    ------
    InvalidFile
        If no format has it.
    """
    found = next((own for own in FORMATS if path.suffix.lower() in own.endings), None)
    if found is None:
        raise InvalidFile(
            told('{name} ends in "{ending}"', name=path.name, ending=path.suffix),
            told("give a file that ends in {endings}", endings=either(ENDINGS)),
        )
    return found
