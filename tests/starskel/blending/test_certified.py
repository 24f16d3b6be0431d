from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import shapely

from starskel.blending.certified import CertifiedBlend, Way
from starskel.blending.certified.keys import Key, chains_between
from starskel.blending.certified.morphing.convex_combination import convex_combination_of
from starskel.blending.certified.morphing.passage import passages
from starskel.blending.certified.morphing.surroundings import SQUARE, surroundings_of
from starskel.blending.certified.relaxing import Relaxing
from starskel.blending.meshes.mesh import triangle_areas
from starskel.blending.stitched import StitchedBlend
from starskel.blending.vertex import VertexBlend
from starskel.certificate import first_unsafe, safe
from starskel.clearance import clearance
from starskel.correspondence import match
from starskel.decomposition import decompose
from starskel.errors import Cancelled
from starskel.outline import cross_themselves
from starskel.polar import as_points
from starskel.polygon import Polygon
from starskel.task import UNWATCHED, Task
from tests.families import comb, spiral, turned, two_opt
from tests.starskel.blending.cases import CASES, RANDOM, decomposition_of, size_of

HARD = (4, 6, 7)
"""Pairs that straight ways lead across themselves, by seed."""


@cache
def hard(seed):
    return decompose(match(two_opt(8, seed), two_opt(8, seed + 1000), [(0, 0)]))


@pytest.fixture
def _straight(monkeypatch):
    """Take straight ways for the stitched blend: what is to be repaired does not hang on how good that is."""
    monkeypatch.setattr(
        "starskel.blending.certified.blend.StitchedBlend", lambda known, *_: VertexBlend(known.pair)
    )


@pytest.mark.parametrize("name", CASES)
def test_every_link_of_every_case_is_safe_and_the_ends_are_exact_to_the_bit(name):
    made = CertifiedBlend(decomposition_of(name))
    assert first_unsafe(made.keys) is None
    assert made.key_times[0] == 0
    assert made.key_times[-1] == 1
    assert (np.diff(made.key_times) > 0).all()
    for t, ring in ((0, made.pair.source), (1, made.pair.target)):
        assert made.at(t).tobytes() == ring.tobytes()
    np.testing.assert_array_equal(made.frames(made.key_times), made.keys)


def test_a_blend_that_does_not_cross_stays_as_it_is():
    known = decomposition_of("run-walk")
    made, stitched = CertifiedBlend(known), StitchedBlend(known)
    assert made.how is Way.AS_IT_IS
    assert f"{made.how}" == "as stitched"
    ts = np.linspace(0, 1, 51)
    np.testing.assert_allclose(made.frames(ts), stitched.frames(ts), atol=5e-4 * size_of(known.pair))


@pytest.mark.usefixtures("_straight")
@pytest.mark.parametrize("seed", HARD)
def test_what_crosses_is_repaired_near_to_what_it_was_and_no_sample_crosses(seed):
    known = hard(seed)
    made = CertifiedBlend(known)
    assert made.how is Way.REPAIRED
    assert not cross_themselves(made.frames(np.linspace(0, 1, 20_001))).any()
    ts = np.linspace(0, 1, 101)
    wanted = VertexBlend(known.pair).frames(ts)
    assert cross_themselves(wanted).any()
    assert np.sqrt(((made.frames(ts) - wanted) ** 2).mean(axis=(1, 2))).max() < 0.1 * size_of(known.pair)


CHANGES = {
    "moved": lambda ring: ring + np.array([1000.0, -50.0]),
    "turned": lambda ring: turned(ring, 1.0),
    "scaled by 1e6": lambda ring: ring * 1e6,
    "scaled by 1e-6": lambda ring: ring * 1e-6,
    "mirrored": lambda ring: (ring * [-1, 1])[::-1],
}


@pytest.mark.usefixtures("_straight")
@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_repairs_do_not_depend_on_where_the_shapes_lie(change):
    known, ts = hard(HARD[0]), np.linspace(0, 1, 11)
    changed = replace(known.pair, source=change(known.pair.source), target=change(known.pair.target))
    expected = [change(frame) for frame in CertifiedBlend(known).frames(ts)]
    made = CertifiedBlend(decompose(changed))
    assert made.how is Way.REPAIRED
    # whether a step is taken is decided again and again, and may be decided otherwise by a rounding
    np.testing.assert_allclose(made.frames(ts), expected, atol=1e-3 * size_of(changed), rtol=0)


@pytest.mark.usefixtures("_straight")
@pytest.mark.parametrize("seed", HARD)
def test_exchanging_the_shapes_runs_a_repair_backwards(seed):
    pair, ts = hard(seed).pair, np.linspace(0, 1, 11)
    there, back = (CertifiedBlend(decompose(either)) for either in (pair, pair.exchanged))
    np.testing.assert_allclose(back.frames(1 - ts), there.frames(ts), atol=1e-9 * size_of(pair), rtol=0)


@pytest.mark.usefixtures("_straight")
@pytest.mark.parametrize("seed", HARD)
def test_repairs_keep_some_room(seed):
    made = CertifiedBlend(hard(seed))
    ends = min(clearance(np.stack([ring, ring])) for ring in (made.pair.source, made.pair.target))
    assert made.clearance == clearance(made.keys)
    assert made.clearance > 0.9 * min(1e-3 * size_of(made.pair), ends / 4)


@pytest.mark.usefixtures("_straight")
def test_repairs_are_widened_where_that_helps_and_never_narrowed(monkeypatch):
    widened = [CertifiedBlend(hard(seed)) for seed in HARD]
    monkeypatch.setattr(Relaxing, "__call__", lambda _, keys, __: keys)
    gains = [
        made.clearance / CertifiedBlend(hard(seed)).clearance
        for made, seed in zip(widened, HARD, strict=True)
    ]
    assert min(gains) > 0.9  # clearance itself is known to a tenth
    assert np.median(gains) > 1.3
    assert all(first_unsafe(made.keys) is None for made in widened)


@pytest.mark.usefixtures("_straight")
def test_a_repair_can_be_stopped_at_any_time_and_tells_how_far_it_is():
    known = hard(HARD[0])
    told, asked = [], []
    CertifiedBlend(known, task=Task(told.append, lambda: bool(asked.append(None))))
    assert told == sorted(told)
    for stop in range(1, len(asked), len(asked) // 7):
        left = iter(range(stop))
        with pytest.raises(Cancelled):
            CertifiedBlend(known, task=Task(should_stop=lambda left=left: next(left, None) is None))


def test_a_crossing_of_a_ten_thousandth_of_the_time_is_caught():
    ring = np.array([[0.0, 0.0], [4, 0], [4, 3], [2, 1], [0, 3]])
    deep = ring.copy()
    deep[3, 1] = -1e-4  # the notch breaks through the bottom, all but at the end
    after = ring.copy()
    after[3, 1] = -1.0
    there = ring + (after - ring) * 0.5
    keys = np.stack([ring, there, ring])
    assert first_unsafe(keys) == 0
    short = np.stack([ring, ring + (deep - ring) * (1 + 1e-12)])
    assert not cross_themselves((1 - 0.9998) * short[:1] + 0.9998 * short[1:]).any()
    assert first_unsafe(short) == 0


def spiral_band(ends_inside):
    """A band round more than a full turn, one end inside or outside of the other."""
    angles = np.linspace(0, 2 * np.pi + 0.5, 30)
    radii = 1 + ends_inside * 0.35 * np.linspace(-1, 1, 30)
    ways = np.exp(1j * angles)
    return Polygon(as_points(np.concatenate([(radii + 0.06) * ways, ((radii - 0.06) * ways)[::-1]])))


def test_ends_that_change_places_are_certified_by_a_convex_morph_over_the_gap_alone():
    known = decompose(match(spiral_band(1), spiral_band(-1), [(0, 0), (29, 29)]))
    made, stitched = CertifiedBlend(known), StitchedBlend(known)
    size = size_of(made.pair)
    assert made.how is Way.CONVEX
    assert first_unsafe(made.keys) is None
    assert not cross_themselves(made.frames(np.linspace(0, 1, 2001))).any()
    assert made.clearance > 3e-3 * size
    before_and_after = np.concatenate([np.linspace(0, 0.3, 7), np.linspace(0.7, 1, 7)])
    away = made.frames(before_and_after) - stitched.frames(before_and_after)
    assert np.abs(away).max() < 1e-3 * size


RESORTS = ("letter-K-X", "letter-C-S", "wrench-hammer", "arms-swing", *RANDOM)


def morph_of(known):
    return convex_combination_of(surroundings_of(known, UNWATCHED), len(known.pair))


@pytest.mark.parametrize("name", RESORTS)
def test_the_last_resort_leads_from_source_to_target_without_crossing(name):
    known = decomposition_of(name)
    pair, morph = known.pair, morph_of(known)
    ends = morph.frames(np.array([0.0, 1.0]))
    np.testing.assert_allclose(ends, [pair.source, pair.target], atol=1e-9 * size_of(pair))
    start, end = Key(0.0, pair.source), Key(1.0, pair.target)
    chains = chains_between((start, end), morph.frames, safe, UNWATCHED)
    assert len(chains) == 1
    assert first_unsafe(np.stack([key.frame for key in chains[0]])) is None


@pytest.mark.usefixtures("_straight")
def test_the_last_resort_is_taken_where_nothing_else_helps(monkeypatch):
    monkeypatch.setattr("starskel.blending.certified.repair.Following.__call__", lambda *_: None)
    made = CertifiedBlend(hard(HARD[0]))
    assert made.how is Way.CONVEX
    assert first_unsafe(made.keys) is None
    np.testing.assert_array_equal(made.at(1), made.pair.target)


@pytest.mark.parametrize("name", RESORTS)
def test_inside_and_outside_fill_the_square_in_source_and_target(name):
    made = surroundings_of(decomposition_of(name), UNWATCHED)
    for points in (made.source, made.target):
        areas = triangle_areas(points[made.triangles])
        assert areas.sum() == pytest.approx(16)
        assert areas.min() > -1e-12
    np.testing.assert_array_equal(made.source[-4:], SQUARE)


@pytest.mark.parametrize("ring", [spiral(40), comb(5), two_opt(30, 3)], ids=["spiral", "comb", "random"])
def test_passages_lead_from_every_edge_through_free_gates_to_the_hull(ring):
    outside = shapely.Polygon(ring).convex_hull.buffer(1).difference(shapely.Polygon(ring))
    for edge, way in enumerate(passages(ring, UNWATCHED)):
        right, left = way.bends(ring[:, 0] + 1j * ring[:, 1])
        for side, start in ((right, edge), (left, (edge + 1) % len(ring))):
            bends = np.stack([side.real, side.imag], axis=1)
            if len(bends):
                line = shapely.LineString([ring[start], *bends])
                assert outside.buffer(1e-9).covers(line)
        assert shapely.LineString(ring[list(way.lid)]).within(shapely.convex_hull(outside).buffer(1e-9))


def test_clearance_is_a_lower_bound_and_a_tight_one():
    keys = np.stack([two_opt(12, 3), 1.3 * two_opt(12, 3), turned(two_opt(12, 3), 0.4)])
    shares = np.linspace(0, 1, 101)[:, None, None]
    rings = np.concatenate([(1 - shares) * a + shares * b for a, b in pairwise(keys)])
    ends = np.roll(rings, -1, axis=1)
    edges = shapely.linestrings(np.stack([rings, ends], axis=2))
    distances = shapely.distance(shapely.points(rings)[:, :, None], edges[:, None, :])
    own = np.arange(12)
    distances[:, own, own] = distances[:, own, own - 1] = np.inf
    assert 0.89 * distances.min() < clearance(keys) <= distances.min()
    assert clearance(np.stack([keys[0], -keys[0]])) == 0
