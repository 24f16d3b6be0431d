"""A picture made ready to be looked up: at every size, and never with colours from outside the shape.

Each level of the pyramid has the area means of two by two texels of the one below (Williams 1983, "Pyramidal
parametrics"). Texels outside the shape do not count; afterwards they get the colours of the nearest coarser
texel that has some, from the coarsest level down. So what is looked up at the outline is the inside's.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_erosion

from starskel.arrays import Flags, Floats, Indices
from starskel.images.placed import PlacedImage
from starskel.images.spans import spans_of

Texels = NDArray[np.float32]

Packed = NDArray[np.uint64]

_MARGIN = 2
"""Texels kept round the shape."""

_LEAST = np.float32(np.finfo(np.float32).tiny)
"""Where nothing lies inside, nothing is divided by this."""

_BEYOND = 2
"""What lies outside the picture is empty; so many times its size is kept of it on each side."""


@dataclass(frozen=True, eq=False)
class Pyramid:
    """All levels of a picture in one array.

    Attributes
    ----------
    texels : (p, 4) array of float32
        Premultiplied colours and alpha, from 0 to 255: level after level, row by row, each level with its
        border repeated once.
    offsets, strides : (l,) arrays of int
        Where levels begin, and how long their rows are, borders included.
    heights : (l,) array of int
        How many rows they have, borders included.
    nodes : (m, 2) array
        The nodes of the mesh in texels of the first level, right and down from its corner.
    """

    texels: Texels
    offsets: Indices
    strides: Indices
    heights: Indices
    nodes: Floats

    @cached_property
    def packed(self) -> Packed:
        """The texels as one number each, four channels of 16 bits."""
        return packed(self.texels)

    @property
    def levels(self) -> int:
        """How many levels there are."""
        return len(self.offsets)

    @cached_property
    def scales(self) -> Floats:
        """How large each level is, as a part of the first: a table, as powers take as long as looking up."""
        return np.asarray(0.5 ** np.arange(self.levels))


def packed(colours: Texels) -> Packed:
    """Give (p, 4) colours from 0 to 255 as (p,) numbers of four channels of 16 bits."""
    return np.rint(colours).astype(np.uint16).view(np.uint64)[:, 0]


def pyramid_of(image: PlacedImage, nodes: Floats, triangles: Indices, solid: int = 0) -> Pyramid:
    """Prepare a picture for the shape that a mesh tiles.

    Parameters
    ----------
    image : PlacedImage
    nodes : (m, 2) array
        In the document.
    triangles : (k, 3) array of int
    solid : int
        So near to the outline, in texels, what is not opaque counts as outside.
    """
    places = image.to_picture(nodes)
    corner, texels = _cropped(image, places)
    places = places - corner
    inside = _inside(places, triangles, texels.shape)
    if solid:
        deep = binary_erosion(inside, iterations=solid, border_value=1)
        inside &= deep | (texels[:, :, 3] == 255)
    if not inside.any():  # all of the shape lies between the middles of texels
        inside[:] = True
    levels = _filled(_shrunk(texels, inside))
    bordered = [np.pad(level, ((1, 1), (1, 1), (0, 0)), mode="edge") for level in levels]
    sizes = np.array([level.shape[:2] for level in bordered], dtype=np.intp)
    counts = sizes.prod(axis=1)
    rows = np.concatenate([level.reshape(-1, 4) for level in bordered])
    return Pyramid(rows, np.cumsum(counts) - counts, sizes[:, 1], sizes[:, 0], places)


def _cropped(image: PlacedImage, places: Floats) -> tuple[Floats, Texels]:
    """Give the part of a picture round places in it, premultiplied, and its corner; outside it is empty."""
    size = np.array(image.pixels.shape[1::-1])
    # outlines often lie on whole texels, and rounding must not decide: hence the thirds
    low = np.floor(places.min(axis=0) - 1 / 3).clip(-_BEYOND * size, size) - _MARGIN
    high = np.ceil(places.max(axis=0) + 1 / 3).clip(low + 1, (_BEYOND + 1) * size) + _MARGIN
    (x0, y0), (x1, y1) = low.astype(np.intp), high.astype(np.intp)
    texels = np.zeros((y1 - y0, x1 - x0, 4), dtype=np.float32)
    seen = image.pixels[max(y0, 0) : max(y1, 0), max(x0, 0) : max(x1, 0)]
    texels[max(-y0, 0) :, max(-x0, 0) :][: seen.shape[0], : seen.shape[1]] = seen
    texels[:, :, :3] *= texels[:, :, 3:] / np.float32(255)
    return low, texels


def _inside(places: Floats, triangles: Indices, shape: tuple[int, ...]) -> Flags:
    """Tell of which texels the middle lies in the mesh."""
    height, width = shape[:2]
    spans = spans_of(places, triangles, np.empty((len(places), 0)), (width, height))
    changes = np.bincount(spans.first, minlength=height * width + 1)
    changes -= np.bincount(spans.first + spans.counts, minlength=height * width + 1)
    return np.asarray(np.cumsum(changes)[:-1].reshape(height, width) > 0)


Level = tuple[Texels, NDArray[np.float32]]
"""Colours, and how much of each texel lies inside."""


def _shrunk(texels: Texels, inside: Flags) -> list[Level]:
    """Take means until one texel is left."""
    levels = [(texels, inside.astype(np.float32)[:, :, None])]
    while max(levels[-1][0].shape[:2]) > 1:
        finer, weights = levels[-1]
        total = _sums(weights)
        means = np.divide(_sums(finer * weights), np.maximum(total, _LEAST), dtype=np.float32)
        levels.append((means, np.multiply(total, 0.25, dtype=np.float32)))
    return levels


def _sums(values: NDArray[np.float32]) -> NDArray[np.float32]:
    """Add two by two; where a row or column is left over it is added alone."""
    height, width = values.shape[:2]
    even = np.pad(values, ((0, height % 2), (0, width % 2), (0, 0)))
    rows = even[::2] + even[1::2]
    return np.asarray(rows[:, ::2] + rows[:, 1::2])


def _filled(levels: list[Level]) -> list[Texels]:
    """Give texels without weight the colours of those that they belong to on the next level."""
    filled = [levels[-1][0]]
    for texels, weights in levels[-2::-1]:
        height, width = texels.shape[:2]
        above = np.repeat(np.repeat(filled[-1], 2, axis=0), 2, axis=1)[:height, :width]
        filled.append(np.where(weights > 0, texels, above))
    return filled[::-1]
