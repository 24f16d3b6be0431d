"""Step: the way from one key shape to the next, as a project holds it."""

from dataclasses import dataclass, replace

from starskel.correspondence.marks import Mark, checked_marks
from starskel.easing import EVEN, Easing
from starskel.errors import InvalidMarks, told
from starskel.files.projects.key_shape import KeyShape

Point = tuple[float, float]


@dataclass(frozen=True)
class Link:
    """A part of the shape before and the part of the shape behind that it becomes.

    Attributes
    ----------
    source, target : int or None
        The numbers of the parts; None beside a part that shrinks to a point, or grows from one.
    marks : tuple of (int, int)
        A vertex of the one, a vertex of the other.
    place : (float, float) or None
        The point that a part without a partner shrinks to or grows from; None leaves it to the method.
    root : (float, float) or None
        The star origin of the source nearest to this place is the root of the part's star-skeleton; None
        leaves the choice to the method.
    """

    source: int | None = None
    target: int | None = None
    marks: tuple[Mark, ...] = ()
    place: Point | None = None
    root: Point | None = None

    @property
    def ends(self) -> tuple[int | None, int | None]:
        """Both parts."""
        return self.source, self.target

    @property
    def alone(self) -> bool:
        """Whether a part has no partner here."""
        return None in self.ends

    @property
    def reversed(self) -> "Link":
        """The way back; which origin is the root is open again, since it was chosen on the other shape."""
        marks = tuple((target, source) for source, target in self.marks)
        return replace(self, source=self.target, target=self.source, marks=marks, root=None)


@dataclass(frozen=True)
class Step:
    """The way from one key shape to the next.

    Attributes
    ----------
    links : tuple of Link
        What becomes of every part. The order is that in which frames are painted, the first at the bottom.
    duration : float
        How long it takes; the usual length is 1.
    easing : Easing
        How t runs over that time.
    turns : int
        Whole turns that the star-skeleton makes besides, counter-clockwise; of several parts all methods do.
    joined : bool
        Whether parts move together; else each by itself.
    """

    links: tuple[Link, ...] = ()
    duration: float = 1.0
    easing: Easing = EVEN
    turns: int = 0
    joined: bool = True

    @classmethod
    def of(cls, marks: tuple[Mark, ...] = ()) -> "Step":
        """Give the usual step between two shapes of one part."""
        return cls((Link(0, 0, marks),))

    @property
    def roots(self) -> dict[tuple[int | None, int | None], Point]:
        """For links whose root is chosen its place, as `starskel.blend` takes them."""
        return {link.ends: link.root for link in self.links if link.root is not None}

    def marks_by_part(self, count: int) -> tuple[tuple[Mark, ...], ...]:
        """Give the marks of each of so many parts of the source."""
        return tuple(
            tuple(mark for link in self.links if link.source == part for mark in link.marks)
            for part in range(count)
        )

    @property
    def reversed(self) -> "Step":
        """The way back."""
        links = tuple(link.reversed for link in self.links)
        return replace(self, links=links, easing=self.easing.reversed, turns=-self.turns)

    def check(self, source: KeyShape, target: KeyShape) -> None:
        """Check that all parts of two shapes, and no others, are linked, and that the marks fit them.

        Raises
        ------
        InvalidMarks
            Saying what does not fit.
        """
        for side, shape in enumerate((source, target)):
            linked = {number for link in self.links if (number := link.ends[side]) is not None}
            if linked != set(range(len(shape))):
                raise InvalidMarks(
                    told("the links name parts that are not there, or leave some out"),
                    told("give each part a partner, or null where it has none"),
                )
        for link in self.links:
            if link.source is not None and link.target is not None:
                checked_marks(source.rings[link.source], target.rings[link.target], link.marks)
            elif link.marks:
                raise InvalidMarks(
                    told("there are marks, but not both shapes"), told("draw both shapes first"), link.marks
                )
