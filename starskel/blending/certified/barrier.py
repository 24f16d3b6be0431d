"""What keeps vertices off edges: an energy that rises where a pair comes nearer than at both ends of the way.

The energy of a pair at distance d is the squared logarithm of d / h below its reach h, and zero beyond. The
reach is less than the pair's distance in each frame that must be met exactly: there it pushes nothing.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy import sparse

from starskel.certificate import near_pairs, seen_ends
from starskel.predicates import Complex, Floats, Indices

REACH = 0.05
"""The largest distance at which pairs push each other apart, as a part of the size."""

SOON = 3.0
"""Pairs nearer than this multiple of their reach may get into it while a frame moves."""

SHARE = 0.7
"""The reach of a pair, as a part of its distance in frames that must be met."""


class Contact(NamedTuple):
    """Of vertices and edges: distances, directions (edge to vertex), how far along the edge is nearest."""

    distance: Floats
    direction: Complex
    share: Floats


@dataclass(frozen=True, eq=False)
class Barrier:
    """The pairs near each other in some frame, and the reach of each.

    Attributes
    ----------
    vertex, edge : (k,) arrays
        The pairs; an edge counts by its first end.
    reach : (k,) array
    """

    vertex: Indices
    edge: Indices
    reach: Floats

    @classmethod
    def near(cls, frame: Complex, met: tuple[Complex, ...], size: float) -> "Barrier":
        """Find the pairs of a frame that are or may soon be within reach.

        Parameters
        ----------
        frame : (n,) complex array
        met : tuple of (n,) complex arrays
            Frames where no pair may push.
        size : float
            The shapes' extent.
        """
        parts = list(near_pairs(frame, frame, SOON * REACH * size))
        vertex, edge = (np.concatenate([part[k] for part in parts]) for k in (0, 1))
        reach = np.full(len(vertex), REACH * size)
        for other in met:
            reach = np.minimum(reach, SHARE * contacts(other, vertex, edge).distance)
        soon = contacts(frame, vertex, edge).distance < SOON * reach
        return cls(vertex[soon], edge[soon], reach[soon])

    def energy(self, frame: Complex) -> float:
        """Give half the sum of squared logarithms."""
        pushed = contacts(frame, self.vertex, self.edge).distance / self.reach
        return float((np.log(pushed[pushed < 1]) ** 2).sum() / 2)

    def linear(self, frame: Complex, unknowns: int) -> tuple[Floats, sparse.csr_array]:
        """Give the logarithms of pairs within reach, and their derivatives by x0, y0, x1, y1, ..."""
        n = len(frame)
        found = contacts(frame, self.vertex, self.edge)
        near = np.flatnonzero(found.distance < self.reach)
        distance, direction, share = (part[near] for part in found)
        vertex, edge = self.vertex[near], self.edge[near]
        columns = np.stack([vertex, edge, (edge + 1) % n], axis=1)
        slopes = direction[:, None] / distance[:, None]
        slopes = slopes * np.stack([np.ones(len(near)), share - 1, -share], axis=1)
        rows = np.repeat(np.arange(len(near)), 6)
        places = (2 * columns[:, :, None] + [0, 1]).ravel()
        values = np.stack([slopes.real, slopes.imag], axis=2).ravel()
        jacobian = sparse.csr_array((values, (rows, places)), shape=(len(near), unknowns))
        return np.log(distance / self.reach[near]), jacobian


def contacts(frame: Complex, vertex: Indices, edge: Indices) -> Contact:
    """Measure pairs of a vertex and an edge."""
    p, q = seen_ends(frame, vertex, edge)
    along = q - p
    squared = along.real**2 + along.imag**2
    share = np.clip(-(p.real * along.real + p.imag * along.imag) / np.where(squared > 0, squared, 1.0), 0, 1)
    away = -(p + share * along)
    distance = np.maximum(np.abs(away), np.finfo(np.float64).tiny)
    return Contact(distance, away / distance, share)
