import numpy as np
import pytest
import shapely

from app.model.density import kept_vertices, refined
from starskel.arrays import Floats
from starskel.polygon import Polygon

SQUARE = np.array([(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)])


def shaky_circle(seed: int, count: int = 80) -> Floats:
    angles = 2 * np.pi * np.arange(count) / count
    radii = 10 + np.random.default_rng(seed).normal(0, 0.2, count)
    return np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("tolerance", [0.0, 0.3, 1.0, 100.0])
def test_what_is_kept_is_a_simple_polygon_near_the_drawn_one(seed: int, tolerance: float) -> None:
    ring = shaky_circle(seed)
    kept = kept_vertices(ring, tolerance, pinned=(7,))
    assert {0, 7} <= set(kept.tolist())
    simpler = Polygon(ring[kept])
    gone = shapely.points(np.delete(ring, kept, axis=0))
    outline = shapely.LinearRing(simpler.vertices)
    assert (shapely.distance(gone, outline) <= tolerance).all()
    assert len(kept) == len(ring) if tolerance == 0 else len(kept) < len(ring)


def test_a_deep_slit_is_not_closed_over_by_its_other_wall() -> None:
    ring = np.array(
        [(0, 0), (4, 0.3), (5, -1), (6, 0.3), (10, 0), (10, 3), (5.5, 3), (5, -0.5), (4.5, 3), (0, 3)]
    )
    assert Polygon(ring[kept_vertices(ring, 2.0)])


def test_vertices_are_added_where_edges_are_longest() -> None:
    ring = np.array([(0.0, 0.0), (12.0, 0.0), (12.0, 4.0), (0.0, 4.0)])
    finer, places = refined(ring, 4)
    assert finer.tolist() == [[0, 0], [4, 0], [8, 0], [12, 0], [12, 4], [8, 4], [4, 4], [0, 4]]
    assert places.tolist() == [0, 3, 4, 7]


def test_only_the_edges_named_are_divided() -> None:
    finer, places = refined(SQUARE, 3, edges=[1])
    assert finer.tolist() == [[0, 0], [8, 0], [8, 2], [8, 4], [8, 6], [8, 8], [0, 8]]
    assert places.tolist() == [0, 1, 5, 6]


def test_nothing_to_divide_adds_nothing() -> None:
    finer, places = refined(SQUARE, 3, edges=[])
    assert finer.tolist() == SQUARE.tolist()
    assert places.tolist() == [0, 1, 2, 3]
