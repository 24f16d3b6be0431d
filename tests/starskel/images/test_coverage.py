import numpy as np
import pytest
import shapely

from starskel.images.coverage import coverage_of

WIDTH, HEIGHT = 16, 14
CELLS = shapely.box(
    *np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT)),
    *np.meshgrid(np.arange(1, WIDTH + 1), np.arange(1, HEIGHT + 1)),
)


def shares_of(*rings):
    starts = np.concatenate(rings)
    ends = np.concatenate([np.roll(ring, -1, axis=0) for ring in rings])
    coverage = coverage_of(starts, ends, (WIDTH, HEIGHT))
    shares = coverage.inside().astype(float)
    shares[coverage.pixels] = coverage.shares
    return shares.reshape(HEIGHT, WIDTH)


def star(seed, whole):
    rng = np.random.default_rng(seed)
    n = rng.integers(5, 12)
    ways = np.exp(2j * np.pi * (np.arange(n) + 0.4 * rng.random(n)) / n)
    ring = 8 + 7j + ways * (rng.random(n) * 11 + 2)
    points = np.stack([ring.real, ring.imag], axis=1)
    return points.round() if whole else points


@pytest.mark.parametrize("whole", [False, True])
@pytest.mark.parametrize("seed", range(20))
def test_shares_are_the_areas_that_shapely_finds(seed, whole):
    ring = star(seed, whole)
    polygon = shapely.Polygon(ring)
    if not polygon.is_valid:
        pytest.skip("rounding made it touch itself")
    wanted = shapely.area(shapely.intersection(polygon, CELLS))
    assert np.abs(shares_of(ring) - wanted).max() < 1e-9
    assert np.abs(shares_of(ring[::-1]) - wanted).max() < 1e-9


def test_holes_are_left_out():
    outline = np.array([(1, 1), (13.5, 2), (12, 12.25), (2, 11)])
    hole = np.array([(4.5, 4), (5, 9), (9, 8.5)])
    wanted = shapely.area(shapely.intersection(shapely.Polygon(outline, [hole]), CELLS))
    assert np.abs(shares_of(outline, hole) - wanted).max() < 1e-9


def test_what_is_gone_round_twice_counts_once():
    square = np.array([(2.5, 2), (9, 2), (9, 8.5), (2.5, 8.5)])
    other = square + np.array([2, 1])
    union = shapely.union(shapely.Polygon(square), shapely.Polygon(other))
    off = np.abs(shares_of(square, other) - shapely.area(shapely.intersection(union, CELLS)))
    edges = shapely.intersects(
        CELLS, shapely.intersection(*(shapely.Polygon(r).exterior for r in (square, other)))
    )
    assert off[~edges].max() < 1e-9


def test_every_pixel_on_the_outline_names_a_place_on_it():
    ring = star(3, whole=False)
    ends = np.roll(ring, -1, axis=0)
    coverage = coverage_of(ring, ends, (WIDTH, HEIGHT))
    edges, shares = coverage.edges, coverage.places[:, None]
    places = ring[edges] + shares * (ends - ring)[edges]
    assert (
        np.abs(places - (coverage.pixels[:, None] // (1, WIDTH) % (WIDTH, HEIGHT) + 0.5)) < 0.5 + 1e-9
    ).all()
    partly = np.flatnonzero((shares_of(ring).ravel() % 1) > 1e-9)
    assert set(partly) <= set(coverage.pixels)
