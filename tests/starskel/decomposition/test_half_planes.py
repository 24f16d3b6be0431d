import numpy as np
import pytest

from starskel.decomposition.kernels.clipping import boxes
from starskel.decomposition.kernels.half_planes import WIDE, Lines, left_of_all
from starskel.errors import Cancelled
from starskel.rings import Rings
from starskel.task import Task
from tests.families import blob, comb, spiral, subdivided, turned, two_opt

SQUARE = np.array([0, 2, 2 + 2j, 2j])


def numbers(ring):
    return np.ascontiguousarray(ring).view(np.complex128)[:, 0]


def round_all(*rings):
    return Lines.round(
        Rings.of(np.split(np.arange(sum(map(len, rings))), np.cumsum(list(map(len, rings)))[:-1])),
        np.concatenate(rings),
    )


def one_by_one(lines):
    """The areas of boxes that are cut along one line after the other."""
    areas = []
    for cell, count in enumerate(lines.counts):
        first = int(lines.counts[:cell].sum())
        left = boxes(np.array([-999 - 999j, 999 + 999j]), np.array([0]))
        for k in range(first, first + count):
            left = left.left_of(lines.start[[k]], (lines.start + lines.way)[[k]])
        areas.append(left.measured()[1][0])
    return areas


@pytest.mark.parametrize("most", [4, 9, 3 * WIDE])
def test_all_lines_at_once_leave_what_they_leave_one_after_the_other(most):
    rng = np.random.default_rng(most)
    counts = rng.integers(3, most + 1, 200)
    angles = rng.uniform(0, 2 * np.pi, counts.sum())
    way = rng.uniform(0.1, 2, counts.sum()) * np.exp(1j * angles)
    start = -1j * np.exp(1j * angles) * rng.uniform(-0.2, 3, counts.sum())
    lines = Lines(start, way, counts)
    areas = left_of_all(lines).measured()[1]
    wanted = np.array(one_by_one(lines))
    bounded = wanted < 50
    np.testing.assert_allclose(areas[bounded], wanted[bounded], rtol=1e-9, atol=1e-12)
    assert 20 < np.count_nonzero(wanted[bounded]) < 190 or most > WIDE


def test_the_corners_go_round_counter_clockwise_each_once():
    cells = left_of_all(round_all(SQUARE, SQUARE[[0, 1, 3]], 5 + SQUARE))
    assert cells.size.tolist() == [4, 3, 4]
    assert set(cells.corners[:4].round(9)) == set(SQUARE)
    np.testing.assert_allclose(cells.measured()[1], (4, 2, 4))


@pytest.mark.parametrize("angle", [0, 0.1, 0.3, 2.0, np.pi / 4])
def test_lines_on_top_of_each_other_bound_once(angle):
    bump = np.array([(0, 0), (6, 0), (6, 2), (4, 2), (4, 3), (2, 3), (2, 2), (0, 2)], dtype=float)
    ring = numbers(turned(subdivided(bump, 4), angle))
    _, (area,) = left_of_all(round_all(ring)).measured()
    np.testing.assert_allclose(area, 2 * 2)


def test_nothing_is_left_of_what_is_empty_and_a_point_of_what_is_a_point():
    through = Lines(np.zeros(3, dtype=complex), np.exp(2j * np.pi * np.arange(3) / 3), np.array([3]))
    cells = left_of_all(round_all(SQUARE[::-1], numbers(comb(4)), SQUARE))
    assert (cells.size == 0).tolist() == [True, True, False]
    alone = left_of_all(through)
    assert alone.size[0] > 0
    assert alone.measured()[1][0] < 1e-12


def test_lines_without_length_bound_nothing_and_no_bounds_leave_nothing():
    half = Lines(np.array([0j, 1j]), np.array([1 + 0j, -1 + 0j]), np.array([2]))
    assert left_of_all(half).size.tolist() == [0]
    doubled = np.repeat(SQUARE, 2)
    np.testing.assert_allclose(left_of_all(round_all(doubled)).measured()[1], [4])


def test_rings_of_many_vertices_are_thinned():
    ring = blob(3 * WIDE, depth=0.1)
    for shape in (ring, spiral(4 * WIDE, 2), subdivided(comb(2), WIDE)):
        lines = round_all(numbers(shape))
        np.testing.assert_allclose(left_of_all(lines).measured()[1], one_by_one(lines), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_cells_are_the_same_whatever_cells_there_are_besides(seed):
    """Straight runs make lines on top of each other, which rounding must not make both vanish."""
    rings = [numbers(turned(subdivided(two_opt(n, seed), 5), seed)) for n in (3, 4, 5, 6, 7, 12)]
    together = left_of_all(round_all(*rings)).measured()
    for cell, ring in enumerate(rings):
        alone = left_of_all(round_all(ring)).measured()
        assert together[0][cell] == alone[0][0]
        assert together[1][cell] == alone[1][0]
        np.testing.assert_allclose(alone[1], one_by_one(round_all(ring)), rtol=1e-6, atol=1e-6)


def test_it_can_be_stopped():
    with pytest.raises(Cancelled):
        left_of_all(round_all(SQUARE), Task(None, lambda: True))
