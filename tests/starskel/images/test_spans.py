import numpy as np
import shapely
from hypothesis import given
from hypothesis import strategies as st

from starskel.images.spans import spans_of

SIZE = 24, 20


def painted(points, triangles):
    counts = np.zeros(SIZE[0] * SIZE[1], dtype=int)
    spans = spans_of(points, triangles, points, SIZE)
    for first, count in zip(spans.first, spans.counts, strict=True):
        counts[first : first + count] += 1
    return counts.reshape(SIZE[1], SIZE[0]), spans


def fan(seed, n=9):
    rng = np.random.default_rng(seed)
    ways = np.exp(2j * np.pi * (np.arange(n) + 0.4 * rng.random(n)) / n) * (rng.random(n) * 12 + 4)
    ring = np.concatenate([ways + 12 + 10j, [12 + 10j]])
    triangles = np.array([(n, k, (k + 1) % n) for k in range(n)])
    return np.stack([ring.real, ring.imag], axis=1), triangles


@given(st.integers(0, 10_000), st.booleans())
def test_each_pixel_whose_middle_is_inside_is_taken_once(seed, whole):
    points, triangles = fan(seed)
    if whole:
        points = np.floor(points) + 0.5  # corners and edges on the middles of pixels: the hard case
    counts, _ = painted(points, triangles)
    x, y = np.meshgrid(np.arange(SIZE[0]) + 0.5, np.arange(SIZE[1]) + 0.5)
    polygon = shapely.Polygon(points[:-1])
    if polygon.is_valid:
        assert counts.max() <= 1
        assert (counts[shapely.contains_xy(polygon, x, y)] == 1).all()
        assert (counts[shapely.distance(polygon, shapely.points(x, y)) > 0] == 0).all()


def test_values_are_those_of_the_places():
    points, triangles = fan(5)
    _, spans = painted(points, triangles)
    for run in range(len(spans)):
        at = np.arange(spans.counts[run])
        row, column = divmod(spans.first[run] + at, SIZE[0])
        found = spans.start[:, run, None] + at * spans.step[:, run, None]
        assert np.abs(found - (column + 0.5, row + 0.5)).max() < 1e-9


def test_values_stay_within_those_at_the_corners_of_the_thinnest_triangles():
    points = np.array([(0.0, 0.5), (23.0, 10.5), (23.0, 10.5 + 1e-13), (11.5, 5.5)])
    triangles = np.array([(0, 1, 2), (0, 3, 2)])
    spans = spans_of(points, triangles, np.array([[0.0], [1.0], [1.0], [0.5]]), SIZE)
    ends = spans.start + (spans.counts - 1) * spans.step
    for values in (spans.start, ends):
        assert ((values > -1e-6) & (values < 1 + 1e-6)).all()
