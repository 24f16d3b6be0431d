import numpy as np

from app.model.strokes import closed
from starskel.crossings import crossing_edges
from starskel.polygon import Polygon


def test_a_line_whose_ends_cross_is_cut_at_the_crossing() -> None:
    line = np.array([(-1.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, -1.0)])
    assert closed(line).tolist() == [[0, 0], [10, 0], [10, 10], [0, 10]]


def test_a_line_that_does_not_cross_itself_stays() -> None:
    line = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (1.0, 9.0)])
    assert closed(line).tolist() == line.tolist()


def test_a_line_that_ends_where_it_began_is_closed_there() -> None:
    line = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 0.0)])
    assert len(Polygon(closed(line))) == 3


def test_a_line_that_goes_on_along_its_own_start_ends_where_it_came_back() -> None:
    angles = np.linspace(0, 2 * np.pi + 0.06, 120)
    line = 100 * np.stack([1.5 * np.cos(angles), np.sin(angles)], axis=1)
    line[-4:] += 0.3  # beside the start, not on it
    ring = Polygon(closed(line, 10.0))
    assert abs(ring.area / (np.pi * 15000) - 1) < 0.01
    edges = np.hypot(*(np.roll(ring.vertices, -1, axis=0) - ring.vertices).T)
    assert edges.min() > 1


def test_a_figure_of_eight_stays_crossed() -> None:
    line = np.array([(0.0, 0.0), (10.0, 10.0), (10.0, 0.0), (0.0, 10.0)])
    assert len(crossing_edges(closed(line)))


def test_a_loop_drawn_twice_loses_no_more_than_its_ends() -> None:
    angles = np.linspace(0, 2.3 * np.pi, 60)
    line = np.stack([(10 + angles) * np.cos(angles), (10 + angles) * np.sin(angles)], axis=1)
    line[-12:] *= 0.6
    ring = Polygon(closed(line))
    assert ring.area > 300


def test_small_loops_on_the_way_go() -> None:
    line = np.array([(0, 0), (10, 0), (10, 6), (9, 5), (11, 5), (10, 10), (0, 10)], dtype=float)
    ring = Polygon(closed(line))
    assert ring.area > 95
