"""Pictures looked up with care, for what is kept.

Between two levels of the pyramid colours are mixed, so that sharpness changes gradually; where a triangle is
squeezed one way only, several places along the longer axis are looked up at the level of the shorter one, so
that nothing flickers and nothing is blurred the other way.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from starskel.arrays import Floats, Indices
from starskel.images.compositing import Colours, unmultiplied
from starskel.images.lookup import BATCH, Layer
from starskel.images.spans import Spans
from starskel.rings import blocks


class Precise:
    """Pixels as rows of four numbers."""

    def blank(self, count: int) -> Colours:
        """Give so many transparent pixels."""
        return np.zeros((count, 4), dtype=np.float32)

    def paint(self, image: Colours, spans: Spans, layers: Sequence[Layer], share: float) -> None:
        """Set the pixels of runs, in their order, the second picture counting by a share of 1."""
        ends = np.cumsum(spans.counts)
        before = ends - spans.counts
        for run in blocks(spans.counts, BATCH):
            owners = np.repeat(np.arange(run.start, run.stop), spans.counts[run])
            at = np.arange(before[run.start], ends[run.stop - 1]) - before[owners]
            looked = [_looked_up(layer, spans, owners, at) for layer in layers]
            mixed = looked[0] if len(looked) == 1 else (1 - share) * looked[0] + share * looked[1]
            image[spans.first[owners] + at] = mixed

    def colours(self, image: Colours, pixels: Indices) -> Colours:
        """Give the colours of some pixels."""
        return np.asarray(image[pixels])

    def put(self, image: Colours, pixels: Indices, colours: Colours) -> None:
        """Set the colours of some pixels."""
        image[pixels] = colours

    def premultiplied(self, image: Colours) -> NDArray[np.uint8]:
        """Give all pixels in bytes, (p, 4), colours times alpha."""
        return np.rint(image).astype(np.uint8)

    def straight(self, image: Colours) -> NDArray[np.uint8]:
        """Give all pixels in bytes, (p, 4), with straight alpha."""
        return np.rint(unmultiplied(image)).astype(np.uint8)


def _looked_up(layer: Layer, spans: Spans, owners: Indices, at: Indices) -> Colours:
    """Look up along the longer axes of footprints, for pixels of runs."""
    prints, triangles = layer.footprints, spans.triangles[owners]
    x, y = (
        spans.start[column][owners] + at * spans.step[column][owners]
        for column in (layer.column, layer.column + 1)
    )
    counts = prints.probes[triangles]
    levels = np.log2(np.maximum(prints.long / prints.probes, 1.0))[triangles]
    along = (prints.long * prints.along)[triangles]
    colours = np.zeros((len(x), 4), dtype=np.float32)
    for probe in range(counts.max(initial=0)):
        some = np.flatnonzero(counts > probe)
        away = (probe + 0.5) / counts[some] - 0.5
        place = x[some] + away * along[some].real, y[some] + away * along[some].imag
        colours[some] += _mixed(layer, levels[some], *place) / counts[some, None]
    return colours


def _mixed(layer: Layer, levels: Floats, x: Floats, y: Floats) -> Colours:
    """Mix two levels."""
    most = layer.pyramid.levels - 1
    lower = np.minimum(np.floor(levels), most).astype(np.intp)
    share = np.minimum(levels, most) - lower
    colours = _bilinear(layer, lower, x, y)
    some = np.flatnonzero(share > 0)
    if len(some):
        upper = _bilinear(layer, lower[some] + 1, x[some], y[some])
        colours[some] += share[some, None].astype(np.float32) * (upper - colours[some])
    return colours


def _bilinear(layer: Layer, levels: Indices, x: Floats, y: Floats) -> Colours:
    """Look up in a level each; places beyond its border are held at it."""
    pyramid, scale = layer.pyramid, layer.pyramid.scales[levels]
    strides, heights = pyramid.strides[levels], pyramid.heights[levels]
    x, y = (x * scale + 0.5).clip(0, strides - 1), (y * scale + 0.5).clip(0, heights - 1)
    column = np.minimum(x.astype(np.intp), strides - 2)
    row = np.minimum(y.astype(np.intp), heights - 2)
    right, down = ((x - column).astype(np.float32)[:, None], (y - row).astype(np.float32)[:, None])
    place = pyramid.offsets[levels] + row * strides + column
    upper, lower = (
        first + right * (second - first)
        for first, second in (
            (pyramid.texels[corner], pyramid.texels[corner + 1]) for corner in (place, place + strides)
        )
    )
    return np.asarray(upper + down * (lower - upper))
