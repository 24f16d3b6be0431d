"""What keeps vertices off edges: an energy that rises where a pair comes nearer than at both ends of the way.

The energy of a pair at distance d is the squared logarithm of (d - r) / (h - r) below its reach h, and zero
beyond; r is the room that it is to keep. The reach is less than the pair's distance in each frame that must
be met exactly: there it pushes nothing.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.sparse import csr_array

from starskel.arrays import Complex, Floats, Indices
from starskel.blending.certified.energies.contacts import Distances, contacts, contacts_within
from starskel.blending.certified.energies.room import Room

LONGEST_REACH = 0.05
"""The largest distance at which pairs push each other apart, as a part of the size."""

SPARSE = 200
"""Of rings with more vertices the reach is less, by the root: so many more pairs are near each other."""

SOON = 1.5
"""Pairs nearer than this multiple of their reach may get into it while a frame moves."""

REACH_SHARE = 0.7
"""The reach of a pair, as a part of its distance in frames that must be met."""

ROOM_FACTOR = 2.0
"""The room that pairs are kept from by the barrier, as a multiple of what is asked of links."""

MOST_ROOM = 0.5
"""The same, as a part of the reach, at most."""

LEAST_LEFT = 1e-3
"""Where a pair has no room left, this part of its distance counts as left."""


def reach_of(n: int, size: float) -> float:
    """Give the largest reach in frames of n vertices."""
    return LONGEST_REACH * size * float(min(1.0, np.sqrt(SPARSE / n)))


@dataclass(frozen=True, eq=False)
class Barrier:
    """The pairs near each other in some frame, and the reach of each.

    Attributes
    ----------
    vertex, edge : (k,) arrays
        The pairs; an edge counts by its first end.
    reach : (k,) array
    room : (k,) array
        What no pair comes nearer than.
    """

    vertex: Indices
    edge: Indices
    reach: Floats
    room: Floats

    @classmethod
    def near(cls, frame: Complex, met: Distances, most: float, room: Room | None) -> "Barrier":
        """Find the pairs of a frame that are or may soon be within reach.

        Parameters
        ----------
        frame : (n,) complex array
        met : Distances
            Those in frames where no pair may push.
        most : float
            The largest reach.
        room : Room, optional
            What is to be kept; without, pairs may come as near as they like.
        """
        vertex, edge, found = contacts_within(frame, SOON * most)
        reach = np.minimum(most, REACH_SHARE * met.at(vertex, edge))
        soon = found.distance < SOON * reach
        vertex, edge, reach = vertex[soon], edge[soon], reach[soon]
        if room is None:
            return cls(vertex, edge, reach, np.zeros(len(reach)))
        return cls(
            vertex, edge, reach, np.minimum(ROOM_FACTOR * room.floors(vertex, edge), reach * MOST_ROOM)
        )

    def energy(self, frame: Complex) -> float:
        """Give half the sum of squared logarithms."""
        distance = contacts(frame, self.vertex, self.edge).distance
        near = distance < self.reach
        beyond = (distance - self.room)[near] / (self.reach - self.room)[near]
        if (beyond <= 0).any():
            return np.inf
        return float((np.log(beyond) ** 2).sum() / 2)

    def linear(self, frame: Complex) -> "Linear":
        """Linearize the logarithms of pairs within reach."""
        n = len(frame)
        found = contacts(frame, self.vertex, self.edge)
        near = np.flatnonzero(found.distance < self.reach)
        distance, direction, share = found.distance[near], found.direction[near], found.share[near]
        vertex, edge, room = self.vertex[near], self.edge[near], self.room[near]
        beyond = np.maximum(distance - room, LEAST_LEFT * distance)
        columns = np.stack([vertex, edge, (edge + 1) % n], axis=1)
        parts = np.stack([np.ones(len(near)), share - 1, -share], axis=1)
        return Linear(np.log(beyond / (self.reach[near] - room)), columns, parts, direction / beyond)


class Linear(NamedTuple):
    """The logarithms of k pairs, and how they change.

    Attributes
    ----------
    logarithms : (k,) array
    vertices : (k, 3) array
        The vertices that move a pair: its own, and both ends of its edge.
    parts : (k, 3) array
        How much each of them moves the place where the pair is nearest.
    slopes : (k,) complex array
        The gradient by that place.
    """

    logarithms: Floats
    vertices: Indices
    parts: Floats
    slopes: Complex

    def changes(self, moves: Complex) -> Floats:
        """Give how the logarithms change when the n vertices move."""
        return np.asarray((self.slopes.conj() * (self.parts * moves[self.vertices]).sum(axis=1)).real)

    def gradients(self, n: int) -> csr_array:
        """Give the gradients by the x of n points, and behind them by the y, (k, 2 n)."""
        rows = np.repeat(np.arange(len(self.logarithms)), 6)
        columns = np.concatenate([self.vertices, self.vertices + n], axis=1).ravel()
        both = self.slopes.real[:, None] * self.parts, self.slopes.imag[:, None] * self.parts
        values = np.concatenate(both, axis=1).ravel()
        return csr_array((values, (rows, columns)), shape=(len(self.logarithms), 2 * n))

    def products(self, compliance: Floats) -> tuple[Floats, Floats]:
        """Give gradients times a symmetric matrix: without their directions, (k, n); by each, (k, k)."""
        columns = list(zip(self.parts.T, self.vertices.T, strict=True))
        yields = sum(parts[:, None] * compliance[vertices] for parts, vertices in columns)
        both = sum(parts[:, None] * yields.T[vertices] for parts, vertices in columns)
        aligned = np.outer(self.slopes.real, self.slopes.real) + np.outer(self.slopes.imag, self.slopes.imag)
        return np.asarray(yields), np.asarray(both * aligned)
