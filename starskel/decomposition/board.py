"""Where two polygons are cut: their points, to which Steiner vertices are added, and what is known of rings.

Points are only ever added, so what has been found out about a ring stays true. It is kept in tuples, of which
there may be many: the garbage collector does not look at them again.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence

import numpy as np

from starskel.arrays import Complex, Flags, Floats
from starskel.decomposition.kernels.kernel import are_seen_well_from, star_points, star_vertices
from starskel.decomposition.links import Links, links_of
from starskel.decomposition.pieces import Around, Piece, Replacements
from starskel.points import Points
from starskel.rings import Rings
from starskel.task import Task
from starskel.triangulation import Grounds, delaunay, triangulate

AT_ONCE = 1 << 12
"""Vertices of rings that are looked at between two questions whether to stop."""

SIDES_AT_ONCE = 1 << 16
"""Pairs of a vertex and an edge that are looked at between two such questions."""

TABLED_AT_ONCE = 400
"""Vertices of rings that are triangulated and tabled together: tables grow with their square."""


class Board:
    """Two polygons of n vertices, and Steiner vertices in both.

    Attributes
    ----------
    n : int
        Rows from here on are those of Steiner vertices.
    sides : list of Points
        The points of the source and of the target.
    unions : dict
        The rings round two neighbours, where that is known; None where that is no star piece.
    collapses : dict
        What may take the place of the pieces round a Steiner vertex, where that is known.
    in_vain : dict
        With which vertices chains make no rings with kernels, where that is known.
    """

    def __init__(self, source: Points, target: Points) -> None:
        self.n = len(source.coordinates)
        self.sides = [source, target]
        self.unions: dict[tuple[Piece, Piece], Piece | None] = {}
        self.collapses: dict[Around, Replacements] = {}
        self.in_vain: dict[Piece, tuple[int, ...]] = {}
        self._common: dict[Piece, bool] = {}
        self._kernels: dict[Piece, bool] = {}
        self._grounds: dict[tuple[Piece, ...], Grounds] = {}
        self._links: dict[tuple[Piece, ...], Links] = {}

    def __len__(self) -> int:
        return len(self.sides[0].coordinates)

    @property
    def at(self) -> Complex:
        """The (2, m) coordinates of all points, in the source and in the target."""
        return np.stack([side.coordinates.view(np.complex128)[:, 0] for side in self.sides])

    def place(self, source: Floats, target: Floats) -> range:
        """Add Steiner vertices at (k, 2) places in source and target; give their rows."""
        return self.add(self.sides[0].with_free(source), self.sides[1].with_free(target))

    def add(self, source: Points, target: Points) -> range:
        """Take points that begin with those there are, on both sides equally many; give the new rows."""
        before = len(self)
        self.sides = [source, target]
        return range(before, len(self))

    def are_stars(self, pieces: Sequence[Piece], task: Task) -> list[bool]:
        """Tell which simple rings of vertices have a common star vertex, or kernels with an inside."""
        common = self.have_common_star_vertices(pieces, task)
        left = [piece for piece, star in zip(pieces, common, strict=True) if not star]
        kernels = iter(self.have_kernels(left, task))
        return [star or next(kernels) for star in common]

    def have_common_star_vertices(self, pieces: Sequence[Piece], task: Task) -> list[bool]:
        """Tell for which simple rings one of their vertices sees the whole, in both polygons."""

        def find(pieces: list[Piece]) -> Flags:
            rings = Rings.of(pieces)
            stars = star_vertices(self.sides, rings, task.quiet)
            found: Flags = np.bincount(rings.owner[stars], minlength=len(pieces)) > 0
            return found

        unknown = {piece for piece in pieces if piece not in self._common}
        for part in handfuls(unknown, SIDES_AT_ONCE, lambda piece: len(piece) ** 2):
            task.quiet.reach(0)
            self._common.update(zip(part, find(part).tolist(), strict=True))
        return [self._common[piece] for piece in pieces]

    def have_kernels(self, pieces: Sequence[Piece], task: Task) -> list[bool]:
        """Tell which rings of vertices are simple, counter-clockwise and have kernels with an inside."""
        unknown = {piece for piece in pieces if piece not in self._kernels}
        for part in handfuls(unknown, AT_ONCE, len):
            task.quiet.reach(0)
            self._kernels.update(dict.fromkeys(part, False))
            left = part
            for side in self.sides:  # in the second polygon only what has kernels in the first
                ((_, areas),) = star_points([side], Rings.of(left), task.quiet)
                self._common.update((left[k], False) for k in np.flatnonzero(areas < 0).tolist())
                left = [left[k] for k in np.flatnonzero(areas > 0).tolist()]
            self._kernels.update(dict.fromkeys(left, True))
        return [self._kernels[piece] for piece in pieces]

    def note_kernels(self, pieces: Sequence[Piece], places: Sequence[Floats]) -> None:
        """Remember that rings have kernels where (k, 2) places in each polygon prove that, exactly."""
        if len(pieces):
            seen = are_seen_well_from(self.sides, Rings.of(pieces), places)
            self._kernels.update((piece, True) for piece, proven in zip(pieces, seen, strict=True) if proven)

    def triangulated(self, cells: Sequence[Piece], task: Task) -> Grounds:
        """Triangulate cells in both polygons; that takes long where they are large."""
        key = tuple(cells)
        if key not in self._grounds:
            rings = Rings.of(cells)
            task.reach(0)
            source = delaunay(self.sides[0], rings)
            task.reach(0)
            self._grounds[key] = source, delaunay(self.sides[1], rings)
        return self._grounds[key]

    def links(self, cells: Sequence[Piece], task: Task) -> Links:
        """Give what both polygons allow within cells."""
        key = tuple(cells)
        if key not in self._links:
            rings = Rings.of(cells)
            self._links[key] = links_of(
                triangulate(self.sides[0], rings), triangulate(self.sides[1], rings), task
            )
        return self._links[key]


def handfuls(rings: Iterable[Piece], most: int, work: Callable[[Piece], int]) -> Iterator[list[Piece]]:
    """Cut rings, the short ones first, into handfuls of less than so much work or of one ring."""
    handful: list[Piece] = []
    done = 0
    for ring in sorted(rings, key=lambda ring: (len(ring), ring)):
        if handful and done + work(ring) >= most:
            yield handful
            handful, done = [], 0
        handful.append(ring)
        done += work(ring)
    if handful:
        yield handful
