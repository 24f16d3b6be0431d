"""Step: the way from one key shape to the next, as a project holds it."""

from dataclasses import dataclass, replace

from starskel.correspondence.marks import Mark
from starskel.easing import EVEN, Easing


@dataclass(frozen=True)
class Step:
    """The way from one key shape to the next.

    Attributes
    ----------
    marks : tuple of (int, int)
        A vertex of the shape before, a vertex of the shape behind; none while one of them is missing.
    duration : float
        How long it takes; the usual length is 1.
    easing : Easing
        How t runs over that time.
    root : (float, float) or None
        The star origin of the source nearest to this place is the root of the star-skeleton; None leaves the
        choice to the method.
    turns : int
        Whole turns that the star-skeleton makes besides, counter-clockwise.
    """

    marks: tuple[Mark, ...] = ()
    duration: float = 1.0
    easing: Easing = EVEN
    root: tuple[float, float] | None = None
    turns: int = 0

    @property
    def reversed(self) -> "Step":
        """The way back; which origin is the root is open again, since it was chosen on the other shape."""
        marks = tuple((target, source) for source, target in self.marks)
        return replace(self, marks=marks, easing=self.easing.reversed, root=None, turns=-self.turns)
