"""What is copied of a shape, and how it comes back: all of it, or some parts with their holes."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from app.model import parts
from app.model.document import Document
from app.model.marks import Side, other
from app.model.pairing import part_of
from app.model.selection import Selection, everything
from starskel.errors import InvalidPolygon
from starskel.files.projects.key_shape import Part
from starskel.polygon import Polygon
from starskel.shapes.shape import Shape

ASIDE = 0.1
"""So far aside, in parts of their size, copies are put that would lie on what they are copies of."""

MOST = 60
"""So many places aside are tried."""


@dataclass(frozen=True)
class Clipping:
    """A shape that was copied.

    Attributes
    ----------
    shape : Shape
        Its parts, with their holes.
    whole : bool
        Whether it is all that was on its canvas: then it takes the place of a shape, else it is added to one.
    """

    shape: Shape
    whole: bool = True


def clipping_of(document: Document, selection: Selection) -> Clipping | None:
    """Give what is selected: parts with their holes, or the whole shape where nothing is; None of nothing."""
    shape, chosen = document.shape(selection.side), chosen_parts(document, selection)
    if not chosen:
        return None
    rings, outer = shape.rings, shape.shape.outer
    outlines = [part for part in chosen if outer[part] not in chosen]
    copied = Shape.of_parts(
        [(rings[part], [rings[k] for k in chosen if outer[k] == part]) for part in outlines]
    )
    return Clipping(copied, len(chosen) == len(shape))


def chosen_parts(document: Document, selection: Selection) -> list[int]:
    """Give the parts on the side of a selection that it means: those chosen in the list or touched, or all.

    The holes of a part belong to it.
    """
    side = selection.side
    shape, part = document.shape(side), document.part(side)
    if not shape.parts:
        return []
    links = document.way.links
    chosen = {part_of(links[k], side) for k in selection.links if k < len(links)} - {None}
    if not chosen:
        chosen = {part} if selection.vertices and part is not None else set(range(len(shape)))
    return [k for k, outer in enumerate(shape.shape.outer) if k in chosen or outer in chosen]


def cut(document: Document, selection: Selection) -> Document:
    """Take what is selected off its canvas; partners stay alone."""
    sequence, side = document.sequence, selection.side
    for part in reversed(chosen_parts(document, selection)):
        sequence = sequence.remove_part(document.shape_on(side), part)
    last = len(sequence.steps[document.step].links) - 1
    return replace(document, sequence=sequence, link=max(min(document.link, last), 0))


def pasted(document: Document, side: Side, clipping: Clipping) -> Document:
    """Put a clipping in the place of a shape, or add its parts to one; what was copied across is paired.

    Raises
    ------
    InvalidPolygon
        If the parts form no shape.
    """
    rings = clipping.shape.rings
    if clipping.whole or not document.shape(side).parts:
        return parts.draw(document, side, rings)
    refused: InvalidPolygon | None = None
    for moved in _places(rings, document.shape(side).rings):
        try:
            return _added(document, side, moved)
        except InvalidPolygon as error:  # there it would lie across another part
            refused = refused or error
    assert refused is not None
    raise refused


def everything_of(document: Document, side: Side, count: int) -> Selection:
    """Select the last so many parts on a side, with all vertices of the one worked on."""
    first = len(document.shape(side)) - count
    links = (k for k, link in enumerate(document.way.links) if (part_of(link, side) or 0) >= first)
    chosen = everything(document, side)
    return replace(chosen, links=frozenset(links)) if count > 1 else chosen


def _added(document: Document, side: Side, rings: Sequence[Polygon]) -> Document:
    """Add parts to a shape, and pair them with what they are copies of."""
    first, sequence = len(document.shape(side)), document.sequence
    for ring in rings:
        sequence = sequence.add_part(document.shape_on(side), Part(ring))
    added = replace(document, sequence=sequence)
    for part, ring in enumerate(rings, start=first):
        added = _reunited(added, side, part, ring)
    return added.working_on(side, first)


def _places(rings: Sequence[Polygon], there: Sequence[Polygon]) -> Iterator[Sequence[Polygon]]:
    """Give copies where they were, if they would not lie on a part that is there, and ever farther aside."""
    known = {ring.vertices.tobytes() for ring in there}
    step = ASIDE * np.ptp(np.concatenate([ring.vertices for ring in rings]), axis=0).max() * np.array([1, -1])
    for steps in range(MOST):
        moved = [Polygon(ring.vertices + steps * step) for ring in rings] if steps else rings
        if not any(ring.vertices.tobytes() in known for ring in moved):
            yield moved


def _reunited(document: Document, side: Side, part: int, ring: Polygon) -> Document:
    """Pair a part with the one on the other canvas that it is a copy of, if that one is alone."""
    there = document.shape(other(side)).rings
    alone = {part_of(link, other(side)) for link in document.way.links if link.alone}
    for twin, known in enumerate(there):
        if twin in alone and np.array_equal(known.vertices, ring.vertices):
            ends = (part, twin) if side == "source" else (twin, part)
            return parts.pair(document, *ends)
    return document
