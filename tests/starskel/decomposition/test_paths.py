from itertools import combinations

import numpy as np
import pytest
import shapely

from starskel.crossings import crossing_edges
from starskel.decomposition.transfer.paths import bends_between
from starskel.decomposition.transfer.sightlines import Places, sightlines
from starskel.points import points_of
from starskel.rings import Rings
from starskel.task import UNWATCHED
from starskel.triangulation import triangulate
from starskel.visibility import visibility
from tests.families import comb


def bends(ring, start, end):
    (found,) = bends_between(
        points_of(ring), Rings.of([range(len(ring))]), np.array([start]), np.array([end]), UNWATCHED
    )
    assert found is not None
    return found


def test_paths_that_are_found_together_are_those_found_alone(ring):
    points, whole = points_of(ring), np.arange(len(ring))
    wanted = apart(ring)[::7]
    rings = Rings.of([np.roll(whole, -shift) for shift in range(len(wanted))])
    ends = (
        np.array([[(v - k) % len(ring) for v in cut] for k, cut in enumerate(wanted)]) + rings.first[:, None]
    )
    together = bends_between(points, rings, *ends.T, UNWATCHED)
    assert len(together) > 2
    for (row, _), (start, end), path in zip(
        rings.parts(), ends - rings.first[:, None], together, strict=True
    ):
        alone = bends_between(points, Rings.of([row]), np.array([start]), np.array([end]), UNWATCHED)
        np.testing.assert_array_equal(path, alone[0])


def apart(ring):
    n = len(ring)
    return [(i, j) for i in range(0, n, 3) for j in range(i + 2, n, 2) if (j + 1) % n != i]


def test_a_path_cuts_the_ring_into_two_simple_rings(ring):
    for i, j in apart(ring):
        path = bends(ring, i, j)
        halves = (
            np.concatenate([ring[i : j + 1], path[::-1]]),
            np.concatenate([ring[: i + 1], path, ring[j:]]),
        )
        areas = []
        for half in halves:
            assert not len(crossing_edges(half))
            areas.append(shapely.Polygon(half).area)
        assert sum(areas) == pytest.approx(shapely.Polygon(ring).area)


def test_a_diagonal_is_a_path_without_bends_and_nothing_else_is(ring):
    diagonal = visibility(triangulate(points_of(ring), Rings.of([range(len(ring))]))).diagonal
    for i, j in apart(ring):
        assert (len(bends(ring, i, j)) == 0) == diagonal[i, j]


def test_no_link_of_a_path_can_be_skipped(ring):
    inside = shapely.Polygon(ring).buffer(-1e-9)
    for i, j in apart(ring):
        path = np.array([ring[i], *bends(ring, i, j), ring[j]])
        links = [path[[a, b]] for a, b in combinations(range(len(path)), 2) if b - a > 1]
        assert not any(inside.contains(shapely.LineString(0.999 * p + 0.001 * p[::-1])) for p in links)


def test_a_path_round_one_corner_has_one_bend():
    corner = np.array([(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4)], dtype=float)
    assert len(bends(corner, 2, 4)) == 1


def test_paths_keep_clear_of_corners():
    corridor = np.array([(0, 0), (10, 0), (10, 1), (6, 1), (5, 0.1), (4, 1), (0, 1)], dtype=float)
    path = shapely.LineString([corridor[0], *bends(corridor, 0, 2), corridor[2]])
    assert path.distance(shapely.Point(corridor[4])) > 0.01


def random_places(ground, count):
    rng = np.random.default_rng(count)
    triangle = np.sort(rng.integers(len(ground.triangles), size=count))
    weights = rng.dirichlet((1, 1, 1), count)
    places = np.einsum("ps,psx->px", weights, ground.vertices[ground.triangles[triangle]])
    points = ground.points.with_free(places)
    rows = len(ground.points.start) + np.arange(count)
    return Places(points, rows, np.arange(count), triangle)


def test_places_see_each_other_where_the_polygon_covers_the_segment(ring):
    ground = triangulate(points_of(ring), Rings.of([range(len(ring))]))
    places = random_places(ground, 60)
    sees = sightlines(ground, places, UNWATCHED)
    at = places.points.coordinates[places.rows]
    i, j = np.triu_indices(60, 1)
    segments = shapely.linestrings(np.stack([at[i], at[j]], axis=1))
    np.testing.assert_array_equal(sees[i, j], shapely.covers(shapely.Polygon(ring), segments))
    assert sees.all(axis=0).sum() < 60
    np.testing.assert_array_equal(sees, sees.T)


def test_a_place_outside_its_triangle_sees_nothing():
    ground = triangulate(points_of(comb(3)), Rings.of([range(len(comb(3)))]))
    points = ground.points.with_free(np.array([(-5.0, -5.0), (0.5, 0.5)]))
    rows = len(ground.points.start) + np.arange(2)
    assert not sightlines(ground, Places(points, rows, np.arange(2), np.array([0, 0])), UNWATCHED)[0, 1]


def test_a_path_does_not_cross_itself():
    ring = np.array(
        [
            [7.1, 20.8],
            [6.0, 28.9],
            [8.6, 46.3],
            [9.5, 34.7],
            [14.5, 52.0],
            [22.4, 32.8],
            [11.1, 23.4],
            [31.2, 34.3],
            [42.6, 38.0],
            [54.6, 26.9],
            [56.2, 22.1],
            [75.4, 9.7],
            [68.9, 16.9],
            [67.3, 20.7],
            [67.0, 17.5],
            [61.4, 19.9],
            [60.4, 29.6],
            [55.1, 38.6],
            [55.3, 38.6],
            [66.7, 30.0],
            [54.8, 39.4],
            [46.6, 34.6],
            [42.3, 38.5],
            [28.1, 34.0],
            [12.0, 56.8],
            [9.8, 52.2],
            [5.1, 30.5],
        ]
    )
    path = np.concatenate([ring[[2]], bends(ring, 2, 16), ring[[16]]])
    assert shapely.LineString(path).is_simple
