import numpy as np
import pytest

from starskel.blending.certified.energy import Field
from starskel.blending.certified.metric import metric_of
from starskel.decomposition import decompose
from starskel.polar import as_complex
from starskel.task import UNWATCHED
from tests.starskel.blending.cases import pair_of, size_of


def energy_of(pair, frame, goal):
    field = Field(metric_of(decompose(pair), size_of(pair), UNWATCHED), ())
    return field.energy(frame, goal, 1e-3, None)


@pytest.mark.parametrize("name", ["run-walk", "spiral-opposite", "random-16-7"])
def test_solving_for_pairs_and_for_coordinates_gives_the_same_step(name):
    pair = pair_of(name)
    energy = energy_of(pair, pair.source, pair.target)
    frame = as_complex(pair.source)
    near, away = energy.barrier.linear(frame), frame - energy.goal
    assert len(near.logarithms)
    np.testing.assert_allclose(
        energy._step_by_pairs(near, away), energy._step_by_coordinates(near, away), atol=1e-9 * size_of(pair)
    )
