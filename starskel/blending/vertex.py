"""Vertex interpolation: every vertex on a straight line."""

import numpy as np

from starskel.arrays import Floats, read_only
from starskel.blending.frames import Blend


class VertexBlend(Blend):
    """Every vertex moves from the source to the target on a straight line, at constant speed."""

    method = "vertex"

    key_times = read_only(np.array([0.0, 1.0]))

    def _frames(self, ts: Floats) -> Floats:
        t = ts[:, None, None]
        return np.asarray((1 - t) * self.pair.source + t * self.pair.target)
