"""One part of a shape with its pictures, and a frame of it ready to be painted."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.images.carriers import Carrier
from starskel.images.coverage import Coverage, coverage_of
from starskel.images.lookup import Layer, footprints
from starskel.images.placed import PlacedImage
from starskel.images.pyramid import Pyramid, pyramid_of
from starskel.images.spans import Spans, spans_of
from starskel.polar import as_complex


@dataclass(frozen=True)
class Seen:
    """What of a morph is asked for.

    Attributes
    ----------
    t : float
    size : (int, int)
        Width and height in pixels.
    view : (float, float, float, float)
        Left, bottom, right and top in the document.
    share : float
        How much of the target's picture is seen.
    """

    t: float
    size: tuple[int, int]
    view: tuple[float, float, float, float]
    share: float

    def places(self, points: Floats) -> Floats:
        """Give where (..., 2) points are in the image, in pixels, right and down."""
        left, bottom, right, top = self.view
        width, height = self.size
        scale = np.array([width / (right - left), -height / (top - bottom)])
        return np.asarray((points - (left, top)) * scale)


@dataclass(frozen=True, eq=False)
class Frame:
    """A part at one t.

    Attributes
    ----------
    spans : Spans
        Of the pixels at the outline, then of the triangles, those that are folded over first.
    layers : tuple of Layer
        The pictures that are seen, one or both.
    coverage : Coverage
    folded : bool
        Whether a triangle is folded over: then what is painted may reach beyond the outline.
    """

    spans: Spans
    layers: tuple[Layer, ...]
    coverage: Coverage
    folded: bool


@dataclass(frozen=True, eq=False)
class PicturedPart:
    """A part of a shape with its pictures.

    Attributes
    ----------
    carrier : Carrier
    source, target : Pyramid or None
    beside : (n,) array of int
        The triangle at each edge of the outline.
    """

    carrier: Carrier
    source: Pyramid | None
    target: Pyramid | None
    beside: Indices

    def outline_at(self, t: float) -> Floats:
        """Give the (n, 2) points of the outline, in the document."""
        nodes: Floats = self.carrier.nodes_at(t)[self.carrier.edges[:, 0]]
        return nodes

    def frame(self, seen: Seen) -> Frame | None:
        """Give the part at one t; None where none of its pictures is there."""
        pictures = self._pictures(seen.share)
        if not pictures:
            return None
        places = seen.places(self.carrier.nodes_at(seen.t))
        turns = _turns(places, self.carrier.triangles)
        order = np.argsort(turns <= 0, kind="stable")
        triangles = self.carrier.triangles[order]
        values = np.concatenate([picture.nodes for picture in pictures], axis=1)
        starts, ends = self.carrier.edges.T
        coverage = coverage_of(places[starts], places[ends], seen.size)
        inner = spans_of(places, triangles, values, seen.size)
        rim = self._rim(coverage, values, np.argsort(order))
        layers = tuple(
            Layer(picture, footprints(places, picture.nodes, triangles), 2 * number)
            for number, picture in enumerate(pictures)
        )
        folded = bool((inner.triangles < np.count_nonzero(turns > 0)).any())
        return Frame(_joined(rim, inner), layers, coverage, folded)

    def _pictures(self, share: float) -> Sequence[Pyramid]:
        if self.source is None or self.target is None or share in (0, 1):
            wanted = (self.target, self.source) if share == 1 else (self.source, self.target)
            return [picture for picture in wanted if picture is not None][:1]
        return [self.source, self.target]

    def _rim(self, coverage: Coverage, values: Floats, ranks: Indices) -> Spans:
        """Give the pixels at the outline as runs of one each, looked up on the outline itself."""
        starts, ends = values[self.carrier.edges[coverage.edges]].transpose(1, 2, 0)
        start = starts + coverage.places * (ends - starts)
        return Spans(
            ranks[self.beside[coverage.edges]],
            coverage.pixels,
            np.ones(len(coverage.pixels), dtype=np.intp),
            start,
            np.zeros_like(start),
        )


def part_of(
    carrier: Carrier, source: PlacedImage | None, target: PlacedImage | None, solid: int = 0
) -> PicturedPart:
    """Prepare the pictures of a part; `solid` as for `pyramid_of`."""
    pyramids = [
        pyramid_of(image, carrier.nodes_at(t), carrier.triangles, solid) if image and there else None
        for image, there, t in ((source, carrier.in_source, 0.0), (target, carrier.in_target, 1.0))
    ]
    return PicturedPart(carrier, pyramids[0], pyramids[1], _beside(carrier))


def _beside(carrier: Carrier) -> Indices:
    """Give for each edge of the outline its triangle."""
    count = int(carrier.triangles.max()) + 1
    keys = (carrier.triangles * count + np.roll(carrier.triangles, -1, axis=1)).ravel()
    order = np.argsort(keys)
    wanted = carrier.edges[:, 0] * count + carrier.edges[:, 1]
    return np.asarray(order[np.searchsorted(keys[order], wanted)] // 3)


def _turns(places: Floats, triangles: Indices) -> Floats:
    """Give twice the areas of triangles in an image, negative for those that are not folded over."""
    z = as_complex(places)[triangles]
    return np.asarray(((z[:, 1] - z[:, 0]).conj() * (z[:, 2] - z[:, 0])).imag)


def _joined(first: Spans, second: Spans) -> Spans:
    return Spans(
        np.concatenate([first.triangles, second.triangles]),
        np.concatenate([first.first, second.first]),
        np.concatenate([first.counts, second.counts]),
        np.concatenate([first.start, second.start], axis=1),
        np.concatenate([first.step, second.step], axis=1),
    )
