import numpy as np
import pytest

from starskel.decomposition.kernel import star_points
from starskel.decomposition.ladder import by_fan, climb
from starskel.decomposition.shape import shaped
from starskel.decomposition.tiling import Tiling
from starskel.errors import Cancelled
from starskel.outline import edge_lengths, signed_areas
from starskel.points import points_of
from starskel.rings import Rings
from starskel.task import UNWATCHED, Task
from tests.families import two_opt

SEEDS = [2, 3, 4, 5]


def climbed(seed):
    source, target = two_opt(20, seed), two_opt(20, seed + 1000)
    whole = tuple(range(20))
    return climb(Tiling(points_of(source), points_of(target), (whole,)), whole, by_fan, UNWATCHED)


def roundness(tiling):
    """The area of each kernel, in the source and in the target, over the square of its piece's perimeter."""
    rings = [np.array(piece) for piece in tiling.pieces]
    sides = []
    for points in (tiling.source, tiling.target):
        _, areas = star_points(points, Rings.of(rings))
        sides.append(areas / [edge_lengths(points.coordinates[ring]).sum() ** 2 for ring in rings])
    return np.array(sides)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_smallest_kernels_grow(seed):
    before = climbed(seed)
    after = shaped(before, 20, UNWATCHED)
    assert len(after.pieces) == len(before.pieces)
    assert (roundness(after).min(axis=1) >= roundness(before).min(axis=1)).all()
    assert (roundness(after) > 0).all()


def test_some_grow_by_much():
    gains = [roundness(shaped(climbed(s), 20, UNWATCHED)).min() / roundness(climbed(s)).min() for s in SEEDS]
    assert max(gains) > 3


@pytest.mark.parametrize("seed", SEEDS)
def test_the_pieces_still_tile_both_polygons(seed):
    tiling = shaped(climbed(seed), 20, UNWATCHED)
    for points in (tiling.source, tiling.target):
        whole = signed_areas(points.coordinates[:20])
        parts = [signed_areas(points.coordinates[list(piece)]) for piece in tiling.pieces]
        assert min(parts) > 0
        assert sum(parts) == pytest.approx(float(whole), rel=1e-9)


def test_what_has_no_steiner_vertex_stays_as_it_is():
    ring = points_of(two_opt(12, 1))
    tiling = Tiling(ring, ring, (tuple(range(12)),))
    assert shaped(tiling, 12, UNWATCHED) is tiling


def test_it_can_be_stopped():
    with pytest.raises(Cancelled):
        shaped(climbed(2), 20, Task(should_stop=lambda: True))
