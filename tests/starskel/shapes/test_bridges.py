"""Bridges: however holes lie, both regions fall into two simple polygons; shapely is the judge."""

from functools import cache

import numpy as np
import pytest
import shapely

from starskel.decomposition.verify import faults
from starskel.shapes.holes.bridges import chain_of, halves
from starskel.shapes.holes.pieces import decompose_region
from starskel.task import UNWATCHED
from tests.starskel.shapes.regions import holed_pair

SEEDS = range(12)


@cache
def pair_of(seed: int):
    (part,) = holed_pair(seed).parts
    return part.pair


@cache
def chain_through(seed: int):
    return chain_of(pair_of(seed), UNWATCHED)


@pytest.mark.parametrize("seed", SEEDS)
def test_random_regions_fall_into_two_simple_polygons(seed):
    pair = pair_of(seed)
    chain = chain_through(seed)
    for rows, bends in zip((pair.source, pair.target), chain.bends, strict=True):
        points = np.concatenate([rows, bends])
        outline, *inner = np.split(rows, pair.starts[1:])
        region = shapely.Polygon(outline, inner)
        both = [shapely.Polygon(points[half]) for half in halves(pair, chain)]
        assert all(half.is_valid and half.exterior.is_ccw for half in both)
        assert both[0].intersection(both[1]).area < 1e-9 * region.area
        assert shapely.union_all(both).symmetric_difference(region).area < 1e-9 * region.area


def test_some_of_them_need_bridges_that_bend():
    bent = [sum(chain_through(seed).counts) for seed in SEEDS]
    assert 2 < np.count_nonzero(bent) < 10


@pytest.mark.parametrize("seed", [5])
def test_star_pieces_on_both_sides_of_bent_bridges_are_proven(seed):
    pair = pair_of(seed)
    assert sum(chain_through(seed).counts)
    assert faults(decompose_region(pair, UNWATCHED)) == []
