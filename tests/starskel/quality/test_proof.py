"""What is said for every t."""

import numpy as np
import pytest

from starskel.blending.edge_angle import EdgeAngleBlend
from starskel.blending.frames import Blend
from starskel.blending.vertex import VertexBlend
from starskel.correspondence import Correspondence, match
from starskel.outline import cross_themselves
from starskel.quality import measure


class Keyed(Blend):
    """Frames that move evenly between keys made up for a test."""

    def __init__(self, times, keys):
        rows = np.arange(keys.shape[1])
        super().__init__(Correspondence(keys[0], keys[-1], (), rows, rows))
        self.key_times, self._keys = np.array(times), keys

    def _frames(self, ts):
        places = [
            [np.interp(ts, self.key_times, self._keys[:, i, c]) for c in (0, 1)]
            for i in range(len(self.pair))
        ]
        return np.moveaxis(np.array(places), -1, 0)


SQUARE = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 4.0), (0.0, 4.0)])


def dipped(depth):
    """The square with the middle of its upper side pressed down."""
    ring = SQUARE.copy()
    ring[3, 1] -= depth
    return ring


def test_even_motions_are_proven_simple():
    report = measure(VertexBlend(match(SQUARE, 2 * SQUARE + 5, [(k, k) for k in range(5)])), frames=2)
    assert report.simple
    assert report.proven


def test_a_crossing_between_two_frames_is_found():
    """The dent goes through the lower side and comes back before the next frame looks."""
    blend = Keyed([0, 0.5, 0.51, 0.52, 1], np.stack([SQUARE, dipped(1), dipped(5), dipped(1), SQUARE]))
    report = measure(blend, frames=5)
    assert report.crossing_frames == ()
    assert report.proven
    assert not report.simple
    (crossing,) = report.crossings
    assert crossing.frame is None
    assert crossing.t == pytest.approx(0.5075, abs=0.002)
    assert crossing.t >= 0.5075
    assert len(crossing.places)
    np.testing.assert_allclose(crossing.places, [(2, 0)] * len(crossing.places), atol=0.8)
    assert not crossing.natural
    assert not report.crosses.any()


def test_a_touch_of_a_single_moment_is_found():
    report = measure(Keyed([0, 0.3, 1], np.stack([SQUARE, dipped(4), SQUARE])), frames=5)
    (crossing,) = report.crossings
    assert crossing.t == pytest.approx(0.3)


def test_keys_without_a_crossing_are_proven():
    assert measure(Keyed([0, 0.3, 1], np.stack([SQUARE, dipped(3.9), SQUARE])), frames=5).proven


def test_other_motions_are_looked_at_only(shape_pairs):
    pair = shape_pairs["letter-T-Y"]
    report = measure(EdgeAngleBlend(match(pair.source, pair.target, pair.marks)))
    assert report.simple
    assert not report.proven


def test_a_crossing_frame_is_proof_enough(shape_pairs):
    pair = shape_pairs["letter-C-S"]
    report = measure(VertexBlend(match(pair.source, pair.target, pair.marks)))
    assert report.crossing_frames
    assert report.proven


def test_samples_and_proof_agree(shape_pair):
    """What is proven simple crosses in none of a thousand frames, and what is not, in some of them."""
    made = VertexBlend(match(shape_pair.source, shape_pair.target, shape_pair.marks))
    crossing = cross_themselves(made.frames(np.linspace(0, 1, 1001)))
    assert measure(made).simple == (not crossing.any())
