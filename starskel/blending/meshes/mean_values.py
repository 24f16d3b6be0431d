"""Mean value coordinates (Floater 2003): every point of a mesh as a mean of its neighbours."""

import numpy as np
from scipy import sparse

from starskel.arrays import Complex, Indices
from starskel.blending.meshes.mesh import corner_angles

_FLATTEST = 1e-6
"""Angles keep so far from 0 and from pi: some triangles have no area, where vertices lie on a line."""


def mean_values(points: Complex, triangles: Indices) -> sparse.csr_array:
    """Give the weights of each point's neighbours, (m, m), each row summing up to 1.

    A point inside the mesh is the mean of its neighbours with these weights, all of which are positive.
    """
    corners = points[triangles]
    angles = np.clip(corner_angles(corners), _FLATTEST, np.pi - _FLATTEST)
    halves = np.tan(angles / 2)
    rows, columns, values = [], [], []
    for step in (1, 2):
        other = np.roll(triangles, -step, axis=1)
        distances = np.maximum(np.abs(points[other] - corners), np.finfo(np.float64).tiny)
        rows.append(triangles.ravel())
        columns.append(other.ravel())
        values.append((halves / distances).ravel())
    count = len(points)
    entries = np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))
    weights = sparse.csr_array(entries, shape=(count, count))
    return sparse.csr_array(sparse.diags_array(1 / weights.sum(axis=1)) @ weights)
