"""Blend two shapes: every part by a method, joined by the meta-skeleton."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from starskel.arrays import Complex
from starskel.blending.frames import row_masses
from starskel.correspondence import Correspondence
from starskel.errors import StarskelError
from starskel.outline import edge_lengths
from starskel.polar import as_complex
from starskel.shapes.body import Manner, prepared
from starskel.shapes.certified.blend import CertifiedShapeBlend
from starskel.shapes.correspondence import PartPair, ShapeCorrespondence
from starskel.shapes.matching.given import Places, as_places
from starskel.shapes.meta_skeleton import Tree, tree_of
from starskel.shapes.shape_blend import ShapeBlend
from starskel.shapes.similarity import rotation_of
from starskel.task import Task


def blend_shapes(
    pair: ShapeCorrespondence, manner: Manner, roots: Places, turns: int | None, task: Task
) -> ShapeBlend:
    """Blend all parts; without a number of turns each by itself.

    Raises
    ------
    StarskelError
        Where a root is of no part, or a region too narrow for bridges to its holes; by "certified" where
        rings have to meet on the way.
    Cancelled
        If the task is told to stop.
    """
    method = manner.method
    known = _checked_roots(pair, roots)
    manner = replace(manner, settled=manner.settled or method == "certified")
    parts, owners = _bodies(pair, method)
    tree = None if turns is None else _tree(parts, owners, turns)
    rotations = tree.rotations if tree is not None else np.zeros(len(parts))
    bodies = []
    for number, (part, rotation) in enumerate(zip(parts, rotations.tolist(), strict=True)):
        share = task.part(0.9 * number / len(parts), 0.9 * (number + 1) / len(parts))
        own = replace(manner, root=known.get(part.links[0]))
        bodies.append(prepared(part, own, rotation, share))
    if method == "certified":
        return CertifiedShapeBlend(pair, tuple(bodies), tree, task.part(0.9, 1))
    return ShapeBlend(pair, method, tuple(bodies), tree)


def _checked_roots(pair: ShapeCorrespondence, roots: Places) -> Places:
    known = as_places(roots, "the root of a part")
    outlines = [part.links[0] for part in pair.parts if not part.alone]
    for link in known:
        if link not in outlines:
            named = " or ".join(map(str, outlines)) or "none"
            raise StarskelError(f"{link} is no pair of outlines, and has no root", f"give roots for {named}")
    return known


def _bodies(pair: ShapeCorrespondence, method: str) -> tuple[list[PartPair], list[int]]:
    """Give what moves as one, and for each whether it belongs to another one, or -1.

    Edges and angles know no inside: there holes move by themselves, on a link to their outline.
    """
    if method != "edge-angle":
        return list(pair.parts), [-1] * len(pair.parts)
    parts: list[PartPair] = []
    owners: list[int] = []
    for part in pair.parts:
        owners += [-1, *[len(parts)] * (len(part.links) - 1)]
        parts += part.by_rings()
    return parts, owners


def _tree(parts: Sequence[PartPair], owners: Sequence[int], turns: int) -> Tree:
    outlines = [part.by_rings()[0].pair for part in parts]
    places = np.array([_middles(pair) for pair in outlines]).T
    rotations = [
        None if part.alone else rotation_of(pair) for part, pair in zip(parts, outlines, strict=True)
    ]
    sizes = np.array([edge_lengths(np.stack([pair.source, pair.target])).sum() for pair in outlines])
    return tree_of(places, rotations, owners, sizes, turns)


def _middles(pair: Correspondence) -> Complex:
    weights = row_masses(pair)
    return np.array([weights @ as_complex(pair.source), weights @ as_complex(pair.target)])
