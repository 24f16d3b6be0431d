import numpy as np
import pytest

from starskel.outline import signed_areas
from starskel.points import points_of
from starskel.rings import Rings
from starskel.triangulation import triangulate
from starskel.visibility.cells import cells_of
from tests.families import blob, comb, spiral, subdivided, turned, two_opt

RINGS = {
    "triangle": np.array([(0, 0), (1, 0), (0, 1)], dtype=float),
    "smooth": blob(40, 1),
    "random": two_opt(30, 1),
    "full grid": two_opt(25, 2, 5),
    "comb": comb(6),
    "spiral": spiral(40),
    "straight runs": turned(subdivided(two_opt(8, 3), 4), 0.3),
}


@pytest.fixture(params=RINGS)
def ground(request):
    ring = RINGS[request.param]
    return triangulate(points_of(ring), Rings.of([range(len(ring))]))


def corners_of_all(cells):
    starts, sizes = cells.first, cells.others[cells.first] + 1
    rounds = {
        tuple(sorted(cells.corner[s : s + k].tolist())): (s, k) for s, k in zip(starts, sizes, strict=True)
    }
    return [cells.corner[s : s + k] for s, k in rounds.values()]


def test_cells_are_convex_and_tile_the_ring(ground):
    found = corners_of_all(cells_of(ground))
    for corners in found:
        turns = ground.points.orientation(corners, np.roll(corners, -1), np.roll(corners, -2))
        assert (turns >= 0).all()
    assert sum(len(corners) - 2 for corners in found) == len(ground.triangles)
    areas = sum(signed_areas(ground.vertices[corners]) for corners in found)
    assert areas == pytest.approx(signed_areas(ground.vertices))


def test_walks_behind_a_side_pass_the_other_sides_of_the_cell_behind(ground):
    cells = cells_of(ground)
    n = len(ground.rings.rows)
    for place in cells.first:
        side = cells.corner[place], cells.corner[place + 1]
        start = cells.behind[place]
        if start < 0:
            assert side[1] == (side[0] + 1) % n
        else:
            end = start + cells.others[start]
            assert (cells.corner[end], cells.corner[start]) == side[::-1]


def test_each_triangle_is_part_of_its_cell(ground):
    cells = cells_of(ground)
    for triangle, place in zip(ground.triangles, cells.of_triangle, strict=True):
        assert set(triangle) <= set(cells.corner[place : place + cells.others[place] + 1].tolist())


def test_what_is_convex_is_one_cell_and_a_comb_little_more_than_its_teeth():
    angles = np.linspace(0, 2 * np.pi, 30, endpoint=False)
    ring = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    assert cells_of(triangulate(points_of(ring), Rings.of([range(30)]))).others[0] == 29
    teeth = comb(12)
    ground = triangulate(points_of(teeth), Rings.of([range(len(teeth))]))
    assert len(corners_of_all(cells_of(ground))) < 2 * 12
