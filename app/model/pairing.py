"""What becomes of the parts of a shape: links between two key shapes, kept whole while parts come and go.

Every part is in a link; one that has no partner is alone in one, and in no other.
"""

from collections.abc import Iterable
from dataclasses import replace

from app.model import marks as pins
from app.model.marks import SIDES, Renumbering, Side
from starskel.files.projects.step import Link

Links = tuple[Link, ...]
Ends = tuple[int | None, int | None]


def part_of(link: Link, side: Side) -> int | None:
    """Give the part that a link has on a side."""
    return link.ends[SIDES.index(side)]


def with_part(link: Link, side: Side, part: int | None) -> Link:
    """Give a link with another part on a side; its marks and its place go."""
    ends = (part, link.target) if side == "source" else (link.source, part)
    return link if part_of(link, side) == part else Link(*ends)


def complete(links: Iterable[Link], sources: int, targets: int) -> Links:
    """Put every one of so many parts into a link; leave out links that say nothing, or that say it again."""
    kept: dict[Ends, Link] = {}
    for link in links:
        kept.setdefault(link.ends, link)
    paired = {side: {part_of(link, side) for link in kept.values() if not link.alone} for side in SIDES}
    found = [link for link in kept.values() if not link.alone or _needed(link, paired)]
    for side, count in zip(SIDES, (sources, targets), strict=True):
        known = {part_of(link, side) for link in found}
        found += [with_part(Link(), side, part) for part in range(count) if part not in known]
    return tuple(found)


def _needed(link: Link, paired: dict[Side, set[int | None]]) -> bool:
    return link.ends != (None, None) and all(
        part is None or part not in paired[side] for side, part in zip(SIDES, link.ends, strict=True)
    )


def without_part(links: Links, side: Side, part: int) -> Links:
    """Give the links after a part is gone; those behind it move up, and its partner is alone."""
    return tuple(
        with_part(link, side, None) if own == part else _renumbered(link, side, own - (own > part))
        for link in links
        for own in (_number(link, side),)
    )


def _number(link: Link, side: Side) -> int:
    """Give the number of a part, -1 for none."""
    own = part_of(link, side)
    return -1 if own is None else own


def _renumbered(link: Link, side: Side, number: int) -> Link:
    part = None if number < 0 else number
    return replace(link, source=part) if side == "source" else replace(link, target=part)


def paired(links: Links, source: int, target: int) -> Links:
    """Make two parts partners; those that were theirs become partners of each other."""
    if any(link.ends == (source, target) for link in links):
        return links
    former = next((link.target for link in links if link.source == source), None)
    return tuple(
        Link(source, target)
        if link.source == source
        else with_part(link, "target", former)
        if link.target == target
        else link
        for link in links
    )


def split(links: Links, source: int, target: int) -> Links:
    """Make two parts partners besides those that the source has: it becomes several parts.

    Where the source has none, it is the target that several parts become. Marks of what is cut go.
    """
    alone = any(link.ends == (source, None) for link in links)
    where = next(k for k, link in enumerate(links) if link.source == source)
    left = [
        link
        if target != link.target and (alone or link.source != source)
        else replace(link, marks=())
        if alone or link.target != target
        else with_part(link, "target", None)
        for link in links
    ]
    return (*left[: where + 1], Link(source, target), *left[where + 1 :])


def parted(links: Links, number: int) -> Links:
    """Let both parts of a link go their own way."""
    link = links[number]
    alone = with_part(link, "target", None), with_part(link, "source", None)
    return (*links[:number], *alone, *links[number + 1 :])


def repaired(links: Links, pairing: Iterable[Ends]) -> Links:
    """Give other pairs; those that were there before keep their marks and places, and all their order."""
    known = {link.ends: link for link in links}
    order = {ends: k for k, ends in enumerate(known)}
    found = [known.get(ends, Link(*ends)) for ends in pairing]
    return tuple(sorted(found, key=lambda link: order.get(link.ends, len(order))))


def followed(links: Links, side: Side, part: int, renumbered: Renumbering) -> Links:
    """Give the links after the vertices of a part were renumbered."""
    return tuple(
        replace(link, marks=pins.followed(link.marks, side, renumbered))
        if part_of(link, side) == part
        else link
        for link in links
    )


def composed(first: Links, second: Links) -> Links:
    """Give the links that lead by way of a shape between; what ends there is left out."""
    return tuple(
        Link(one.source, two.target, pins.composed(one.marks, two.marks), root=one.root)
        for one in first
        for two in second
        if None not in (one.source, one.target, two.target) and one.target == two.source
    )


def marked(links: Links, side: Side, part: int) -> list[int]:
    """Give the vertices of a part that are marked."""
    return [pins.end(mark, side) for link in links if part_of(link, side) == part for mark in link.marks]
