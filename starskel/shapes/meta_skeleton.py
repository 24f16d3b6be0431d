"""The meta-skeleton: a tree over the roots of the parts, so that they move together (paper, section 4).

As in a skeleton, the tree's root moves straight and every other point has polar coordinates relative to its
parent. Interpolated linearly, each link turns evenly by its own rotation; which multiple of 2 pi belongs to
it follows along the tree. A part turns, and the link to it, by no more than half a turn more or less than
its parent turns: what turns together goes the same way round. Only the root is free: it turns the short way.

A part's root is that of its star-skeleton where the blend hangs on one, else the middle of its rings.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, ReadOnlyArrays
from starskel.polar import PolarVectors
from starskel.predicates import segments_meet


@dataclass(frozen=True, eq=False)
class Tree(ReadOnlyArrays):
    """A tree over parts, and how they turn.

    Attributes
    ----------
    order : tuple of int
        All parts, each behind its parent: the root first.
    parents : tuple of int
        For each part the one nearer to the root, -1 for the root.
    rotations : (k,) array
        By how much each part turns, whole turns included.
    """

    order: tuple[int, ...]
    parents: tuple[int, ...]
    rotations: Floats


@dataclass(frozen=True, eq=False)
class MetaSkeleton(ReadOnlyArrays):
    """A tree over the roots of parts.

    Attributes
    ----------
    tree : Tree
    links : PolarVectors
        From the parents' roots to the parts' own; that of the tree's root is 0.
    root_places : (2,) complex array
        Where the tree's root is at t = 0 and 1.
    """

    tree: Tree
    links: PolarVectors
    root_places: Complex

    def places(self, ts: Floats) -> Complex:
        """Give where the parts' roots are at each time, (times, k)."""
        steps = self.links.at(ts)
        places = np.empty_like(steps)
        root = self.tree.order[0]
        places[:, root] = (1 - ts) * self.root_places[0] + ts * self.root_places[1]
        for part in self.tree.order[1:]:
            places[:, part] = places[:, self.tree.parents[part]] + steps[:, part]
        return places


def tree_of(
    places: Complex, rotations: Sequence[float | None], owners: Sequence[int], sizes: Floats, turns: int = 0
) -> Tree:
    """Span the tree and unwrap the rotations.

    Parameters
    ----------
    places : (2, k) complex array
        Where the parts are in source and target.
    rotations : k floats or None
        By how much each part turns, up to whole turns; None where it turns as its parent does.
    owners : k ints
        A part that must be this one's parent, or -1.
    sizes : (k,) array
        Of the parts with most neighbours the largest becomes the root.
    turns : int
        Whole turns of everything besides.
    """
    order, parents = _spanned(places, [r is not None for r in rotations], owners, sizes)
    turned = np.zeros(len(sizes))
    turned[order[0]] = (rotations[order[0]] or 0.0) + 2 * np.pi * turns
    for part in order[1:]:
        around, own = turned[parents[part]], rotations[part]
        turned[part] = around if own is None else _nearest(own, around)
    return Tree(order, parents, turned)


def meta_skeleton_of(tree: Tree, roots: Complex) -> MetaSkeleton:
    """Link the parts' roots, (2, k) in source and target; each link turns about as the parent does."""
    parents = np.array(tree.parents)
    start, end = np.where(parents < 0, 0.0, roots - roots[:, parents])
    around = np.where(parents < 0, 0.0, tree.rotations[parents])
    vague = (start == 0) | (end == 0)
    rotations = np.where(vague, around, _nearest(np.angle(end * start.conj()), around))
    angles = np.where(start != 0, np.angle(start), np.angle(end) - rotations)
    links = PolarVectors(np.abs(start), np.abs(end), angles, rotations)
    return MetaSkeleton(tree, links, roots[:, tree.order[0]])


def _nearest(angles: Floats | float, around: Floats) -> Floats:
    """Add the whole turns that bring angles nearest to others."""
    return np.asarray(angles + 2 * np.pi * np.round((around - angles) / (2 * np.pi)))


def _spanned(
    places: Complex, turning: Sequence[bool], owners: Sequence[int], sizes: Floats
) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Give the parts in order, and their parents: a tree of short links, then what hangs on it."""
    free = [k for k in range(len(sizes)) if owners[k] < 0]
    trunk = [k for k in free if turning[k]] or free
    lengths = _lengths(places)
    neighbours: dict[int, list[int]] = {k: [] for k in range(len(sizes))}
    links = _planar_links(places, trunk, lengths)
    links += [(min(trunk, key=lambda j: lengths[k, j]), k) for k in free if k not in trunk]
    links += [(owner, k) for k, owner in enumerate(owners) if owner >= 0]
    for i, j in links:
        neighbours[i].append(j)
        neighbours[j].append(i)
    root = max(trunk, key=lambda k: (len(neighbours[k]), sizes[k]))
    order, parents = [root], [-1] * len(sizes)
    for part in order:
        for other in neighbours[part]:
            if other != parents[part]:
                parents[other] = part
                order.append(other)
    return tuple(order), tuple(parents)


def _lengths(places: Complex) -> Floats:
    """Give the distances of all parts, each shape's in parts of its largest, summed over both."""
    distances = np.abs(places[:, :, None] - places[:, None, :])
    largest = distances.max(axis=(1, 2), keepdims=True)
    return np.asarray((distances / np.where(largest > 0, largest, 1.0)).sum(axis=0).round(9))


def _planar_links(places: Complex, parts: Sequence[int], lengths: Floats) -> list[tuple[int, int]]:
    """Give a tree of short links; they cross none before them in either shape, as long as there are such."""
    candidates = sorted((lengths[i, j], i, j) for i in parts for j in parts if i < j)
    group = {k: k for k in parts}
    links: list[tuple[int, int]] = []
    for allowed in (False, True):
        for _, i, j in candidates:
            if group[i] != group[j] and (allowed or not any(_cross(places, (i, j), link) for link in links)):
                links.append((i, j))
                group = {k: group[i] if g == group[j] else g for k, g in group.items()}
    return links


def _cross(places: Complex, first: tuple[int, int], second: tuple[int, int]) -> bool:
    if set(first) & set(second):
        return False
    ends = np.stack([places.real, places.imag], axis=-1)
    return any(bool(segments_meet(*(side[k] for k in (*first, *second)))) for side in ends)
