"""What a complete correspondence is."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from starskel.predicates import Floats


@dataclass(frozen=True, eq=False)
class Correspondence:
    """Two polygons with equally many vertices, row i of the one corresponding to row i of the other.

    Attributes
    ----------
    source, target : (n, 2) arrays
        The rings, counter-clockwise, with the inserted vertices; row 0 of the source is its vertex 0.
    marks : tuple of (int, int)
        The marks as given: a vertex of the source polygon, a vertex of the target polygon.
    source_vertices, target_vertices : (n,) arrays of int
        For each row the vertex of the polygon, or -1 where the row was inserted.
    """

    source: Floats
    target: Floats
    marks: tuple[tuple[int, int], ...]
    source_vertices: NDArray[np.intp]
    target_vertices: NDArray[np.intp]

    def __len__(self) -> int:
        return len(self.source)
