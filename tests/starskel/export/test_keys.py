"""Keys keep what the settings say."""

import numpy as np
import pytest

from starskel.errors import Cancelled
from starskel.export.animation import Animation
from starskel.export.keys import keys, stretches
from starskel.sheet.drawing import Area, Group
from starskel.sheet.style import Look
from starskel.task import UNWATCHED, Task
from tests.starskel.export.films import arm, ring, steps


def outline(drawing):
    (frame,) = [item for item in drawing.items if isinstance(item, Group)]
    return next(item.ring for item in frame.items if isinstance(item, Area))


@pytest.mark.parametrize("make", [arm, ring, steps])
@pytest.mark.parametrize("tolerance", [0.01, 0.001])
def test_no_vertex_strays_farther_than_the_tolerance(make, tolerance):
    for shot in Animation(make(tolerance=tolerance, eased=True)).shots:
        times, drawings = keys(shot, UNWATCHED)
        own = np.array([outline(drawing) for drawing in drawings])
        looks = np.random.default_rng(1).random(500)
        known = np.array([outline(drawing) for drawing in shot.drawings(looks.tolist())])
        between = [[np.interp(looks, times, own[:, k, axis]) for axis in (0, 1)] for k in range(own.shape[1])]
        away = known - np.transpose(between, (2, 0, 1))
        assert np.hypot(away[..., 0], away[..., 1]).max() <= tolerance * 360


def test_what_moves_evenly_needs_two_keys_and_a_finer_tolerance_more_keys():
    (shot,) = Animation(arm("vertex", look=Look(colours=("#aa0000",)))).shots
    assert keys(shot, UNWATCHED)[0] == [0, 1]
    counts = [len(keys(Animation(arm(tolerance=t)).shots[0], UNWATCHED)[0]) for t in (0.05, 0.005, 0.0005)]
    assert counts == sorted(set(counts))


def test_stretches_follow_each_other_there_and_back():
    there = stretches(steps(), UNWATCHED)
    assert [(part.start, part.end) for part in there] == [
        (0, pytest.approx(1 / 3)),
        (pytest.approx(1 / 3), 1),
    ]
    back = stretches(steps(returning=True), UNWATCHED)
    bounds = [bound for part in back for bound in (part.start, part.end)]
    assert bounds == pytest.approx([0, 1 / 6, 1 / 6, 5 / 6, 5 / 6, 1])
    assert np.array_equal(outline(back[0].drawings[0]), outline(back[-1].drawings[-1]))
    assert np.array_equal(outline(back[1].drawings[0]), outline(back[1].drawings[-1]))


def test_looking_for_keys_can_be_stopped():
    with pytest.raises(Cancelled):
        stretches(arm(), Task(should_stop=lambda: True))
