"""Extreme coordinates: a correct result by every method, or a clear refusal, and never a warning."""

from functools import partial

import numpy as np
import pytest

import starskel
from starskel.decomposition.verify import faults

L = np.array([(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4)], dtype=float)
U = np.array([(0, 0), (5, 0), (5, 4), (4, 4), (4, 1), (1, 1), (1, 4), (0, 4)], dtype=float)
SPIKE = np.array([(0, 0), (4, 0), (4, 1), (2, 1), (2 + 1e-9, 50), (2 - 1e-9, 1), (0, 1)])
NEEDLE = np.array([(0, 0), (1e6, 1e-6), (1e6, 2e-6), (0, 1)])
SLIVER = np.array([(0, 0), (1, 0), (1, 1e-12), (0, 1e-12)])
FLAT = np.array([(0, 0), (1, 1e-9), (2, 0), (1, 2e-9)])
WAVES = np.array([(k, k % 2 * 1e-10) for k in range(20)] + [(19 - k, 1 + k % 2 * 1e-10) for k in range(20)])
STRAIGHT = np.concatenate(
    [[(t, 0), (4, t), (4 - t, 4), (0, 4 - t)] for t in np.linspace(0, 4, 60, endpoint=False)]
)[np.arange(240).reshape(60, 4).T.ravel()]

PAIRS = {
    **{f"times {size:g}": (L * size, U * size) for size in (1e-12, 1e-6, 1e6, 1e12, 1e70, 1e-70)},
    **{f"{far:g} away": (L + far, U + np.array((far, -far))) for far in (1e9, -1e9)},
    "one far away": (L + 1e12, U),
    "tiny and huge": (L * 1e-12, U * 1e12),
    "spikes": (SPIKE, U),
    "needles": (NEEDLE, NEEDLE[::-1] * [1, -1] + 3),
    "a sliver": (SLIVER, L),
    "nearly flat": (FLAT, FLAT @ [[0, 1], [-1, 0]]),
    "nearly straight": (WAVES, WAVES[:, ::-1] * [1, -1]),
    "collinear": (STRAIGHT, U),
}


@pytest.mark.parametrize(("source", "target"), PAIRS.values(), ids=PAIRS)
def test_every_method_is_right_at_both_ends_and_finite_between(source, target):
    pair = starskel.match(source, target, marks=[(0, 0)])
    assert not faults(starskel.decompose(pair))
    for method in starskel.METHODS:
        blend = starskel.blend(pair, method=method)
        assert np.isfinite(blend.frames([1e-12, 0.3, 0.5, 1 - 1e-12])).all()
        for t, ring in ((0, blend.pair.source), (1, blend.pair.target)):
            rounding = 4 * np.spacing(np.abs(ring).max())
            assert np.abs(blend.at(t) - ring).max() <= 1e-9 * np.ptp(ring, axis=0).max() + rounding
        report = starskel.measure(blend, frames=5)
        assert np.isfinite([report.area_deviation, report.length_deviation, report.angle_deviation]).all()


@pytest.mark.parametrize(
    "ring", [L * 1e-6 + 1e9, np.array([(0, 0), (1e-12, 0), (1e12, 1e12), (0, 1e-12)])], ids=["0", "1"]
)
def test_what_rounding_would_decide_is_refused(ring):
    with pytest.raises(starskel.InvalidPolygon, match=r"all but touches edge .*move it away"):
        starskel.match(ring, U)


def bracelet(count):
    """An open ring, which is no star."""
    t = np.linspace(0, 5, count // 2)
    arc = np.stack([np.cos(t), np.sin(t)], axis=1)
    return np.concatenate([2 * arc, arc[::-1]])


def test_more_vertices_than_can_be_compared_are_refused_before_memory_is_taken(in_little_memory):
    large = bracelet(20_100)
    with pytest.raises(
        starskel.StarskelError, match="pairs of vertices to be compared, and at most 400000000"
    ):
        in_little_memory(starskel.match, large, large, [(0, 0)])


def test_more_vertices_than_can_be_cut_are_refused_before_memory_is_taken(in_little_memory):
    ring, rows = bracelet(10_002), np.arange(10_002)
    pair = starskel.Correspondence(ring, ring, (), rows, rows)
    for algorithm in ("minimal", "convex"):
        with pytest.raises(starskel.StarskelError, match="10002 vertices to be cut into pieces, and at most"):
            in_little_memory(partial(starskel.decompose, algorithm=algorithm), pair)
