"""Wanted: how a file is to be read, and what of it where it could give many things."""

from dataclasses import dataclass

TOLERANCE = 0.0005
"""How far lines may leave curves by default, as a part of the longer side of a shape's box."""


@dataclass(frozen=True)
class Wanted:
    """What is wanted of a file; each reader looks at what concerns it.

    Attributes
    ----------
    tolerance : float
        How far lines may leave curves, as a part of the longer side of a shape's box.
    texts : tuple of str
        What is to be set in a font; none leaves the choice to the reader.
    """

    tolerance: float = TOLERANCE
    texts: tuple[str, ...] = ()
