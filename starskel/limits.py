"""Limits: what is larger is refused, before memory is taken for it.

They are far above what people draw. Of hostile files they leave so little that each is read or refused
within seconds and half a gigabyte. The largest coordinate is `predicates.LARGEST`, on which no
memory depends.
"""

from collections import Counter

from starskel.errors import InvalidFile, StarskelError, told

DOCUMENT_BYTES = 200_000_000
"""A project or a file of pairs: most of it may be pictures."""

DOCUMENT_VALUES = 3_000_000
"""Numbers, texts, lists and objects of a JSON document: a vertex counts three."""

DOCUMENT_RINGS = 20_000
"""Rings of a project, or of a pair of a file."""

DRAWING_BYTES = 20_000_000
"""An SVG, GeoJSON or WKT file."""

DRAWING_TAGS = 500_000
"""Tags and attributes of an SVG file."""

DRAWING_LETTERS = 3_000_000
"""Letters of the attributes and style sheets of an SVG file that say what is drawn, those included that `use`
repeats; those of transforms count for each element that they move."""

DRAWING_NUMBERS = 140_000
"""Numbers and commands of the paths of an SVG file."""

DRAWING_VALUES = 750_000
"""Values of a GeoJSON file, words of a WKT file: a vertex counts three in GeoJSON."""

DRAWING_VERTICES = 250_000
"""Vertices, and brackets, of a WKT file."""

DRAWING_SHAPES = 2_000
"""Geometries of a WKT file, features of a GeoJSON file, elements, subpaths and rules of an SVG file, those
included that `use` repeats. Each is checked and mended on its own."""

DRAWING_RINGS = 3_000
"""Rings of all shapes of a drawing, those included that crossings cut off."""

DEPTH = 200
"""How deep elements of an SVG file, and brackets of a WKT file, may be nested."""

CROSSINGS = 5_000
"""How often rings of one shape may cross, in all shapes of a drawing: each is mended."""

OVERLAPS = 100_000
"""Pairs of rings of one shape whose boxes overlap, in all shapes of a drawing: each pair is looked at."""

EDGES = 2_000_000
"""Pairs of edges of one shape whose boxes overlap, in all shapes of a file: each pair is looked at."""

RING_VERTICES = 100_000
"""Vertices of a ring of a file."""

ALIGNED_PAIRS = 400_000_000
"""Pairs of vertices, one of each shape between two marks, that are compared: each takes a byte."""

DECOMPOSED_VERTICES = 10_000
"""Vertices of a pair, those that the correspondence inserted included, that is cut into several pieces: any
two take some 30 bytes. Those on straight runs of both polygons do not count."""

PICTURE_BYTES = 200_000_000
"""A file of a picture."""

PICTURE_PIXELS = 26_000_000
"""Pixels of a picture in memory: larger ones are read at a half, a third, ... of their size."""

WHOLE_PIXELS = 52_000_000
"""Pixels of a picture that is decoded whole before it is made smaller."""

JPEG_PIXELS = 104_000_000
"""Pixels of a picture that can be decoded smaller."""

DRAWN_PIXELS = 50_000_000
"""Pixels of a picture that is written."""

MOVING_PIXELS = 250_000_000
"""Pixels of all frames of an animation that is written: they are in memory together, some twice."""

PICTURE_SIDE = 16_384
"""Pixels of each side of a picture: coordinates in it are kept in 16 bits and a fraction."""

TRACED_SIDE = 2048
"""Pictures of more pixels a side are traced at a half, a third, ... of their size."""

TRACED_PLACES = 300_000
"""Vertices of an outline as the pixels have it."""

TRACED_VERTICES = 20_000
"""Vertices of an outline once it is simplified."""


def check_limit(name: str, what: str, count: int, most: int) -> None:
    """Refuse what there is too much of.

    Parameters
    ----------
    name : str
        What errors call the file.
    what : str
        What is counted, in the plural.
    count, most : int

    Raises
    ------
    InvalidFile
        Naming the limit and the value.
    """
    if count > most:
        raise InvalidFile(
            told("{name} has {count} {what}", name=name, count=count, what=what),
            told("give a file with at most {most} {what}", most=most, what=what),
        )


class Tally:
    """What the shapes of one file come to while they are made: all together are held to the limits.

    Parameters
    ----------
    name : str
        What errors call the file.
    """

    def __init__(self, name: str) -> None:
        self._name = name
        self._counts: Counter[str] = Counter()

    def add(self, what: str, count: int, most: int) -> None:
        """Count so many more, of at most so many.

        Raises
        ------
        InvalidFile
            As `check_limit` does.
        """
        self._counts[what] += count
        check_limit(self._name, what, self._counts[what], most)


def check_size(what: str, count: int, most: int, mend: str) -> None:
    """Refuse to compute what would take too much memory.

    Parameters
    ----------
    what : str
        What is counted, in the plural.
    count, most : int
    mend : str
        What to do about it.

    Raises
    ------
    StarskelError
        Naming the limit and the value.
    """
    if count > most:
        raise StarskelError(
            told("{count} {what}, and at most {most}", count=count, what=what, most=most), mend
        )
