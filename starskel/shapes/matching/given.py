"""What the user gave of a correspondence between shapes: checked, and sorted by parts."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import shapely

from starskel.arguments import items, mapping, point
from starskel.correspondence.marks import Mark, as_marks
from starskel.errors import InvalidMarks, told
from starskel.polygon import Polygon
from starskel.shapes.matching.cuts import Partner, cut_between
from starskel.shapes.matching.pairing import RingLink
from starskel.shapes.shape import Shape

Place = tuple[float, float]
Marks = Sequence[Iterable[Mark]]
Places = Mapping[RingLink, Place]


@dataclass(frozen=True, eq=False)
class Given:
    """Two shapes, which of their rings become which, and what else is known of that.

    Attributes
    ----------
    shapes : (Shape, Shape)
        Source and target.
    links : tuple of (int or None, int or None)
        Every ring is in one of them.
    marks : tuple of tuples of marks
        For each ring of the source.
    places : mapping
        Points for rings without a partner, as far as they are given.
    """

    shapes: tuple[Shape, Shape]
    links: tuple[RingLink, ...]
    marks: tuple[tuple[Mark, ...], ...]
    places: Places

    @classmethod
    def checked(
        cls, shapes: tuple[Shape, Shape], links: tuple[RingLink, ...], marks: Marks, places: Places
    ) -> "Given":
        """Check that marks and places belong to rings.

        Raises
        ------
        InvalidMarks
            Where they do not.
        """
        given = items(marks, "the marks of a shape", _MARKS, InvalidMarks)
        lists = tuple(as_marks(own) for own in given) or ((),) * len(shapes[0])
        if len(lists) != len(shapes[0]):
            raise InvalidMarks(
                f"{len(lists)} lists of marks for {len(shapes[0])} rings of the source",
                _MARKS,
            )
        known = as_places(places, "the place of a ring without a partner")
        for link in known:
            if link not in links or None not in link:
                raise InvalidMarks(
                    f"a place is given for {link}, which pairs no ring with None",
                    "give the pair as in the pairing",
                )
        return cls(shapes, links, lists, known)

    @cached_property
    def outlines(self) -> dict[RingLink, tuple[Polygon | None, Polygon | None]]:
        """The links of outlines, and the polygons that they pair: whole outlines, or pieces of them."""
        own = [link for link in self.links if self._owners(link) <= {-1}]
        pieces: tuple[dict[RingLink, Polygon], dict[RingLink, Polygon]] = ({}, {})
        for side in (0, 1):
            for ring in sorted({ring for link in own if (ring := link[side]) is not None}):
                links = [link for link in own if link[side] == ring]
                pieces[side].update(self._cut(side, ring, links))
        return {link: (pieces[0].get(link), pieces[1].get(link)) for link in own}

    def marks_of(self, link: RingLink) -> tuple[Mark, ...]:
        """Give the marks of two rings that are partners.

        Raises
        ------
        InvalidMarks
            Where there are some, but one of the rings is cut.
        """
        marks = self.marks[link[0]] if link[0] is not None else ()
        cut = any(sum(other[side] == link[side] for other in self.links) > 1 for side in (0, 1))
        if marks and cut:
            raise InvalidMarks(
                told("rings {i} and {j} bear marks, but one of them is cut into parts", i=link[0], j=link[1]),
                told("remove these marks, or cut the ring yourself"),
                marks,
            )
        return marks

    @cached_property
    def holes(self) -> dict[RingLink, list[RingLink]]:
        """The links of holes, by the outlines' that they belong to."""
        found: dict[RingLink, list[RingLink]] = {link: [] for link in self.outlines}
        for link in self.links:
            if link not in self.outlines:
                found[self._outline_of(link)].append(link)
        return found

    def rings_of(self, link: RingLink) -> tuple[Polygon | None, Polygon | None]:
        """Give the rings that a link names."""
        source, target = (
            None if ring is None else shape.rings[ring] for shape, ring in zip(self.shapes, link, strict=True)
        )
        return source, target

    def _owners(self, link: RingLink) -> set[int]:
        return {shape.outer[ring] for shape, ring in zip(self.shapes, link, strict=True) if ring is not None}

    def _cut(self, side: int, ring: int, links: list[RingLink]) -> dict[RingLink, Polygon]:
        whole = self.shapes[side].rings[ring]
        if len(links) == 1:
            return {links[0]: whole}
        others = [link[1 - side] for link in links]
        self._check_partners(side, ring, others)
        partners = [self._partner(side, ring, other) for other in others if other is not None]
        holes = [self.shapes[side].rings[hole] for hole in self.shapes[side].holes(ring)]
        return dict(zip(links, cut_between(whole, holes, partners), strict=True))

    def _check_partners(self, side: int, ring: int, others: list[int | None]) -> None:
        """Check that a ring with several partners is alone with none, and shares none of them."""
        if None in others:
            raise InvalidMarks(
                told(
                    "ring {ring} of the {name} has partners, and is alone besides",
                    ring=ring,
                    name=told(_NAMES[side]),
                ),
                told("remove one of these pairs"),
            )
        shared = [k for k in others if sum(link[1 - side] == k for link in self.links) > 1]
        if shared:
            raise InvalidMarks(
                told(
                    "ring {ring} of the {name} and ring {other} of the {other_name} both have"
                    " several partners",
                    ring=ring,
                    name=told(_NAMES[side]),
                    other=shared[0],
                    other_name=told(_NAMES[1 - side]),
                ),
                told("let one ring become several, or several one"),
            )

    def _partner(self, side: int, ring: int, other: int) -> Partner:
        """Give what a piece of a ring is to become, and the holes that go along."""
        own, theirs = self.shapes[side], self.shapes[1 - side]
        holes = [
            own.rings[hole]
            for link in self.links
            if (hole := link[side]) is not None
            and (partner := link[1 - side]) is not None
            and (own.outer[hole], theirs.outer[partner]) == (ring, other)
        ]
        return Partner(theirs.rings[other], tuple(holes))

    def _outline_of(self, link: RingLink) -> RingLink:
        for outline, pieces in self.outlines.items():
            if all(
                ring is None or (shape.outer[ring] == own and _holds(piece, shape.rings[ring]))
                for ring, shape, own, piece in zip(link, self.shapes, outline, pieces, strict=True)
            ) and (None in link or None not in outline):
                return outline
        raise InvalidMarks(
            told("holes {i} and {j} are paired, but what they are holes in is not", i=link[0], j=link[1]),
            told("pair their outlines, or let one close to a point and the other grow from one"),
        )


def as_places(given: Places, what: str) -> Places:
    """Give the places of pairs of rings, in coordinates.

    Raises
    ------
    InvalidMarks
        Where they are none.
    """
    known = mapping(given, "places", "give a mapping from pairs of rings to (x, y)", InvalidMarks)
    return {link: point(place, what, InvalidMarks) for link, place in known.items()}


_MARKS = "give a list of marks for each ring of the source, empty where it has none"

_NAMES = ("source", "target")


def _holds(piece: Polygon | None, hole: Polygon) -> bool:
    return piece is not None and bool(
        shapely.contains_xy(shapely.Polygon(piece.vertices), *hole.vertices.T).all()
    )
