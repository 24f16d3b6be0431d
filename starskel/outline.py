"""What makes an outline: edge vectors, lengths, turning angles, area; of one ring or of a stack of frames."""

import numpy as np
import shapely

from starskel.arrays import Flags, Floats
from starskel.predicates import orientation


def edge_vectors(rings: Floats) -> Floats:
    """Give the (..., n, 2) vectors from each vertex to the next."""
    return np.asarray(np.roll(rings, -1, axis=-2) - rings)


def edge_lengths(rings: Floats) -> Floats:
    """Give the (..., n) lengths of the edges, edge i from vertex i to the next."""
    x, y = np.moveaxis(edge_vectors(rings), -1, 0)
    return np.asarray(np.hypot(x, y))


def turning_angles(rings: Floats) -> Floats:
    """Give by how much the outline turns at each vertex, (..., n), in [-pi, pi], left turns positive.

    The sign is exact: the angles of a simple counter-clockwise ring sum up to 2 pi however sharp its spikes.
    """
    before, after = np.roll(rings, 1, axis=-2), np.roll(rings, -1, axis=-2)
    (ux, uy), (vx, vy) = np.moveaxis(rings - before, -1, 0), np.moveaxis(after - rings, -1, 0)
    magnitude = np.abs(np.arctan2(ux * vy - uy * vx, ux * vx + uy * vy))
    return np.asarray(np.where(orientation(before, rings, after) < 0, -magnitude, magnitude))


def signed_areas(rings: Floats) -> Floats:
    """Give the (...) areas of the rings, negative where they run clockwise."""
    spokes = rings[..., 1:, :] - rings[..., :1, :]
    x, y = spokes[..., 0], spokes[..., 1]
    return np.asarray(0.5 * (x[..., :-1] * y[..., 1:] - y[..., :-1] * x[..., 1:]).sum(axis=-1))


def cross_themselves(rings: Floats) -> Flags:
    """Tell which of the (k, n, 2) rings cross or touch themselves, have equal vertices or are inside out."""
    simple = np.asarray(shapely.is_simple(shapely.linearrings(rings)), dtype=np.bool_)
    apart = (edge_lengths(rings) > 0).all(axis=-1)  # shapely takes repeated vertices for one
    return ~(simple & apart & (signed_areas(rings) > 0))


def regions_cross(rows: Floats, starts: tuple[int, ...]) -> Flags:
    """Tell which of k regions, (k, n, 2), have rings that cross themselves or each other, or holes outside.

    The rings begin at the rows named: the outline, then the holes, clockwise.
    """
    outlines, *holes = np.split(rows, starts[1:], axis=1)
    crossing = cross_themselves(outlines)
    for ring in holes:
        crossing |= cross_themselves(ring[:, ::-1])
    if holes:
        rings = np.stack([shapely.linearrings(ring) for ring in holes], axis=1)
        crossing |= ~np.asarray(
            shapely.is_valid(shapely.polygons(shapely.linearrings(outlines), holes=rings))
        )
    return crossing


def precedes(first: Floats, second: Floats) -> bool:
    """Tell whether the first of two (n, 2) rings precedes: that of fewer vertices, then smaller coordinates.

    What is computed for a pair in this order is the same, to the bit, whichever of them is called the source;
    at which vertices the rings begin does not matter.
    """
    if len(first) != len(second):
        return len(first) < len(second)
    one, other = (ring[np.lexsort(ring.T)].ravel() for ring in (first, second))
    unequal = np.flatnonzero(one != other)
    return bool(len(unequal) and one[unequal[0]] < other[unequal[0]])
