"""Bridges are the same however a pair of regions is given: compared by the places where they end and bend."""

from dataclasses import replace

import numpy as np
import pytest

from starskel.polar import as_complex, as_points
from starskel.shapes.holes.bridges import chain_of
from starskel.shapes.holes.reading import RegionReading
from starskel.task import UNWATCHED
from tests.starskel.shapes.regions import holed_pair

SEEDS = (2, 3, 7, 15)


def pair_of(seed):
    (part,) = holed_pair(seed).parts
    return part.pair


def taken(pair, rows, starts):
    """The pair with its rows in another order."""
    return replace(pair, source=pair.source[rows], target=pair.target[rows], starts=starts)


def shifted(pair):
    """Each ring from its third vertex on."""
    rings = np.split(np.arange(len(pair)), pair.starts[1:])
    return taken(pair, np.concatenate([np.roll(ring, -3) for ring in rings]), pair.starts)


def reordered(pair):
    """The holes from the last to the first."""
    outline, *holes = np.split(np.arange(len(pair)), pair.starts[1:])
    rings = [outline, *holes[::-1]]
    return taken(pair, np.concatenate(rings), tuple(np.cumsum([0, *map(len, rings[:-1])]).tolist()))


def mirrored(pair):
    rings = np.split(np.arange(len(pair)), pair.starts[1:])
    other = taken(pair, np.concatenate([ring[::-1] for ring in rings]), pair.starts)
    return replace(other, source=other.source * [-1, 1], target=other.target * [-1, 1])


def moved(pair, factor):
    """Both regions scaled and turned round the coordinates' origin, then shifted."""
    source, target = (as_points(factor * (as_complex(rows) + 5)) for rows in (pair.source, pair.target))
    return replace(pair, source=source, target=target)


def ways(pair, undone=lambda side, points: points):
    """The bridges of a pair as the places that they lead over, in source and target, put back."""
    chain = chain_of(pair, UNWATCHED)
    sides = [
        undone(side, np.concatenate([rows, bends]))
        for side, (rows, bends) in enumerate(zip((pair.source, pair.target), chain.bends, strict=True))
    ]
    bends = np.split(len(pair) + np.arange(sum(chain.counts)), np.cumsum(chain.counts)[:-1])
    return [
        [side[[start, *own, end]] for side in sides]
        for (start, end), own in zip(chain.bridges, bends, strict=True)
    ]


def assert_same(found, expected):
    for one, other in zip(found, expected, strict=True):
        for mine, theirs in zip(one, other, strict=True):
            np.testing.assert_allclose(mine, theirs, atol=1e-7)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("given", [shifted, reordered])
def test_where_rings_begin_and_which_comes_first_does_not_matter(seed, given):
    pair = pair_of(seed)
    assert_same(ways(given(pair)), ways(pair))


@pytest.mark.parametrize("seed", SEEDS)
def test_exchanged_regions_have_the_same_bridges(seed):
    pair = pair_of(seed)
    assert_same([way[::-1] for way in ways(pair.exchanged)], ways(pair))


@pytest.mark.parametrize("seed", SEEDS)
def test_mirrored_regions_have_the_mirrored_bridges(seed):
    pair = pair_of(seed)
    assert_same(ways(mirrored(pair), lambda _, points: points * [-1, 1]), ways(pair))


@pytest.mark.parametrize("factor", [0.37 * np.exp(2j), 1e6, 1e-6])
@pytest.mark.parametrize("seed", SEEDS)
def test_regions_that_are_scaled_and_turned_have_the_same_bridges(seed, factor):
    """Of two links that a bend has made equally long rounding chose the one to be bent next."""
    pair = pair_of(seed)

    def undone(_, points):
        return as_points(as_complex(points) / factor - 5)

    assert_same(ways(moved(pair, factor), undone), ways(pair))


def test_what_is_as_far_out_is_told_apart_by_coordinates():
    """Two squares with a square hole each, all turned by quarters, are read from the same corner."""
    square = np.array([(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)])
    pair = replace(pair_of(4), source=np.concatenate([2 * square, square[::-1]]), starts=(0, 4))
    pair = replace(pair, target=pair.source)
    read = RegionReading.of(pair).read(pair)
    again = RegionReading.of(shift := taken(pair, [1, 2, 3, 0, 6, 7, 4, 5], (0, 4))).read(shift)
    np.testing.assert_array_equal(read.source, again.source)
