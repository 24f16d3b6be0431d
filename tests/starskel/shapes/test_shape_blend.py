"""Blends of shapes: exact ends, holes inside, rigid motions, exchange; shapely is the judge."""

from functools import cache

import numpy as np
import pytest
import shapely

import starskel
from starskel import METHODS, Shape, StarskelError
from starskel.decomposition.verify import faults
from tests.starskel.shapes.drawn import BAR, COLON, EIGHT, FACE, LETTERS, A, B, I, O, Q, R, ellipse, moved
from tests.starskel.shapes.regions import holed_pair

TURNING = tuple(method for method in METHODS if method not in ("vertex", "certified"))
TIMES = np.linspace(0, 1, 41)


@cache
def blend_of(name: str, method: str) -> starskel.ShapeBlend:
    source, target = LETTERS[name]
    return starskel.blend(Shape(source), Shape(target), method=method)


def farthest(first, second):
    """The greatest distance between two sets of rings, ring by ring."""
    return max(
        shapely.hausdorff_distance(shapely.LinearRing(a), shapely.LinearRing(b))
        for a, b in zip(first, second, strict=True)
    )


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", LETTERS)
def test_the_ends_are_the_shapes_exactly(name, method):
    blend = blend_of(name, method)
    for t, side, shape in ((0, 0, blend.pair.source), (1, 1, blend.pair.target)):
        for ring, link in zip(blend.at(t), blend.pair.pairing, strict=True):
            if link[side] is None:
                assert (ring == ring[0]).all() or np.ptp(ring, axis=0).max() < 1e-12
            else:
                assert farthest([ring], [shape.rings[link[side]].vertices]) < 1e-9 * 100


@pytest.mark.parametrize("name", LETTERS)
def test_stitched_letters_keep_their_holes_inside_and_apart(name):
    blend = blend_of(name, "stitched")
    for t in TIMES:
        assert all(part.is_valid for part in blend.shape_at(t).geoms)


@pytest.mark.parametrize("name", LETTERS)
def test_stitched_parts_never_overlap_more_than_at_the_ends(name):
    blend = blend_of(name, "stitched")
    overlaps = [overlap(blend.shape_at(t)) for t in TIMES]
    assert max(overlaps) <= max(overlaps[0], overlaps[-1]) + 1e-6


def overlap(shape: shapely.MultiPolygon) -> float:
    return sum(part.area for part in shape.geoms) - shapely.union_all(shape.geoms).area


@pytest.mark.parametrize("name", LETTERS)
def test_stitched_areas_hardly_drift(name):
    blend = blend_of(name, "stitched")
    areas = np.array([blend.shape_at(t).area for t in TIMES])
    expected = (1 - TIMES) * areas[0] + TIMES * areas[-1]
    assert np.abs(areas / expected - 1).max() < 0.1


@pytest.mark.parametrize("name", LETTERS)
def test_the_star_pieces_of_regions_are_proven(name):
    for body in blend_of(name, "star-skeleton").bodies:
        if body.blend.decomposition is not None:
            assert faults(body.blend.decomposition) == []


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("rings", [A, EIGHT, I, FACE, COLON])
def test_a_shape_to_itself_stands_still(rings, method):
    blend = starskel.blend(Shape(rings), Shape(rings), method=method)
    for t in (0.2, 0.5, 0.9):
        assert farthest(blend.at(t), rings) < 1e-9 * 100


@pytest.mark.parametrize("method", TURNING)
@pytest.mark.parametrize("angle", [0.4, -1.3, 2.8, 3.1])
@pytest.mark.parametrize("rings", [B, I, FACE])
def test_a_moved_and_turned_copy_moves_rigidly(rings, angle, method):
    blend = starskel.blend(Shape(rings), Shape(moved(rings, angle, 40, -25)), method=method)
    start = np.concatenate(blend.at(0))
    gaps = np.abs(np.subtract.outer(start @ [1, 1j], start @ [1, 1j]))
    for t in (0.25, 0.5, 0.75):
        rows = np.concatenate(blend.at(t)) @ [1, 1j]
        assert np.abs(np.abs(np.subtract.outer(rows, rows)) - gaps).max() < 1e-6 * 100


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", ["A-R", "B-8", "i-j", "A-T", "T-8", "T-i"])
def test_exchanged_shapes_blend_backwards(name, method):
    assert_backwards(blend_of(name, method), *LETTERS[name], method)


@pytest.mark.parametrize(
    ("source", "target"), [(B, Q), (R, B)], ids=["turned-by-nearly-half", "first-at-other-vertices"]
)
def test_exchanged_shapes_blend_backwards_where_both_begin_at_other_vertices(source, target):
    assert_backwards(starskel.blend(Shape(source), Shape(target)), source, target, "stitched")


def assert_backwards(there, source, target, method):
    back = starskel.blend(Shape(target), Shape(source), method=method)
    ways = {link[::-1]: ring for link, ring in zip(back.pair.pairing, back.at(0.7), strict=True)}
    again = [ways[link] for link in there.pair.pairing]
    assert farthest(there.at(0.3), again) < 1e-6 * 100


@pytest.mark.parametrize("method", [method for method in METHODS if method != "certified"])
def test_parts_turn_together_by_the_meta_skeleton_and_not_without(method):
    turned = moved(I, 2.5, 10, 5)
    pair = starskel.match(Shape(I), Shape(turned), [[(k, k) for k in range(4)], [(k, k) for k in range(12)]])
    gaps = []
    for joined in (True, False):
        stem, dot = (ring.mean(axis=0) for ring in starskel.blend(pair, method=method, joined=joined).at(0.5))
        gaps.append(np.hypot(*(stem - dot)))
    assert gaps[0] == pytest.approx(55, abs=1)
    assert gaps[1] < 40


def test_whole_turns_are_made_by_all_parts():
    still = starskel.blend(Shape(I), Shape(I), method="stitched", turns=1)
    assert farthest(still.at(1), I) < 1e-9 * 100
    stem, dot = (ring.mean(axis=0) for ring in still.at(0.5))
    np.testing.assert_allclose(dot - stem, (0, -55), atol=1e-6)


@pytest.mark.parametrize("turns", [0.5, np.nan, "1", None])
@pytest.mark.parametrize("given", [Shape(I), I[0]])
def test_turns_are_whole(given, turns):
    with pytest.raises(StarskelError, match="for turns; give a whole number, from -1000 to 1000"):
        starskel.blend(given, given, turns=turns)


def test_frames_are_lists_of_rings():
    blend = blend_of("B-8", "vertex")
    frames = blend.frames([0, 0.5])
    assert [len(frame) for frame in frames] == [3, 3]
    assert blend.pair.outer == (-1, 0, 0)
    np.testing.assert_array_equal(frames[1][2], blend.at(0.5)[2])


@pytest.mark.parametrize("name", LETTERS)
def test_certified_letters_keep_their_rings_simple_and_apart_at_any_time(name):
    blend = blend_of(name, "certified")
    assert blend.key_times[0] == 0
    assert blend.key_times[-1] == 1
    assert blend.meeting_parts == ()
    for t in np.random.default_rng(7).uniform(0, 1, 100):
        shape = blend.shape_at(t)
        assert shape.is_valid
        assert len(shape.geoms) == sum(outer < 0 for outer in blend.pair.outer)


def _side_by_side(rings, away):
    return [*rings, *moved(rings, 0, away)]


@pytest.mark.parametrize(
    ("source", "target", "pairing"),
    [
        (_side_by_side(BAR, 40), _side_by_side(BAR, 40), [(0, 1), (1, 0)]),
        (_side_by_side(I, 60), _side_by_side(I, 60), [(0, 2), (1, 3), (2, 0), (3, 1)]),
        (
            _side_by_side(A, 100),
            _side_by_side(B, 100),
            [(0, 3), (1, 4), (2, 0), (3, 1), (None, 2), (None, 5)],
        ),
    ],
)
def test_certified_parts_that_would_pass_through_each_other_go_round_each_other(source, target, pairing):
    pair = starskel.match(Shape(source), Shape(target), pairing=pairing)
    meeting = starskel.blend(pair, method="stitched", joined=False)
    assert starskel.measure(meeting, 21).overlaps.max() > 0.1
    heard: list[float] = []
    blend = starskel.blend(pair, method="certified", joined=False, progress=heard.append)
    assert np.diff(heard).min() > -1e-9  # but for rounding, it only goes on
    assert blend.how == "convex morph"
    for number, side in enumerate((source, target)):
        known = [k for k, link in enumerate(pairing) if link[number] is not None]
        rings = [side[pairing[k][number]] for k in known]
        assert farthest([blend.at(number)[k] for k in known], rings) < 1e-7
    for t in np.random.default_rng(3).uniform(0, 1, 100):
        parts = blend.shape_at(t)
        assert parts.is_valid  # holes stay inside, and parts apart
        assert len(parts.geoms) == sum(outer < 0 for outer in pair.outer)


@pytest.mark.parametrize("angle", [0.0, 0.9272952180016122, 2.0])
def test_bridges_pass_no_vertex_by_rounding_alone(angle):
    """Feet of letters that stand on one line do so but for rounding where the line is turned."""
    pair = starskel.match(
        Shape(moved(_side_by_side(A, 100), angle)),
        Shape(moved(_side_by_side(A, 107), angle)),
        pairing=[(0, 2), (1, 3), (2, 0), (3, 1)],
    )
    blend = starskel.blend(pair, method="certified", joined=False)
    assert blend.how == "convex morph"
    assert all(blend.shape_at(t).is_valid for t in np.linspace(0, 1, 41))


@pytest.mark.parametrize("seed", [14, 27])
def test_holes_that_stitched_pushes_out_stay_inside_by_certified(seed):
    pair, times = holed_pair(seed), np.linspace(0, 1, 21)
    stitched = starskel.blend(pair, method="stitched")
    assert not all(stitched.shape_at(t).is_valid for t in times)
    blend = starskel.blend(pair, method="certified")
    assert blend.how == "convex morph"
    assert all(blend.shape_at(t).is_valid for t in times)


def test_a_certified_blend_says_which_rings_have_to_meet():
    dot = ellipse(120, 50, 5, 5)
    inside, outside = Shape.of_parts([(O[0], [O[1]]), (ellipse(45, 50, 5, 5), [])]), Shape([*O, dot])
    with pytest.raises(
        StarskelError, match=r"paired as \(2, 2\) lie in those paired as \(0, 0\), but not in"
    ):
        starskel.blend(inside, outside, pairing=[(0, 0), (1, 1), (2, 2)], method="certified")


_OPEN = np.linspace(0.7, 2 * np.pi - 0.7, 29)
CLASP = np.concatenate(
    [50 + r * np.stack([np.cos(_OPEN), np.sin(_OPEN)], axis=1)[::step] for r, step in ((50, 1), (32, -1))]
)
DISK = ellipse(50, 50, 50, 50, 24)
INNER = {
    "beside-what-closes-round-it": ([DISK], [CLASP, ellipse(50, 50, 10, 10)]),
    "in-a-body-that-gets-wider": (
        [DISK, ellipse(50, 50, 30, 30, 24)],
        [DISK, ellipse(50, 50, 45, 45, 24), ellipse(15, 50, 5, 5)],
    ),
    "in-a-hole-that-is-a-point-too": ([DISK], [DISK, ellipse(40, 50, 25, 25, 24), ellipse(40, 50, 8, 8)]),
    "in-a-part-that-is-a-point-too": (BAR, [*BAR, *moved(O, 0, 100), ellipse(145, 50, 10, 10)]),
}


@pytest.mark.parametrize("backwards", [False, True])
@pytest.mark.parametrize("name", INNER)
def test_a_certified_part_without_a_partner_grows_from_a_point_in_the_same_rings(name, backwards):
    """The part nearest to it carried it along into rings that it does not lie in, or out of its own."""
    source, target = map(Shape, INNER[name])
    if backwards:
        source, target = target, source
    blend = starskel.blend(source, target, method="certified")
    assert all(blend.shape_at(t).is_valid for t in np.linspace(0, 1, 41))


def test_places_of_parts_without_a_partner_are_left_where_they_work_and_where_they_are_given():
    pair = starskel.match(Shape(BAR), Shape([*BAR, ellipse(40, 20, 5, 5)]))
    np.testing.assert_allclose(pair.parts[1].ends[0], np.full((16, 2), (40, 20)), atol=1e-9)
    source, target = map(Shape, INNER["beside-what-closes-round-it"])
    given = starskel.match(source, target, pairing=[(0, 0), (None, 1)], places={(None, 1): (50, 50)})
    np.testing.assert_array_equal(given.parts[1].ends[0], np.full((16, 2), 50.0))


@pytest.mark.parametrize("backwards", [False, True])
def test_a_certified_part_with_holes_grows_from_a_point(backwards):
    """Its rings touch where they are the same point, at one end, and nowhere else."""
    more = Shape([*BAR, *moved(O, 0, 300)])
    ends, pairing = (Shape(BAR), more), [(0, 0), (None, 1), (None, 2)]
    if backwards:
        ends, pairing = ends[::-1], [(j, i) for i, j in pairing]
    blend = starskel.blend(*ends, pairing=pairing, method="certified")
    assert starskel.measure(blend, 21).simple
    for t in np.linspace(0, 1, 41)[1:-1]:
        parts = blend.shape_at(t)
        assert parts.is_valid
        assert [len(part.interiors) for part in parts.geoms] == [0, 1]


@pytest.mark.parametrize(
    ("seed", "what"),
    [
        (2, r"the ring paired as \(0, 0\) crosses itself"),
        (59, r"the rings paired as \(0, 0\) and \(3, 3\) meet"),
    ],
)
def test_a_certified_blend_says_which_rings_meet_where_no_way_round_is_found(monkeypatch, seed, what):
    monkeypatch.setattr("starskel.shapes.certified.blend.MARGINS", ())  # so that none is looked for
    with pytest.raises(StarskelError, match=what + r" at t = 0\.\d+, and no way round was found"):
        starskel.blend(holed_pair(seed), method="certified")


def test_parts_that_meet_at_an_end_may_meet_on_the_way_of_a_certified_blend_and_are_named():
    over = [[(0, 0), (10, 0), (10, 10), (0, 10)], [(5, 5), (15, 5), (15, 15), (5, 15)]]
    apart = [over[0], [(25, 5), (35, 5), (35, 15), (25, 15)]]
    blend = starskel.blend(Shape(over), Shape(apart), method="certified")
    assert blend.meeting_parts == ((0, 1),)


def test_holes_that_change_places_are_joined_by_bridges_that_bend():
    frame = [(0, 0), (60, 0), (60, 30), (0, 30)]
    rings = [frame, [(10, 10), (20, 10), (15, 20)], [(40, 10), (50, 10), (45, 20)]]
    pair = starskel.match(Shape(rings), Shape(rings), [[(0, 0)]] * 3, pairing=[(0, 0), (1, 2), (2, 1)])
    blend = starskel.blend(pair, settled=False)
    assert not blend.settled
    better = list(blend.improvements())
    assert [each.settled for each in better] == [False] * (len(better) - 1) + [True]
    assert list(better[-1].improvements()) == []
    (body,) = blend.bodies
    assert faults(body.blend.decomposition) == []
    assert farthest(blend.at(0), rings) < 1e-9 * 60
    assert farthest(blend.at(1), [rings[0], rings[2], rings[1]]) < 1e-9 * 60


@pytest.mark.parametrize("method", METHODS)
def test_blends_of_polygons_and_of_shapes_are_used_alike(method):
    ring, times = I[0], [0, 0.5, 1]
    pair = starskel.match(ring, ring)
    of_polygons = starskel.blend(pair, method=method)
    of_shapes = starskel.blend(starskel.match(Shape([ring]), Shape([ring])), method=method)
    for blend in (of_polygons, of_shapes):
        assert blend.method == method
        assert [frames.shape for frames in blend.rings(times)] == [(3, 4, 2)]
        assert blend.negative_lengths(times).tolist() == [False] * 3
        assert (len(blend.pair.ring_pairs), blend.pair.outer) == (1, (-1,))
        assert blend.settled
        assert list(blend.improvements()) == []
    assert of_polygons.how == of_shapes.how
    assert (of_shapes.key_times is not None) == (method == "certified")


def test_polygons_are_blended_as_ever():
    ring = I[0]
    assert starskel.blend(ring, ring).at(0.5).shape == (4, 2)
    with pytest.raises(StarskelError, match="are not joined"):
        starskel.blend(ring, ring, joined=False)


@pytest.mark.parametrize("given", [shapely.Polygon(A[0], [A[1]]), shapely.MultiPolygon([(A[0], [A[1]])])])
def test_shapely_goes_in_by_itself(given):
    blend = starskel.blend(given, given, method="vertex")
    assert blend.shape_at(0.5).symmetric_difference(given).area < 1e-6


def test_a_report_says_what_is_proven():
    report = starskel.measure(blend_of("i-j", "certified"), 11)
    assert (report.proven, report.how) == (True, "as stitched")
    assert not starskel.measure(blend_of("i-j", "stitched"), 11).proven


@pytest.mark.parametrize(
    "more", [{"marks": [[(0, 0)]]}, {"pairing": [(0, 0)]}, {"places": {}}, {"target": Shape(FACE)}]
)
def test_a_pair_of_shapes_is_given_alone(more):
    shape = Shape(FACE)
    pair = starskel.match(shape, shape)
    with pytest.raises(StarskelError, match="has its target and its marks already"):
        starskel.blend(pair, **more)
