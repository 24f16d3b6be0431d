"""The energy that a frame is to lessen: the strain towards the frame that is wanted, and what pairs push."""

from dataclasses import dataclass

import numpy as np

from starskel.blending.certified.barrier import Barrier
from starskel.blending.certified.metric import Metric
from starskel.predicates import Complex

PUSH = 1e-3
"""The weight of the energy that keeps pairs apart beside the strain."""


@dataclass(frozen=True, eq=False)
class Energy:
    """Half the strain from a goal, and the barrier's energy.

    Attributes
    ----------
    metric : Metric
    barrier : Barrier
    goal : (n,) complex array
        The frame that is wanted.
    """

    metric: Metric
    barrier: Barrier
    goal: Complex

    def of(self, frame: Complex) -> float:
        """Give the energy of a frame."""
        return self.metric.strain(frame - self.goal) + PUSH * self.barrier.energy(frame)

    def step(self, frame: Complex) -> Complex:
        """Give the Gauss-Newton step.

        Only pairs within reach need to be solved for (Woodbury's formula): without them the step is that to
        the goal.
        """
        near, away = self.barrier.linear(frame), frame - self.goal
        yields, matrix = near.products(self.metric.compliance)
        matrix.flat[:: len(matrix) + 1] += 1 / PUSH
        pushes = np.linalg.solve(matrix, near.changes(away) - near.logarithms)
        return np.asarray((pushes * near.slopes) @ yields - away)
