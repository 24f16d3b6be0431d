"""What is done to parts of shapes, and to what becomes of them."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from app.model import pairing
from app.model.document import Document
from app.model.marks import SIDES, Side
from app.model.pairing import Ends
from app.model.point import Point
from starskel import suggest_pairing
from starskel.files.projects.key_shape import Part
from starskel.files.projects.part_looks import part_looks
from starskel.files.projects.step import Link
from starskel.polygon import Polygon
from starskel.sheet.style import PartLook


def style(document: Document, link: int, **changes: Any) -> Document:
    """Change the name, the colour or the visibility of the part of a link and of its partner."""
    sequence = document.sequence
    for side, part in zip(SIDES, document.way.links[link].ends, strict=True):
        if part is not None:
            sequence = sequence.style(document.shape_on(side), part, **changes)
    return replace(document, sequence=sequence)


def remove(document: Document) -> Document:
    """Remove the part worked on and its partner; one that has other partners, too, goes all the same."""
    source, target = document.pair.ends
    sequence = document.sequence
    ends: tuple[tuple[Side, int | None], ...] = (("target", target), ("source", source))
    for side, part in ends:
        if part is not None:
            sequence = sequence.remove_part(document.shape_on(side), part)
    last = len(sequence.steps[document.step].links) - 1
    return replace(document, sequence=sequence, link=max(min(document.link, last), 0))


def draw(document: Document, side: Side, rings: Sequence[Polygon]) -> Document:
    """Put polygons in the place of all parts on a side; where new parts are to be drawn, add them.

    What replaces a shape is paired with the other one as it suggests itself.

    Raises
    ------
    InvalidPolygon
        If the parts form no shape.
    """
    if len(rings) == 1 and (len(document.shape(side)) < 2 or document.part(side) is None):
        return document.draw(side, rings[0])
    number, sequence = document.shape_on(side), document.sequence
    adds = document.part(side) is None
    for _ in range(0 if adds else len(document.shape(side))):
        sequence = sequence.remove_part(number, 0)
    first = len(sequence.shapes[number])
    for ring in rings:
        sequence = sequence.add_part(number, Part(Polygon(ring.vertices)))
    drawn = replace(document, sequence=sequence, link=0)
    source, target = drawn.shape("source"), drawn.shape("target")
    if source.parts and target.parts and (not adds or first == 0):
        suggested = suggest_pairing(source.shape, target.shape)
        drawn = drawn.relinked(tuple(Link(*ends) for ends in suggested))
    return drawn.working_on(side, first)


def pair(document: Document, source: int, target: int) -> Document:
    """Let a part become another one; the partners that they had become each other."""
    links = pairing.paired(document.way.links, source, target)
    return document.relinked(links).working_on("source", source)


def split(document: Document, source: int, target: int) -> Document:
    """Let a part become another one besides: one becomes several, or several become one."""
    links = pairing.split(document.way.links, source, target)
    return document.relinked(links).working_on("target", target)


def part_ways(document: Document) -> Document:
    """Let the source shrink to a point and the target grow from one, each by itself."""
    if document.pair.alone:
        return document
    return document.relinked(pairing.parted(document.way.links, document.link))


def pair_anew(document: Document, ends: Iterable[Ends]) -> Document:
    """Give all parts other partners; those who stay together keep their marks."""
    return document.relinked(pairing.repaired(document.way.links, ends))


def reorder(document: Document, to: int) -> Document:
    """Paint the part worked on as the one of this number, the first at the bottom."""
    links = document.way.links
    rest = (*links[: document.link], *links[document.link + 1 :])
    moved = document.steer(links=(*rest[:to], document.pair, *rest[to:]))
    return replace(moved, link=to)


def place(document: Document, at: Point | None) -> Document:
    """Let the part without a partner grow from a point, or shrink to it; None leaves that to the method."""
    return document.put_link(replace(document.pair, place=at)) if document.pair.alone else document


def root(document: Document, link: int, at: Point | None) -> Document:
    """Let the star origin nearest to a place of the source be a link's root; None leaves it to the method."""
    links = document.way.links
    return document.steer(links=(*links[:link], replace(links[link], root=at), *links[link + 1 :]))


def usual_roots(document: Document) -> Document:
    """Leave all roots to the method again."""
    return document.steer(links=tuple(replace(link, root=None) for link in document.way.links))


def members(document: Document, link: int) -> list[Part]:
    """Give the parts of a link: one of each shape, or the one that is alone."""
    ends = zip(SIDES, document.way.links[link].ends, strict=True)
    return [document.shape(side).parts[part] for side, part in ends if part is not None]


def stacked(document: Document, side: Side) -> list[int]:
    """Give the parts on a side in the order in which they are painted, the lowest first."""
    found = (pairing.part_of(link, side) for link in document.way.links)
    return list(dict.fromkeys(part for part in found if part is not None))


def looks(document: Document) -> tuple[PartLook, ...]:
    """Give for each link how its parts look; they are shown while one of both is to be seen."""
    return part_looks(document.shape("source"), document.way, document.shape("target"))


def colours(document: Document, link: int) -> tuple[str, str]:
    """Give the colours of a link at the start and at the end, empty where they are the usual ones."""
    return looks(document)[link].colours


def shown(document: Document, link: int) -> bool:
    """Tell whether one of the parts of a link is visible."""
    return looks(document)[link].visible
