import numpy as np
import pytest

from starskel.blending.certified.energies.barrier import reach_of
from starskel.blending.certified.energies.contacts import Distances
from starskel.blending.certified.energies.energy import Field
from starskel.blending.certified.energies.metric import metric_of
from starskel.blending.certified.energies.room import Room
from starskel.decomposition import decompose
from starskel.polar import as_complex
from starskel.task import UNWATCHED
from tests.starskel.blending.cases import pair_of, size_of


def energy_of(pair, frame, goal):
    metric = metric_of(decompose(pair), size_of(pair), UNWATCHED)
    field = Field(metric, Distances.of((), len(pair), reach_of(len(pair), metric.size)))
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


def test_strain_along_a_step_is_that_of_the_place_it_leads_to():
    pair = pair_of("run-walk")
    metric = metric_of(decompose(pair), size_of(pair), UNWATCHED)
    away, step = as_complex(pair.source - pair.target), as_complex(pair.target)
    still, slope, bend = metric.strains(away, step)
    there, _, _ = metric.strains(away + 0.3 * step, step)
    assert there == pytest.approx(still + 0.3 * slope + 0.09 * bend, rel=1e-9)


def test_distances_are_the_least_of_some_frames_or_unknown_where_large():
    square = np.array([0, 1, 1 + 1j, 1j])
    known = Distances.of((square, 0.5 * square), 4, 0.8)
    vertex, edge = np.array([0, 2, 0]), np.array([1, 3, 0])
    np.testing.assert_allclose(known.at(vertex, edge), [0.5, 0.5, np.inf])
    assert Distances.of((square,), 4, 0.8).at(vertex, edge).min() == np.inf


def test_links_with_hardly_any_room_left_are_decided_exactly():
    ring = np.array([[0, 0], [2, 0], [2, 2], [1, 1e-16], [0, 2]])
    room = Room.of((as_complex(ring),), 1e-3)
    assert room.links(ring, ring)
    across = ring.copy()
    across[3, 1] = -1e-16
    assert not room.links(ring, across)


@pytest.mark.parametrize("name", ["run-walk", "random-16-7"])
def test_a_form_with_inner_points_and_one_without_give_the_same_step(name, monkeypatch):
    pair = pair_of(name)
    frame, steps = as_complex(pair.source), []
    for most in (0, len(pair)):
        monkeypatch.setattr("starskel.blending.certified.energies.metric.DENSE", most)
        energy = energy_of(pair, pair.source, pair.target)
        steps.append(energy._step_by_coordinates(energy.barrier.linear(frame), frame - energy.goal))
    np.testing.assert_allclose(*steps, atol=1e-9 * size_of(pair))


def test_a_goal_turned_as_a_frame_that_is_a_moved_copy_is_that_frame():
    pair = pair_of("run-walk")
    metric = metric_of(decompose(pair), size_of(pair), UNWATCHED)
    goal = as_complex(pair.source)
    moved = goal * np.exp(2j) + 3 * size_of(pair)
    np.testing.assert_allclose(metric.turned(goal, moved), moved, atol=1e-7 * size_of(pair))


def test_a_goal_with_its_parts_turned_is_what_its_pairs_wish():
    pair = pair_of("random-16-7")
    metric = metric_of(decompose(pair), size_of(pair), UNWATCHED)
    goal, frame = as_complex(pair.source), as_complex(pair.target)
    weights = np.diag(np.diag(metric.stiffness)) - metric.stiffness
    wishes = goal[:, None] - goal
    turns = (weights * (frame[:, None] - frame) * wishes.conj()).sum(axis=1)
    turns /= np.abs(turns)
    pulls = (weights * (turns[:, None] + turns) / 2 * wishes).sum(axis=1)
    held = metric.stiffness.sum(axis=1) * frame
    np.testing.assert_allclose(
        metric.stiffness @ metric.turned(goal, frame), pulls + held, atol=1e-9 * np.abs(pulls).max()
    )
