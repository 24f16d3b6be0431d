"""What moves frames: the strain towards a frame that is wanted, and the pushes of pairs that come near."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.linalg import cho_factor, cho_solve, solve
from scipy.sparse import csc_array
from scipy.sparse.linalg import splu

from starskel.arrays import Complex, Floats
from starskel.blending.certified.energies.barrier import REACH_SHARE, Barrier, Linear, reach_of
from starskel.blending.certified.energies.contacts import Distances
from starskel.blending.certified.energies.metric import Form, Metric
from starskel.blending.certified.energies.room import Room
from starskel.polar import as_complex, as_points
from starskel.task import Task

Accepted = Callable[[Floats], bool]
"""Tells whether a frame is good to go to."""

FEW = 200
"""With fewer pairs that push, a step is solved for their pushes, else for the moves of points."""

HALVINGS = 5
"""How often a step is halved before it counts as stuck."""


@dataclass(frozen=True, eq=False)
class Field:
    """What the energies of a blend's frames have in common.

    Attributes
    ----------
    metric : Metric
    met : Distances
        Those in frames where nothing pushes.
    """

    metric: Metric
    met: Distances

    @classmethod
    def of(cls, metric: Metric, ends: tuple[Complex, ...]) -> "Field":
        """Let nothing push in the source and in the target."""
        n = len(ends[0])
        return cls(metric, Distances.of(ends, n, reach_of(n, metric.size) / REACH_SHARE))

    def meeting(self, *frames: Floats) -> "Field":
        """Give the same where nothing pushes in these frames, either."""
        return Field(self.metric, self.met.besides(*(as_complex(frame) for frame in frames)))

    def energy(self, now: Floats, goal: Floats, push: float, room: Room | None) -> "Energy":
        """Give the energy near to a frame.

        Parameters
        ----------
        now, goal : (n, 2) arrays
        push : float
            What keeping pairs apart weighs beside the strain.
        room : Room, optional
            What is never to be taken; without, pairs may come as near as they like.
        """
        barrier = Barrier.near(as_complex(now), self.met, reach_of(len(now), self.metric.size), room)
        return Energy(self.metric, barrier, as_complex(goal), push)


@dataclass(frozen=True, eq=False)
class Energy:
    """Half the strain from a goal, and the barrier's energy times its weight.

    Attributes
    ----------
    metric : Metric
    barrier : Barrier
    goal : (n,) complex array
    push : float
    """

    metric: Metric
    barrier: Barrier
    goal: Complex
    push: float

    def lessened(self, now: Floats, share: float, accepted: Accepted, task: Task) -> Floats | None:
        """Give the frame after as much of a share of a step as is good; None if hardly any is."""
        row = as_complex(now)
        step = self._step(row)
        still, slope, bend = self.metric.strains(row - self.goal, step)
        most = still + self.push * self.barrier.energy(row)
        for _ in range(HALVINGS):
            task.reach(0)
            there = row + share * step
            strain = still + share * (slope + share * bend)
            if strain + self.push * self.barrier.energy(there) < most and accepted(as_points(there)):
                return as_points(there)
            share /= 2
        return None

    def _step(self, frame: Complex) -> Complex:
        """Give the Gauss-Newton step, solved in one of two ways."""
        near, away = self.barrier.linear(frame), frame - self.goal
        if len(near.logarithms) < FEW:
            return self._step_by_pairs(near, away)
        return self._step_by_coordinates(near, away)

    def _step_by_pairs(self, near: Linear, away: Complex) -> Complex:
        """Solve for how hard pairs push (Woodbury's formula): without any the step is that to the goal."""
        yields, matrix = near.products(self.metric.compliance)
        matrix.flat[:: len(matrix) + 1] += 1 / self.push
        pushes = solve(matrix, near.changes(away) - near.logarithms, assume_a="pos")
        return as_complex((yields.T @ as_points(pushes * near.slopes)) - as_points(away))

    def _step_by_coordinates(self, near: Linear, away: Complex) -> Complex:
        """Solve for the moves of all points of the form: x and y behind one another."""
        both, n = self.metric.both, len(away)
        gradients = near.gradients(both.shape[0] // 2)
        displaced = np.zeros((2, both.shape[0] // 2))
        displaced[:, :n] = away.real, away.imag
        pulls = both @ displaced.ravel() + self.push * (gradients.T @ near.logarithms)
        x, y = _solved(both + self.push * (gradients.T @ gradients), -pulls).reshape(2, -1)[:, :n]
        return np.asarray(x + 1j * y)


def _solved(matrix: Form, right: Floats) -> Floats:
    """Solve a positive definite system."""
    if isinstance(matrix, np.ndarray):
        return np.asarray(cho_solve(cho_factor(matrix, check_finite=False), right, check_finite=False))
    factors = splu(
        csc_array(matrix),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    return np.asarray(factors.solve(right))
