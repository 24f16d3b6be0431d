"""A picture and where it is: an affine map from its pixels to the document."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from starskel.arguments import finite
from starskel.arrays import Floats
from starskel.errors import StarskelError
from starskel.limits import PICTURE_SIDE
from starskel.polar import as_complex

Pixels = NDArray[np.uint8]
"""(h, w, 4) rows from top to bottom: red, green, blue, and alpha, which is straight."""

SOLID = 2
"""So near to the outlines, in pixels, the command and the editor take pictures as opaque: outlines that were
drawn or traced are not more exact."""


class PlacedImage:
    """A picture in a document.

    Parameters
    ----------
    pixels : (h, w, 4) or (h, w, 3) array of uint8
        Red, green, blue and, where there is one, straight alpha; the top row first.
    placement : (2, 3) array-like, optional
        The affine map that gives the document's x and y of a place (x, y, 1) in the picture, counted in
        pixels to the right and down from the top left corner. By default a pixel is a unit, and the lower
        left corner is the origin.

    Raises
    ------
    StarskelError
        If these are no pixels, too many, or the placement has no area.

    Examples
    --------
    >>> import numpy as np
    >>> import starskel
    >>> grey = np.full((20, 40, 3), 128, dtype=np.uint8)
    >>> starskel.PlacedImage(grey).to_document([(0, 0), (40, 20)]).tolist()
    [[0.0, 20.0], [40.0, 0.0]]
    >>> starskel.PlacedImage.in_box(grey, middle=(1, 1), size=(4, 2)).to_picture((1, 1)).round(6).tolist()
    [20.0, 10.0]
    """

    def __init__(self, pixels: ArrayLike, placement: ArrayLike | None = None) -> None:
        self.pixels: Pixels = _checked_pixels(pixels)
        upright = [[1, 0, 0], [0, -1, len(self.pixels)]]
        self.placement: Floats = _checked_placement(upright if placement is None else placement)

    @classmethod
    def in_box(
        cls, pixels: Pixels, middle: tuple[float, float], size: tuple[float, float], rotation: float = 0.0
    ) -> "PlacedImage":
        """Place a picture by its middle, its width and height, and by how far it is turned about its middle.

        Parameters
        ----------
        pixels : (h, w, 4) or (h, w, 3) array of uint8
        middle, size : (float, float)
            In the document's units.
        rotation : float
            In radians, counter-clockwise.

        Raises
        ------
        StarskelError
            If these are no pixels, or the box no finite numbers or without area.
        """
        (x, y), (across, down) = (finite(middle, 2, "the middle"), finite(size, 2, "the size"))
        (turn,) = finite([rotation], 1, "the rotation")
        height, width = _checked_pixels(pixels).shape[:2]
        return cls(pixels, box_placement((x, y), (across, down), turn) / (width, height, 1))

    def to_document(self, places: ArrayLike) -> Floats:
        """Give where (..., 2) places in the picture are in the document."""
        return np.asarray(np.asarray(places) @ self.placement[:, :2].T + self.placement[:, 2])

    def to_picture(self, points: ArrayLike) -> Floats:
        """Give where in the picture (..., 2) points of the document are, in pixels, right and down."""
        moved = as_complex(np.asarray(points) - self.placement[:, 2])
        (a, b), (c, d) = self.placement[:, :2]
        doubled = a * d - b * c
        return np.stack(
            [(d * moved.real - b * moved.imag) / doubled, (a * moved.imag - c * moved.real) / doubled],
            axis=-1,
        )


def box_placement(middle: tuple[float, float], size: tuple[float, float], rotation: float = 0.0) -> Floats:
    """Give the map, (2, 3), from shares of a picture's width to the right and height down to the document.

    `middle`, `size` and `rotation` as for `PlacedImage.in_box`.
    """
    right, down = np.exp(1j * rotation) * size[0], -1j * np.exp(1j * rotation) * size[1]
    columns = np.array([right, down, complex(*middle) - (right + down) / 2])
    return np.stack([columns.real, columns.imag])


def _checked_pixels(given: ArrayLike) -> Pixels:
    try:
        pixels = np.asarray(given)
    except ValueError:  # rows of different lengths
        pixels = np.empty(0)
    if pixels.dtype != np.uint8 or pixels.ndim != 3 or pixels.shape[2] not in (3, 4) or not pixels.size:
        raise StarskelError(
            f"a picture of shape {pixels.shape} and type {pixels.dtype}",
            "give an array of shape (h, w, 4) or (h, w, 3) of uint8",
        )
    if max(pixels.shape) > PICTURE_SIDE:
        height, width = pixels.shape[:2]
        raise StarskelError(
            f"a picture of {width} × {height} pixels",
            f"scale it down to at most {PICTURE_SIDE} pixels a side",
        )
    if pixels.shape[2] == 3:
        return np.concatenate([pixels, np.full((*pixels.shape[:2], 1), 255, dtype=np.uint8)], axis=2)
    return pixels


def _checked_placement(given: ArrayLike) -> Floats:
    try:
        matrix = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError):
        matrix = np.empty(0)
    if matrix.shape != (2, 3) or not np.isfinite(matrix).all() or not np.linalg.det(matrix[:, :2]):
        raise StarskelError(
            f"the placement {given!r} of a picture",
            "give an affine map, two rows of three finite numbers, that keeps an area",
        )
    return matrix
