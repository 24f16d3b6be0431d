"""Pictures looked up fast, for what moves on a screen.

A texel is one number of 64 bits, four channels of 16 bits each. Weights are whole numbers that sum up to 256,
so a product with 8 bits of colour never flows over into the next channel, and one multiplication weighs all
four. The level of the pyramid is the nearest one. Colours are off by a level or two of 255.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from starskel.arrays import Indices
from starskel.images.compositing import unmultiplied
from starskel.images.lookup import BATCH, Layer
from starskel.images.pyramid import Packed, packed
from starskel.images.spans import Spans
from starskel.rings import blocks

_HALF, _EIGHT = np.uint16(128), np.uint16(8)


class Preview:
    """Pixels as numbers of 64 bits."""

    def blank(self, count: int) -> Packed:
        """Give so many transparent pixels."""
        return np.zeros(count, dtype=np.uint64)

    def paint(self, image: Packed, spans: Spans, layers: Sequence[Layer], share: float) -> None:
        """Set the pixels of runs, in their order, the second picture counting by a share of 1."""
        weight = np.uint64(round(256 * share))
        ways = [_Way.of(layer, spans) for layer in layers]
        ends = np.cumsum(spans.counts)
        before = ends - spans.counts
        for run in blocks(spans.counts, BATCH):
            counts = spans.counts[run]
            at = np.arange(before[run.start], ends[run.stop - 1]) - np.repeat(before[run], counts)
            colours = [way.colours(run, counts, at.astype(np.float32)) for way in ways]
            if len(colours) == 2:
                colours[0] *= np.uint64(256) - weight
                colours[1] *= weight
                colours[0] += colours[1]
                _divide(colours[0])
            at += np.repeat(spans.first[run], counts)
            image[at] = colours[0]

    def colours(self, image: Packed, pixels: Indices) -> NDArray[np.float32]:
        """Give the colours of some pixels."""
        return _channels(image[pixels]).astype(np.float32)

    def put(self, image: Packed, pixels: Indices, colours: NDArray[np.float32]) -> None:
        """Set the colours of some pixels."""
        image[pixels] = packed(np.minimum(colours, 255))  # a sum of rounded ones may be 256

    def premultiplied(self, image: Packed) -> NDArray[np.uint8]:
        """Give all pixels in bytes, (p, 4), colours times alpha."""
        return _channels(image)

    def straight(self, image: Packed) -> NDArray[np.uint8]:
        """Give all pixels in bytes, (p, 4), with straight alpha."""
        channels = _channels(image)
        alpha = channels[:, 3]
        partly = np.flatnonzero((alpha > 0) & (alpha < 255))
        channels[partly] = np.rint(unmultiplied(channels[partly].astype(np.float32)))
        return channels


def _channels(image: Packed) -> NDArray[np.uint8]:
    return image.view(np.uint16).reshape(-1, 4).astype(np.uint8)


def _divide(colours: Packed) -> None:
    """Divide all channels by 256."""
    channels = colours.view(np.uint16)
    channels += _HALF
    channels >>= _EIGHT


@dataclass(frozen=True, eq=False)
class _Way:
    """Where runs go in the levels of a picture: in 256ths of texels, to the right and down."""

    texels: Packed
    start: Sequence[NDArray[np.float32]]
    step: Sequence[NDArray[np.float32]]
    offsets: NDArray[np.int32]
    strides: NDArray[np.int32]

    @classmethod
    def of(cls, layer: Layer, spans: Spans) -> "_Way":
        pyramid = layer.pyramid
        nearest = np.rint(layer.footprints.levels).clip(0, pyramid.levels - 1).astype(np.intp)
        levels = nearest[spans.triangles]
        if len(levels) and (levels == levels[0]).all():
            levels = levels[0]  # so are offsets and strides one number for all
        last, scale = spans.counts - 1, pyramid.scales[levels]
        starts, steps = [], []
        for axis, sizes in enumerate((pyramid.strides, pyramid.heights)):
            start = spans.start[layer.column + axis] * scale + 0.5  # from middles, past the border
            most = sizes[levels] - (1 + 2**-8)  # a texel further on there is another one
            end = (start + last * (spans.step[layer.column + axis] * scale)).clip(0, most)
            start = start.clip(0, most)
            starts.append((start * 256).astype(np.float32))
            steps.append(((end - start) / np.maximum(last, 1) * 256).astype(np.float32))
        offsets, strides = (each[levels].astype(np.int32) for each in (pyramid.offsets, pyramid.strides))
        return cls(pyramid.packed, starts, steps, offsets, strides)

    def colours(self, run: slice, counts: Indices, at: NDArray[np.float32]) -> Packed:
        """Look up bilinearly the pixels of runs, of so many each, at their numbers in these."""
        column, right = self._place(0, run, counts, at)
        row, down = self._place(1, run, counts, at)
        stride, offset = (
            each if each.ndim == 0 else np.repeat(each[run], counts) for each in (self.strides, self.offsets)
        )
        row *= stride
        row += offset
        row += column
        both = right * down
        both >>= 8
        right -= both
        down -= both
        place = row.astype(np.intp)
        colours = self._taken(place, 256 - right - down - both)
        place += 1
        colours += self._taken(place, right)
        place += stride
        colours += self._taken(place, both)
        place -= 1
        colours += self._taken(place, down)
        _divide(colours)
        return colours

    def _place(
        self, axis: int, run: slice, counts: Indices, at: NDArray[np.float32]
    ) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """Give the texel before each pixel, and how far it is from there to it in 256ths."""
        places = np.repeat(self.step[axis][run], counts)  # several times as fast as take
        places *= at
        places += np.repeat(self.start[axis][run], counts)
        fixed = places.astype(np.int32)
        rest = fixed & 255
        fixed >>= 8
        return fixed, rest

    def _taken(self, place: Indices, weights: NDArray[np.int32]) -> Packed:
        colours = self.texels.take(place, mode="clip")
        colours *= weights.astype(np.uint64)
        return colours
