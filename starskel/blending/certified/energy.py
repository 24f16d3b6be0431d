"""What moves frames: the strain towards a frame that is wanted, and the pushes of pairs that come near."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve

from starskel.arrays import Complex, Floats
from starskel.blending.certified.barrier import Barrier, Linear
from starskel.blending.certified.metric import Metric
from starskel.blending.certified.room import Room
from starskel.polar import as_complex, as_points
from starskel.task import Task

Accepted = Callable[[Floats], bool]
"""Tells whether a frame is good to go to."""

HALVINGS = 5
"""How often a step is halved before it counts as stuck."""


@dataclass(frozen=True, eq=False)
class Field:
    """What the energies of a blend's frames have in common.

    Attributes
    ----------
    metric : Metric
    met : tuple of (n,) complex arrays
        Frames where nothing pushes.
    """

    metric: Metric
    met: tuple[Complex, ...]

    def meeting(self, *frames: Floats) -> "Field":
        """Give the same where nothing pushes in these frames, either."""
        return Field(self.metric, (*self.met, *(as_complex(frame) for frame in frames)))

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
        barrier = Barrier.near(as_complex(now), self.met, self.metric.size, room)
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
        step, most = share * self._step(row), self._of(row)
        for _ in range(HALVINGS):
            task.reach(0)
            there = row + step
            if self._of(there) < most and accepted(as_points(there)):
                return as_points(there)
            step = step / 2
        return None

    def _of(self, frame: Complex) -> float:
        return self.metric.strain(frame - self.goal) + self.push * self.barrier.energy(frame)

    def _step(self, frame: Complex) -> Complex:
        """Give the Gauss-Newton step: solve for pairs where these are fewer, else for coordinates."""
        near, away = self.barrier.linear(frame), frame - self.goal
        if len(near.logarithms) < 2 * len(frame):
            return self._step_by_pairs(near, away)
        return self._step_by_coordinates(near, away)

    def _step_by_pairs(self, near: Linear, away: Complex) -> Complex:
        """Solve for how hard pairs push (Woodbury's formula): without any the step is that to the goal."""
        yields, matrix = near.products(self.metric.compliance)
        matrix.flat[:: len(matrix) + 1] += 1 / self.push
        pushes = solve(matrix, near.changes(away) - near.logarithms, assume_a="pos")
        return as_complex((yields.T @ as_points(pushes * near.slopes)) - as_points(away))

    def _step_by_coordinates(self, near: Linear, away: Complex) -> Complex:
        """Solve for the moves of all vertices, x and y behind one another."""
        n, stiffness = len(away), self.metric.stiffness
        gradients = near.gradients(n)
        matrix = (self.push * gradients.T @ gradients).toarray()
        matrix[:n, :n] += stiffness
        matrix[n:, n:] += stiffness
        pulls = np.concatenate([stiffness @ away.real, stiffness @ away.imag])
        moves = solve(matrix, -pulls - self.push * (gradients.T @ near.logarithms), assume_a="pos")
        return np.asarray(moves[:n] + 1j * moves[n:])
