"""What holds for both methods that move the fans of all pieces."""

import numpy as np
import pytest

from starskel.blending.rigid import RigidBlend
from starskel.blending.stitched import StitchedBlend
from starskel.correspondence import match
from starskel.decomposition import decompose
from tests.families import subdivided, turned, two_opt
from tests.starskel.blending.cases import decomposition_of, size_of

TIMES = np.linspace(0, 1, 103)

both = pytest.mark.parametrize("method", [StitchedBlend, RigidBlend])


@both
@pytest.mark.parametrize("name", ["run-walk", "random-9-2", "arms-over-under"])
def test_exchanging_the_shapes_of_a_decomposition_is_exact(name, method):
    there = decomposition_of(name)
    times = np.array([0.0, 0.25, 0.5, 1.0])
    np.testing.assert_array_equal(method(there).frames(times), method(there.exchanged).frames(1 - times))


@both
@pytest.mark.parametrize("angle", [0.5, -2.0, 3.1])
def test_a_turned_copy_with_straight_runs_turns_rigidly(angle, method):
    """Degenerate triangles must not bend anything."""
    ring = subdivided(two_opt(7, 2), 5)
    decomposition = decompose(match(ring, turned(ring, angle), [(k, k) for k in range(len(ring))]))
    frames = method(decomposition).frames(TIMES)
    for t, frame in zip(TIMES, frames, strict=True):
        unturned = turned(frame, -t * angle)
        np.testing.assert_allclose(unturned - unturned[0], ring - ring[0], atol=1e-8)


@both
@pytest.mark.parametrize(
    ("source", "target", "mark"),
    [
        (two_opt(19, 14, grid=6), two_opt(19, 14, grid=6), (0, 1)),
        (subdivided(two_opt(8, 39, grid=5), 3), subdivided(two_opt(6, 48, grid=5), 3), (0, 0)),
    ],
    ids=["a fan's triangle vanishes in the source", "all lie on lines in the target"],
)
def test_triangles_that_lose_their_area_ask_for_nothing_at_that_end(source, target, mark, method):
    blend = method(decompose(match(source, target, [mark])))
    assert np.abs(blend.errors).max() < 1e-12 * size_of(blend.pair)
    assert np.isfinite(blend.frames(TIMES)).all()


@both
def test_ends_are_met_before_they_are_corrected(shape_pair, method):
    """The correction that makes the ends exact takes away rounding, nothing else."""
    decomposition = decompose(match(shape_pair.source, shape_pair.target, shape_pair.marks))
    blend = method(decomposition)
    assert np.abs(blend.errors).max() < 1e-9 * size_of(decomposition.pair)
