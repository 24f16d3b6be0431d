"""Looking pictures up for runs of pixels: how much smaller they get in a triangle, and at which levels."""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.images.pyramid import Pyramid
from starskel.polar import as_complex

MOST_PROBES = 8
"""So many places are looked up at most along the longer axis of what a pixel covers in a picture."""


_LEAST_AREA = 1e-9
"""Triangles of less than half of this, in pixels, hold the middle of none, all but certainly."""

BATCH = 1 << 15
"""So many pixels are computed together: what they need stays in the processor's cache."""


@dataclass(frozen=True, eq=False)
class Footprints:
    """What a pixel covers of a picture, for each triangle: an ellipse.

    Attributes
    ----------
    long, short : (k,) arrays
        Its axes in texels.
    along : (k,) complex array
        The direction of the longer one, in the picture.
    """

    long: Floats
    short: Floats
    along: Complex

    @property
    def levels(self) -> Floats:
        """The levels whose texels are as large as the footprints, the mean of both axes."""
        return np.asarray(np.log2(np.maximum(np.sqrt(self.long * self.short), 1.0)))

    @property
    def probes(self) -> Indices:
        """How many places along the longer axis stand for the whole."""
        counts = np.rint(self.long / np.maximum(self.short, 1.0))
        return counts.clip(1, MOST_PROBES).astype(np.intp)


def footprints(places: Floats, nodes: Floats, triangles: Indices) -> Footprints:
    """Give the footprints of the affine maps from triangles of an image to those of a picture.

    As a map of complex numbers it is z -> a z + b conj(z); its singular values are |a| + |b| and ||a| - |b||.
    """
    z, w = as_complex(places)[triangles], as_complex(nodes)[triangles]
    p, q = z[:, 1] - z[:, 0], z[:, 2] - z[:, 0]
    u, v = w[:, 1] - w[:, 0], w[:, 2] - w[:, 0]
    doubled = (p.conj() * q).imag
    flat = np.abs(doubled) < _LEAST_AREA
    scale = np.where(flat, 0.0, 0.5j / np.where(flat, 1.0, doubled))
    a, b = (u * q.conj() - v * p.conj()) * scale, (v * p - u * q) * scale
    long, short = np.abs(a) + np.abs(b), np.abs(np.abs(a) - np.abs(b))
    along = np.exp(0.5j * (np.angle(a) + np.angle(b)))
    return Footprints(long, short, np.asarray(along, dtype=np.complex128))


@dataclass(frozen=True, eq=False)
class Layer:
    """A picture, as it is looked up for the runs of a frame.

    Attributes
    ----------
    pyramid : Pyramid
    footprints : Footprints
        Of all triangles.
    column : int
        Which of the runs' values is the place in it to the right; the next one is that down.
    """

    pyramid: Pyramid
    footprints: Footprints
    column: int
