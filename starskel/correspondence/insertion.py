"""New partners for the vertices that an alignment leaves alone."""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Flags, Floats, Indices
from starskel.errors import InvalidPolygon, told
from starskel.outline import edge_lengths
from starskel.predicates import ROUNDING


@dataclass(frozen=True, eq=False)
class Rows:
    """The vertices of both rings in one order, from the first matched pair on.

    Attributes
    ----------
    vertices : (2, rows) array
        For each row the vertex of the first and of the second ring, -1 where one has to be inserted.
    gaps : (rows,) array
        After which matched pair the row comes.
    shares : (rows,) array
        How far it is to the next matched pair, as a share of the length; 0 for the matched pair itself.
    """

    vertices: Indices
    gaps: Indices
    shares: Floats


def merged(rings: tuple[Floats, Floats], matched: Indices) -> Rows:
    """Order the vertices of both rings by their share of the length between matched neighbours.

    Parameters
    ----------
    rings : two (n, 2) arrays
    matched : (k, 2) array
        The vertices that correspond, in the order round the rings, k >= 1.
    """
    parts = [_placed(ring, matched[:, side], side) for side, ring in enumerate(rings)]
    alone = [part.shares > 0 for part in parts]
    vertices = np.concatenate(
        [matched.T, *(p.vertices[:, a] for p, a in zip(parts, alone, strict=True))], axis=1
    )
    gaps = np.concatenate([np.arange(len(matched)), *(p.gaps[a] for p, a in zip(parts, alone, strict=True))])
    shares = np.concatenate(
        [np.zeros(len(matched)), *(p.shares[a] for p, a in zip(parts, alone, strict=True))]
    )
    order = np.lexsort((shares, gaps))
    return _without_ties(rings, Rows(vertices[:, order], gaps[order], shares[order]))


def inserted(ring: Floats, rows: Rows, side: int) -> Floats:
    """Give an (rows, 2) ring with a point for every row: its own vertices, to the bit, and new ones on edges.

    Raises
    ------
    InvalidPolygon
        Where an edge is so short that no different points fit on it.
    """
    vertices = rows.vertices[side]
    edges = np.maximum.accumulate(np.where(vertices >= 0, np.arange(len(vertices)), 0))
    fractions = _fractions(rows, edges, side)
    points = _along(ring, vertices[edges], fractions)
    touching = _touching(points)
    if touching.any():
        crowded = np.isin(edges, edges[touching]) & (vertices < 0)
        points = _along(ring, vertices[edges], np.where(crowded, _even(edges), fractions))
        _refuse_crowds(points, vertices[edges])
    return points


def _placed(ring: Floats, matched: Indices, side: int) -> Rows:
    """Give the rows of one ring alone."""
    n = len(ring)
    order = (matched[0] + np.arange(n)) % n
    starts = (matched - matched[0]) % n
    arcs = np.concatenate([[0.0], np.cumsum(edge_lengths(ring)[order])])
    gaps = np.searchsorted(starts, np.arange(n), side="right") - 1
    before, after = arcs[starts][gaps], arcs[np.append(starts[1:], n)][gaps]
    shares = np.clip((arcs[:n] - before) / (after - before), np.finfo(np.float64).tiny, 1.0)
    shares[starts] = 0.0
    vertices = np.full((2, n), -1, dtype=np.intp)
    vertices[side] = order
    return Rows(vertices, gaps, shares)


def _without_ties(rings: tuple[Floats, Floats], rows: Rows) -> Rows:
    """Match neighbouring rows of the two rings that rounding cannot tell apart."""
    lengths = [edge_lengths(ring).sum() for ring in rings]
    apart = max(ROUNDING * np.abs(ring).max() / length for ring, length in zip(rings, lengths, strict=True))
    alone = np.minimum(*rows.vertices) < 0
    close = (np.diff(rows.gaps) == 0) & (np.diff(rows.shares) <= apart) & alone[:-1] & alone[1:]
    close &= (rows.vertices[0, :-1] < 0) != (rows.vertices[0, 1:] < 0)
    keep, vertices = np.ones(len(alone), dtype=np.bool_), rows.vertices.copy()
    for k in np.flatnonzero(close):
        if keep[k]:
            vertices[:, k] = np.maximum(vertices[:, k], vertices[:, k + 1])
            keep[k + 1] = False
    return Rows(vertices[:, keep], rows.gaps[keep], rows.shares[keep])


def _fractions(rows: Rows, edges: Indices, side: int) -> Floats:
    """Give how far along its edge each row lies: 0 for own vertices, else in [0, 1]."""
    own = np.flatnonzero(rows.vertices[side] >= 0)
    ends = np.append(rows.shares[own[1:]], 0.0)
    ends[ends == 0] = 1.0  # the next matched pair
    start, end = rows.shares[edges], ends[np.searchsorted(own, edges)]
    width = end - start
    within = np.divide(rows.shares - start, width, out=np.full(len(start), 0.5), where=width > 0)
    return np.asarray(np.where(rows.vertices[side] >= 0, 0.0, np.clip(within, 0.0, 1.0)))


def _along(ring: Floats, edges: Indices, fractions: Floats) -> Floats:
    """Give the points at these fractions of the edges, never beyond their ends."""
    start, end = ring[edges], np.roll(ring, -1, axis=0)[edges]
    points = start + (end - start) * fractions[:, None]
    return np.clip(points, np.minimum(start, end), np.maximum(start, end))


def _touching(points: Floats) -> Flags:
    same = points == np.roll(points, -1, axis=0)
    return np.asarray(same[:, 0] & same[:, 1])


def _even(edges: Indices) -> Floats:
    """Give fractions that divide each edge evenly, for the rows on it in turn."""
    rank = np.arange(len(edges)) - edges
    return np.asarray(rank / np.bincount(edges, minlength=len(edges))[edges])


def _refuse_crowds(points: Floats, edges: Indices) -> None:
    touching = np.flatnonzero(_touching(points))
    if len(touching):
        x, y = points[touching[0]]
        raise InvalidPolygon(
            told(
                "the edge from vertex {i} at ({x:g}, {y:g}) is too short for new vertices",
                i=edges[touching[0]],
                x=x,
                y=y,
            ),
            told("remove that vertex or mark more correspondences nearby"),
            vertices=[int(edges[touching[0]])],
            place=(float(x), float(y)),
        )
