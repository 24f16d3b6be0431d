"""Keeping frames simple: where they cross themselves, the parts that are squeezed there are made stiffer.

If that does not help, other balances between lengths, areas, inside and outline are tried in a fixed order.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from starskel.blending.mesh import triangle_areas
from starskel.blending.stitch import Graph, Stitch, length_weights
from starskel.outline import Flags, cross_themselves
from starskel.polar import as_points
from starskel.predicates import Floats
from starskel.task import Task


class Rung(NamedTuple):
    """A balance to try.

    Attributes
    ----------
    on_ring : float
        How much more the edges of the outline insist than those inside.
    dial : float
        How much areas are corrected.
    """

    on_ring: float
    dial: float


LADDER = (Rung(3, 1), Rung(3, 0.5), Rung(3, 0), Rung(10, 0), Rung(1, 0), Rung(30, 0))
"""What is tried in turn, the most pleasing balance first."""

ROUNDS = 12
"""The most rounds of stiffening on each rung."""

CHECKED = 128
"""Frames looked at. A look at 64 missed crossings between them in 4 of 234 pairs."""

TIMES = np.linspace(0, 1, CHECKED + 2)[1:-1]
"""When these frames are: the ends need no look."""

_GLANCE = 4
"""Of large polygons only every so many-th frame is looked at first, the others where these do not cross."""

_SQUEEZED = 0.2
"""Triangles under this part of their area are squeezed."""

_STIFFER = 3.0
"""The factor on the weights round a squeezed triangle, in each round."""

_MOST_POINTS = 2_000_000
"""Polygons are large where the frames of all rounds would have more vertices than this, all together."""

_BATCH = 16_000
"""So many vertices are looked at before asking again whether to stop: under a tenth of a second's work."""


def stiffened(graph: Graph, count: int, task: Task) -> Stitch:
    """Give the stitch with the fewest crossing frames, the first of those.

    Parameters
    ----------
    graph : Graph
    count : int
        How many of its points belong to the outline.
    task : Task

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    found: list[tuple[float, Stitch]] = []
    for number, rung in enumerate(LADDER):
        for crossings, stitch in _attempts(graph, rung, count, task.part(number / len(LADDER), 1)):
            if not crossings:
                return stitch
            found.append((crossings, stitch))
    return min(found, key=lambda attempt: attempt[0])[1]


def _attempts(graph: Graph, rung: Rung, count: int, task: Task) -> Iterator[tuple[float, Stitch]]:
    """Give stitches, each stiffer where the one before was squeezed, and their shares of crossing frames."""
    base = length_weights(graph.mesh, rung.on_ring)
    stiffness = np.ones(len(graph.mesh.source))
    rounds, glance = _effort(count)
    for _ in range(rounds):
        weights = base * np.sqrt(stiffness[graph.mesh.edges].prod(axis=1))
        stitch = Stitch.of(graph, weights, rung.dial)
        times = TIMES[glance // 2 :: glance]
        crossing = _crossing(stitch, times, count, task)
        if glance > 1 and not crossing.any():
            times = np.setdiff1d(TIMES, times)
            crossing = _crossing(stitch, times, count, task)
        yield float(crossing.mean()), stitch
        squeezed = _squeezed(stitch, times[crossing])
        if not squeezed.any():
            return
        stiffness[np.unique(graph.mesh.triangles[squeezed])] *= _STIFFER


def _effort(count: int) -> tuple[int, int]:
    """Give how many rounds are worth while on a rung, and which part of the frames to look at first."""
    frames = _MOST_POINTS // (len(LADDER) * count)
    if frames >= ROUNDS * CHECKED:
        return ROUNDS, 1
    return max(1, min(ROUNDS, frames * _GLANCE // CHECKED)), _GLANCE


def _crossing(stitch: Stitch, ts: Floats, count: int, task: Task) -> Flags:
    """Tell which of the frames at these times cross themselves."""
    step = max(1, _BATCH // count)
    parts = []
    for k in range(0, len(ts), step):
        task.reach(0)
        parts.append(cross_themselves(as_points(stitch.points(ts[k : k + step])[:, :count])))
    return np.concatenate(parts)


def _squeezed(stitch: Stitch, ts: Floats) -> Flags:
    """Tell which triangles are squeezed at some of the times."""
    mesh, t = stitch.graph.mesh, ts[:, None]
    wanted = (1 - t) * mesh.source_areas + t * mesh.target_areas
    there = triangle_areas(stitch.points(ts)[:, mesh.triangles])
    return np.asarray(((wanted > 0) & (there < _SQUEEZED * wanted)).any(axis=0))
