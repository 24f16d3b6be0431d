"""Pictures in: silhouettes of what is opaque, or dark on a light ground, or light on a dark one."""

from starskel.errors import InvalidFile, StarskelError, told
from starskel.files.raster import decoded
from starskel.images.tracing import By, trace, usual
from starskel.reading.named_shape import NamedShape, Reading
from starskel.reading.wanted import Wanted

_LEAST = 1.0
"""Outlines leave contours by so many pixels at least, else they would show the steps between pixels."""

_TRACED: dict[By, str] = {
    "alpha": told("what is opaque was traced"),
    "dark": told("what is dark was traced"),
    "light": told("what is light was traced"),
}


def read(content: bytes, wanted: Wanted) -> Reading:
    """Give what is seen in a picture as one shape with all its parts and holes, in pixels, y up.

    Raises
    ------
    InvalidFile
        If it is no picture, damaged or too large, or nothing stands out in it.
    """
    picture = decoded(content).placed
    tolerance = max(_LEAST, wanted.tolerance * max(picture.pixels.shape))
    try:
        shape = trace(picture, tolerance=tolerance, parts="all")
    except StarskelError as error:
        raise InvalidFile(error.what, error.mend) from error
    return Reading((NamedShape(told("silhouette"), shape, (_TRACED[usual(picture.pixels)],)),))
