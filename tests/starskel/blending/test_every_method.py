import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

import starskel
from starskel.blending import METHODS
from starskel.correspondence import match
from starskel.decomposition import decompose
from starskel.errors import Cancelled, StarskelError, UnknownMethod
from starskel.outline import edge_lengths
from starskel.shapes.blend import blend
from tests.families import subdivided, turned, two_opt
from tests.starskel.blending.cases import CASES, NAMED, decomposition_of, pair_of, shapes, size_of

TIMES = np.linspace(0, 1, 13)
PIECEWISE = ("star-skeleton", "stitched", "rigid")

every_method = pytest.mark.parametrize("method", METHODS)


def prepared(name, method):
    known = decomposition_of(name) if method in PIECEWISE else None
    return blend(pair_of(name), method=method, decomposition=known)


@every_method
@pytest.mark.parametrize("name", CASES)
def test_frames_are_finite_of_constant_count_and_exact_at_both_ends(name, method):
    pair = pair_of(name)
    frames = prepared(name, method).frames(TIMES)
    assert frames.shape == (len(TIMES), len(pair), 2)
    assert np.isfinite(frames).all()
    np.testing.assert_allclose(frames[0], pair.source, atol=1e-13 * size_of(pair), rtol=0)
    np.testing.assert_allclose(frames[-1], pair.target, atol=1e-13 * size_of(pair), rtol=0)


@every_method
@pytest.mark.parametrize("name", CASES)
def test_frames_move_steadily(name, method):
    """No jump: in a hundredth of the time no vertex moves by more than a fiftieth of the outline."""
    if (name, method) == ("spiral-opposite", "edge-angle"):
        pytest.skip("half way all edges are parallel, and the outline collapses")
    pair = pair_of(name)
    frames = prepared(name, method).frames(np.linspace(0, 1, 101))
    steps = np.hypot(*np.moveaxis(np.diff(frames, axis=0), -1, 0))
    assert steps.max() < 0.02 * max(edge_lengths(pair.source).sum(), edge_lengths(pair.target).sum())


@every_method
def test_one_frame_and_many_frames_agree_to_the_bit(method):
    prepared_blend = prepared("run-walk", method)
    frames = prepared_blend.frames([0.3, 0.3, 0.9])
    np.testing.assert_array_equal(prepared_blend.at(0.3), frames[0])
    np.testing.assert_array_equal(frames[0], frames[1])
    np.testing.assert_array_equal(prepared_blend.at(0.9), frames[2])
    assert prepared_blend.frames([]).shape == (0, len(pair_of("run-walk")), 2)
    many = prepared_blend.frames(np.full(5000, 0.3))
    np.testing.assert_array_equal(many, np.broadcast_to(frames[0], many.shape))


@every_method
@pytest.mark.parametrize("name", ["hand-open", "random-16-7"])
def test_equal_input_gives_equal_output_to_the_bit(name, method):
    first, second = (blend(*shapes(name), method=method).frames(TIMES) for _ in range(2))
    assert first.tobytes() == second.tobytes()


@every_method
@pytest.mark.parametrize(
    "ring", [two_opt(15, 4), subdivided(two_opt(6, 1), 4)], ids=["plain", "straight runs"]
)
def test_a_shape_to_itself_stands_still(ring, method):
    frames = blend(ring, ring, method=method).frames(TIMES)
    np.testing.assert_allclose(frames, np.broadcast_to(ring, frames.shape), atol=1e-10)


@pytest.mark.parametrize("method", [method for method in METHODS if method not in ("vertex", "certified")])
@pytest.mark.parametrize("angle", [0.7, -2.4, 3.0])
def test_a_shape_to_a_moved_and_turned_copy_moves_rigidly(method, angle):
    ring = two_opt(18, 6)
    copy = turned(ring, angle) + np.array([300.0, -20.0])
    frames = blend(ring, copy, [(k, k) for k in range(0, 18, 3)], method).frames(TIMES)
    np.testing.assert_allclose(edge_lengths(frames), np.broadcast_to(edge_lengths(ring), frames.shape[:2]))
    for t, frame in zip(TIMES, frames, strict=True):
        unturned = turned(frame, -t * angle)
        np.testing.assert_allclose(unturned - unturned[0], ring - ring[0], atol=1e-9)
    if method != "star-skeleton":  # there it is the root that moves straight
        centres = [np.array(shapely.LinearRing(frame).centroid.coords[0]) for frame in frames]
        np.testing.assert_allclose(np.diff(centres, 2, axis=0), 0, atol=1e-9)


def transformed(name, method, change):
    source, target, marks = shapes(name)
    return blend(change(source), change(target), marks, method).frames(TIMES)


CHANGES = {
    "moved": lambda ring: ring + np.array([1000.0, -50.0]),
    "turned": lambda ring: turned(ring, 1.0),
    "scaled by 1e6": lambda ring: ring * 1e6,
    "scaled by 1e-6": lambda ring: ring * 1e-6,
}


@every_method
@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
@pytest.mark.parametrize("name", ["wrench-hammer", "run-walk", "hand-open", "random-12-3"])
def test_changing_both_shapes_changes_the_frames_alike(name, method, change):
    expected = change(prepared(name, method).frames(TIMES))
    frames = transformed(name, method, change)
    np.testing.assert_allclose(frames, expected, atol=1e-6 * np.ptp(expected), rtol=0)


@every_method
@pytest.mark.parametrize(
    "name", ["wrench-hammer", "run-walk", "random-9-2", "random-12-3", "random-12-5", "random-16-7"]
)
def test_mirrored_shapes_have_mirrored_frames(name, method):
    expected = prepared(name, method).frames(TIMES) * [-1, 1]
    frames = transformed(name, method, lambda ring: ring * [-1, 1])
    backwards = np.concatenate([expected[:, :1], expected[:, :0:-1]], axis=1)
    np.testing.assert_allclose(frames, backwards, atol=1e-6 * np.ptp(expected), rtol=0)


@every_method
@pytest.mark.parametrize("name", ["wrench-hammer", "run-walk", "random-16-7"])
def test_the_vertex_that_a_ring_starts_with_does_not_matter(name, method):
    source, target, marks = shapes(name)
    n, m = len(source), len(target)
    shifted = [((i - 4) % n, (j - 2) % m) for i, j in marks]
    moved = blend(np.roll(source, -4, axis=0), np.roll(target, -2, axis=0), shifted, method)
    expected = prepared(name, method).frames(TIMES)
    start = int(np.flatnonzero(pair_of(name).source_vertices == 4)[0])
    np.testing.assert_allclose(
        moved.frames(TIMES), np.roll(expected, -start, axis=1), atol=1e-6 * np.ptp(expected), rtol=0
    )


@every_method
@pytest.mark.parametrize("name", ["wrench-hammer", "run-walk", "random-12-3"])
def test_exchanging_source_and_target_runs_the_frames_backwards(name, method):
    source, target, marks = shapes(name)
    back = blend(target, source, [(j, i) for i, j in marks], method)
    expected = prepared(name, method).frames(1 - TIMES)
    start = int(np.flatnonzero(pair_of(name).target_vertices == 0)[0])
    np.testing.assert_allclose(
        back.frames(TIMES), np.roll(expected, -start, axis=1), atol=1e-6 * np.ptp(expected), rtol=0
    )


@pytest.mark.parametrize("method", ["edge-angle", "star-skeleton", "stitched", "rigid"])
def test_half_a_turn_goes_the_same_way_wherever_and_however_large_shapes_are(method):
    ring = two_opt(9, 1)
    marks = [(k, k) for k in range(9)]

    def middle(scale, x, y):
        move = np.array([x, y]) * scale
        made = starskel.blend(ring * scale + move, -ring * scale + move, marks, method)
        return (made.at(0.5) - move) / scale

    expected = middle(1.0, 0.0, 0.0)
    for scale in (1e6, 1e-6, 0.3, 7.0):
        for x, y in ((0, 0), (31, -7), (-0.9, 55)):
            np.testing.assert_allclose(middle(scale, x, y), expected, atol=1e-7)
    back = starskel.blend(-ring, ring, marks, method)
    np.testing.assert_allclose(back.at(0.5), expected, atol=1e-7)


@pytest.mark.parametrize("method", ["stitched", "rigid"])
def test_of_triangles_that_gain_alike_rounding_does_not_choose(method):
    """An octagon becomes a bar: edges of the mesh whose flips gain all but the same lie beside each other."""
    angles = 2 * np.pi * np.arange(8) / 8
    octagon = 50 * np.stack([1 + np.cos(angles), 1 + np.sin(angles)], axis=1)
    bar = np.array([(0.0, 0.0), (90.0, 0.0), (90.0, 20.0), (0.0, 20.0)])
    pair = match(octagon, bar, starskel.suggest_marks(octagon, bar))
    rows = [(k, k) for k in range(len(pair))]
    expected = blend(pair, method=method).at(0.5)
    for scale, angle in ((1e6, 0.0), (1.0, 0.7)):
        sides = [scale * turned(ring, angle) for ring in (pair.source, pair.target)]
        found = blend(match(*sides, rows), method=method).at(0.5)
        np.testing.assert_allclose(turned(found, -angle) / scale, expected, atol=1e-6)


def test_the_methods_are_those_that_the_package_names():
    assert starskel.METHODS is METHODS
    for method in METHODS:
        assert prepared("letter-T-Y", method).pair is pair_of("letter-T-Y")


def test_an_unknown_method_is_refused_with_the_known_ones():
    with pytest.raises(UnknownMethod, match='no method "warp"; choose one of vertex, edge-angle'):
        blend(pair_of("letter-T-Y"), method="warp")


def test_a_method_may_be_named_behind_a_pair_or_left_out():
    pair = pair_of("letter-T-Y")
    np.testing.assert_array_equal(blend(pair, "vertex").at(0.25), 0.75 * pair.source + 0.25 * pair.target)
    np.testing.assert_array_equal(blend(pair).at(0.5), blend(pair, method="stitched").at(0.5))


@pytest.mark.parametrize(
    ("t", "reason"),
    [
        (-1e-9, r"outside \[0, 1\]; give numbers from 0 to 1"),
        (1.5, r"outside \[0, 1\]; give numbers from 0 to 1"),
        (np.nan, "for the times; give a list of finite numbers"),
        (np.inf, "for the times; give a list of finite numbers"),
    ],
)
@every_method
def test_times_outside_are_refused(method, t, reason):
    prepared_blend = prepared("letter-T-Y", method)
    with pytest.raises(StarskelError, match=reason):
        prepared_blend.at(t)
    with pytest.raises(StarskelError):
        prepared_blend.frames([0.5, t])


@pytest.mark.parametrize("ts", [["half"], [[0.5]], 0.5])
def test_times_that_are_no_list_of_numbers_are_refused(ts):
    with pytest.raises(StarskelError, match="give"):
        prepared("letter-T-Y", "vertex").frames(ts)


def test_contradictory_calls_are_refused():
    source, target, marks = shapes("letter-T-Y")
    pair = pair_of("letter-T-Y")
    with pytest.raises(StarskelError, match="the target is missing"):
        blend(source)
    with pytest.raises(StarskelError, match="has its target and its marks already"):
        blend(pair, target)
    with pytest.raises(StarskelError, match="has its target and its marks already"):
        blend(pair, marks=marks)
    with pytest.raises(StarskelError, match="belongs to another pair"):
        blend(match(source, target, marks), decomposition=decomposition_of("letter-T-Y"))


@given(st.integers(4, 13), st.integers(4, 13), st.integers(0, 60), st.sampled_from(METHODS), st.booleans())
@settings(max_examples=60)
def test_any_two_polygons_are_blended(n, m, seed, method, on_grid):
    source, target = two_opt(n, seed, grid=6 * on_grid), two_opt(m, seed + 100, grid=6 * on_grid)
    prepared_blend = blend(source, target, method=method)
    frames = prepared_blend.frames(TIMES)
    assert np.isfinite(frames).all()
    np.testing.assert_allclose(frames[0], prepared_blend.pair.source, atol=1e-11)
    np.testing.assert_allclose(frames[-1], prepared_blend.pair.target, atol=1e-11)
    assert np.ptp(frames, axis=(0, 1)).max() < 10 * size_of(prepared_blend.pair)


@every_method
def test_progress_rises_to_one(method):
    told = []
    blend(*shapes("arms-over-under"), method=method, progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1


@every_method
def test_stopping_is_obeyed_at_once(method):
    with pytest.raises(Cancelled):
        blend(*shapes("run-walk"), method=method, should_stop=lambda: True)


def test_stopping_while_a_blend_is_stiffened():
    """This pair is hard: all balances are tried, and each round asks."""
    known = decomposition_of("arms-over-under")
    asked = []

    def should_stop():
        asked.append(None)
        return len(asked) > 20

    with pytest.raises(Cancelled):
        blend(pair_of("arms-over-under"), decomposition=known, should_stop=should_stop)
    assert len(asked) == 21


@pytest.mark.parametrize("method", PIECEWISE)
@pytest.mark.parametrize("name", CASES)
def test_pieces_and_skeleton_can_be_drawn_at_any_time(name, method):
    known = decomposition_of(name)
    prepared_blend = prepared(name, method)
    assert prepared_blend.decomposition is known
    skeleton = prepared_blend.skeleton
    assert len(skeleton.arcs) == 2 * (len(known.pieces) - 1)
    for t, points in ((0.0, known.source), (0.6, None), (1.0, known.target)):
        moved, nodes = prepared_blend.points_at(t), prepared_blend.skeleton_at(t)
        assert moved.shape == known.source.shape
        assert nodes.shape == (2 * len(known.pieces) - 1, 2)
        np.testing.assert_allclose(moved[: len(known.pair)], prepared_blend.at(t), atol=1e-9)
        if points is not None:
            np.testing.assert_allclose(moved, points, atol=1e-9)
            mid_points = skeleton.points(points, np.zeros((len(known.pieces), 2)))[len(known.pieces) :]
            np.testing.assert_allclose(nodes[len(known.pieces) :], mid_points, atol=1e-9)
            for piece, origin in zip(known.pieces, nodes, strict=False):
                area = shapely.Polygon(points[list(piece)])
                assert area.distance(shapely.Point(origin)) < 1e-9 * size_of(known.pair)


def test_the_other_methods_have_no_pieces():
    for method in ("vertex", "edge-angle"):
        prepared_blend = prepared("letter-T-Y", method)
        assert prepared_blend.decomposition is None
        assert prepared_blend.skeleton is None


def test_the_root_can_be_chosen():
    known = decomposition_of("run-walk")
    for root in range(len(known.pieces)):
        prepared_blend = blend(known.pair, method="star-skeleton", decomposition=known, root=root)
        assert prepared_blend.skeleton.root == root
        centres = [prepared_blend.skeleton_at(t)[root] for t in (0.0, 0.25, 1.0)]
        np.testing.assert_allclose(centres[1], 0.75 * centres[0] + 0.25 * centres[2], atol=1e-9)


def test_the_decomposition_is_computed_where_it_is_not_given():
    pair = pair_of("wrench-hammer")
    prepared_blend = blend(pair, method="star-skeleton")
    assert prepared_blend.decomposition.pieces == decompose(pair).pieces


def test_named_cases_are_all_there():
    assert all(len(pair_of(name)) >= 8 for name in NAMED)
