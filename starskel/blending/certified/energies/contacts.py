"""How near vertices and edges are to each other, in a frame and in those that a way leads through."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.certificate import near_pairs, seen_ends


class Contact(NamedTuple):
    """Of vertices and edges: distances, directions (edge to vertex), how far along the edge is nearest."""

    distance: Floats
    direction: Complex
    share: Floats


def contacts(frame: Complex, vertex: Indices, edge: Indices) -> Contact:
    """Measure pairs of a vertex and an edge."""
    p, q = seen_ends(frame, vertex, edge)
    along = q - p
    squared = along.real**2 + along.imag**2
    share = np.clip(-(p.real * along.real + p.imag * along.imag) / np.where(squared > 0, squared, 1.0), 0, 1)
    away = -(p + share * along)
    distance = np.maximum(np.abs(away), np.finfo(np.float64).tiny)
    return Contact(distance, away / distance, share)


def contacts_within(frame: Complex, reach: float) -> tuple[Indices, Indices, Contact]:
    """Give the vertices and edges of a frame that may be within reach of each other, and measure them."""
    parts = list(near_pairs(frame, frame, reach))
    vertex, edge = (np.concatenate([part[k] for part in parts]) for k in (0, 1))
    return vertex, edge, contacts(frame, vertex, edge)


@dataclass(frozen=True, eq=False)
class Distances:
    """The least distances of vertices and edges in some frames, looked up instead of measured again.

    Attributes
    ----------
    n : int
        How many vertices the frames have.
    reach : float
        Of pairs that are farther apart in all frames nothing is kept.
    pairs : (k,) array of int
        What is kept: vertex times n plus edge, ascending.
    least : (k,) array
        Their distances.
    """

    n: int
    reach: float
    pairs: Indices
    least: Floats

    @classmethod
    def of(cls, frames: tuple[Complex, ...], n: int, reach: float) -> "Distances":
        """Measure (n,) frames."""
        none = cls(n, reach, np.zeros(0, dtype=np.intp), np.zeros(0))
        return none.besides(*frames)

    def besides(self, *frames: Complex) -> "Distances":
        """Give the least ones of these and more frames."""
        pairs, least = [self.pairs], [self.least]
        for frame in frames:
            vertex, edge, found = contacts_within(frame, self.reach)
            pairs.append(vertex * self.n + edge)
            least.append(found.distance)
        every, distances = np.concatenate(pairs), np.concatenate(least)
        order = np.lexsort((distances, every))
        every, distances = every[order], distances[order]
        first = np.diff(every, prepend=-1) > 0
        return Distances(self.n, self.reach, every[first], distances[first])

    def at(self, vertex: Indices, edge: Indices) -> Floats:
        """Look up pairs; infinite where nothing is kept."""
        if not len(self.pairs):
            return np.full(len(vertex), np.inf)
        wanted = vertex * self.n + edge
        place = np.minimum(np.searchsorted(self.pairs, wanted), len(self.pairs) - 1)
        return np.where(self.pairs[place] == wanted, self.least[place], np.inf)
