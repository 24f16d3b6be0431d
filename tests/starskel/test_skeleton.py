from dataclasses import replace

import numpy as np
import pytest

import starskel
from starskel.correspondence import match
from starskel.decomposition import decompose
from starskel.errors import StarskelError
from starskel.polar import PolarVectors, as_complex
from starskel.skeleton import skeleton_of
from starskel.skeleton.spokes import spokes_of
from tests.families import spiral, turned, two_opt


@pytest.fixture
def decomposition(shape_pair):
    return decompose(match(shape_pair.source, shape_pair.target, shape_pair.marks))


def edges(piece):
    return set(zip(piece, (*piece[1:], piece[0]), strict=True))


def test_the_skeleton_is_a_tree_over_shared_edges_from_the_piece_with_most_neighbours(decomposition):
    skeleton = skeleton_of(decomposition)
    pieces = decomposition.pieces
    count = len(pieces)
    neighbours = [
        sum(any((b, a) in edges(other) for a, b in edges(piece)) for other in pieces) for piece in pieces
    ]
    assert neighbours[skeleton.root] == max(neighbours)
    assert sorted(skeleton.order) == list(range(count))
    assert skeleton.order[0] == skeleton.root
    assert skeleton.parents[skeleton.root] == -1
    for at, piece in enumerate(skeleton.order[1:], start=1):
        parent = skeleton.parents[piece]
        assert skeleton.order.index(parent) < at
        a, b = skeleton.shared_edges[piece]
        assert (a, b) in edges(pieces[piece])
        assert (b, a) in edges(pieces[parent])
    assert len(skeleton.arcs) == 2 * (count - 1)
    assert len(np.unique(skeleton.arcs)) == (2 * count - 1 if count > 1 else 0)


def test_any_piece_can_be_the_root(shape_pairs):
    pair = shape_pairs["run-walk"]
    decomposition = decompose(match(pair.source, pair.target, pair.marks))
    for root in range(len(decomposition.pieces)):
        assert skeleton_of(decomposition, root).order[0] == root
    with pytest.raises(StarskelError, match=r"no piece 99.*give one from 0"):
        skeleton_of(decomposition, 99)


def test_mid_points_halve_the_shared_edges(shape_pairs):
    pair = shape_pairs["hand-open"]
    decomposition = decompose(match(pair.source, pair.target, pair.marks))
    skeleton = skeleton_of(decomposition)
    points = skeleton.points(decomposition.source, decomposition.source_origins)
    for piece, at in skeleton.mid_points.items():
        a, b = skeleton.shared_edges[piece]
        np.testing.assert_allclose(points[at], (decomposition.source[a] + decomposition.source[b]) / 2)


def test_spokes_lead_from_the_origins_to_the_vertices_in_both_polygons(decomposition):
    spokes = spokes_of(skeleton_of(decomposition))
    lead = spokes.rows >= 0
    ends = spokes.vectors.at(np.array([0.0, 1.0]))
    for t, (points, origins) in enumerate(
        [
            (decomposition.source, decomposition.source_origins),
            (decomposition.target, decomposition.target_origins),
        ]
    ):
        expected = as_complex(points)[spokes.rows] - as_complex(origins)[spokes.pieces]
        np.testing.assert_allclose(ends[t][lead], expected[lead], atol=1e-11)
    assert lead.sum() == sum(map(len, decomposition.pieces))


def test_spokes_stay_in_order_round_their_origin(decomposition):
    """At every t the angles from each to the next add up to one turn, because they do at both ends."""
    skeleton = skeleton_of(decomposition)
    spokes = spokes_of(skeleton)
    for piece in range(len(decomposition.pieces)):
        own = np.flatnonzero(spokes.pieces == piece)
        vectors = spokes.vectors
        long = own[np.minimum(vectors.source_lengths, vectors.target_lengths)[own] > 1e-9]
        for t in (0.0, 0.3, 0.5, 1.0):
            angles = vectors.angles[long] + t * vectors.rotations[long]
            steps = np.diff(angles, append=angles[:1])
            steps = (steps + 1e-9) % (2 * np.pi) - 1e-9
            assert steps.sum() == pytest.approx(2 * np.pi)


def test_whole_turns_along_the_tree_are_counted():
    """Two turns of a spiral to none: the ends of the band turn by two turns against each other."""
    n = 60
    source = spiral(n, turns=2.0)
    inner = np.stack([np.linspace(0, 40, n // 2), np.zeros(n // 2)], axis=1)
    target = np.concatenate([inner, inner[::-1] + np.array([0, 1.5])])
    decomposition = decompose(match(source, target, [(k, k) for k in range(n)]))
    vectors = spokes_of(skeleton_of(decomposition)).vectors
    assert np.ptp(vectors.rotations) > 3.5 * np.pi


def test_a_turned_copy_turns_every_spoke_by_the_same_angle():
    ring = two_opt(20, 3)
    decomposition = decompose(match(ring, turned(ring, 2.5), [(k, k) for k in range(20)]))
    vectors = spokes_of(skeleton_of(decomposition)).vectors
    real = vectors.source_lengths > 1e-9
    np.testing.assert_allclose(vectors.rotations[real], 2.5, atol=1e-9)


def test_rotations_are_corrected_to_end_exactly_and_needless_turns_are_dropped():
    source, target = np.array([1 + 0j, 2j, -3 + 0j]), np.array([1j, -2 + 0j, -3j])
    vectors = PolarVectors.between(source, target, np.pi / 2 + 4 * np.pi + np.array([0.1, -0.1, 0]))
    np.testing.assert_allclose(vectors.rotations, np.pi / 2)
    np.testing.assert_allclose(vectors.at(np.array([1.0]))[0], target, atol=1e-15)
    np.testing.assert_allclose(vectors.at(np.array([0.5]))[0], source * np.exp(0.25j * np.pi), atol=1e-15)


def test_whole_turns_come_on_top_and_leave_the_ends():
    ring = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0)])
    made = {k: starskel.blend(ring, ring, [(0, 0)], "star-skeleton", turns=k) for k in (-1, 0, 2)}
    for each in made.values():
        np.testing.assert_allclose(each.at(0), ring, atol=1e-12)
        np.testing.assert_allclose(each.at(1), ring, atol=1e-12)
    middle = ring.mean(axis=0)
    np.testing.assert_allclose(made[2].at(0.25), 2 * middle - ring, atol=1e-12)
    np.testing.assert_allclose(made[-1].at(0.5), 2 * middle - ring, atol=1e-12)
    np.testing.assert_allclose(made[0].at(0.25), ring, atol=1e-12)


def test_the_tree_does_not_hang_on_how_polygons_are_turned():
    """Lengths were weighed by the polygons' boxes: that of a long thin one grows as it is turned."""
    source, target = two_opt(20, 57), two_opt(20, 557) * [1.0, 0.1]
    decomposition = decompose(match(source, target, [(0, 0), (4, 4)]))
    tree = skeleton_of(decomposition)
    for angle in (0.7, 2.2):
        moved = replace(
            decomposition,
            source=turned(decomposition.source, angle),
            target=turned(decomposition.target, angle),
        )
        found = skeleton_of(moved)
        assert (found.root, found.parents) == (tree.root, tree.parents)
