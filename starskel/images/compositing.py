"""Compositing: pixels kept and painted, fast or with care, and how one part comes to lie over others."""

from collections.abc import Sequence
from typing import Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from starskel.arrays import Indices
from starskel.images.coverage import Coverage
from starskel.images.lookup import Layer
from starskel.images.spans import Spans

Colours = NDArray[np.float32]
"""(p, 4) premultiplied colours and alpha, from 0 to 255."""

Image = TypeVar("Image", bound=NDArray[np.generic])


class Rasterizer(Protocol[Image]):
    """A way to keep pixels, and to paint them: with care (`precise`) or fast (`preview`)."""

    def blank(self, count: int) -> Image:
        """Give so many transparent pixels."""

    def paint(self, image: Image, spans: Spans, layers: Sequence[Layer], share: float) -> None:
        """Set the pixels of runs, in their order, the second picture counting by a share of 1."""

    def colours(self, image: Image, pixels: Indices) -> Colours:
        """Give the colours of some pixels, by their numbers row by row."""

    def put(self, image: Image, pixels: Indices, colours: Colours) -> None:
        """Set the colours of some pixels, by their numbers row by row."""

    def premultiplied(self, image: Image) -> NDArray[np.uint8]:
        """Give all pixels in bytes, (p, 4), colours times alpha."""

    def straight(self, image: Image) -> NDArray[np.uint8]:
        """Give all pixels in bytes, (p, 4), with straight alpha."""


def unmultiplied(colours: Colours) -> Colours:
    """Divide colours by alpha."""
    divided = colours.copy()
    divided[:, :3] *= 255 / np.maximum(colours[:, 3:], np.float32(1 / 255))
    return np.minimum(divided, 255, out=divided)


def trim(rasterizer: Rasterizer[Image], image: Image, coverage: Coverage, *, folded: bool) -> None:
    """Leave of each pixel what lies inside; where nothing is folded over, all but the edges does."""
    if folded:
        outside = np.flatnonzero(~coverage.inside())
        rasterizer.put(image, outside, np.zeros((len(outside), 4), dtype=np.float32))
    pixels = coverage.pixels
    shares = coverage.shares[:, None].astype(np.float32)
    rasterizer.put(image, pixels, rasterizer.colours(image, pixels) * shares)


def lay(
    rasterizer: Rasterizer[Image],
    image: Image,
    covered: NDArray[np.float32],
    front: Image,
    coverage: Coverage,
) -> None:
    """Lay a part over what is there.

    In a pixel that both cover in part, they share it as far as there is room: so no seam is seen where a part
    was cut in two. Only what finds no room lies behind.

    Parameters
    ----------
    rasterizer : Rasterizer
    image : Image
        What is there; changed in place.
    covered : (p,) array
        How much of each pixel is covered so far; changed in place.
    front : Image
        The part, not trimmed.
    coverage : Coverage
        How much of each pixel the part covers.
    """
    shares = coverage.inside().astype(np.float32)
    shares[coverage.pixels] = coverage.shares
    pixels = np.flatnonzero(shares)
    own, there = shares[pixels], covered[pixels]
    colours = rasterizer.colours(front, pixels)
    beside = np.minimum(there, 1 - own)
    seen = beside + (there - beside) * (1 - colours[:, 3] / 255)
    behind = rasterizer.colours(image, pixels)
    behind *= (seen / np.where(there > 0, there, 1))[:, None]
    behind += colours * own[:, None]
    rasterizer.put(image, pixels, behind)
    covered[pixels] = beside + own
