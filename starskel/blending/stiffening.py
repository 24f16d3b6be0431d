"""Keeping frames simple: where they cross themselves, the parts that are squeezed there are made stiffer.

If that does not help, other balances between lengths, areas, inside and outline are tried in a fixed order.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from starskel.arrays import Complex, Flags, Floats
from starskel.blending.meshes.fans import Fans
from starskel.blending.meshes.improvement import with_better_edges
from starskel.blending.meshes.mesh import Mesh, mesh_of, triangle_areas
from starskel.blending.stitch import Graph, Stitch, edge_weights, graph_of
from starskel.outline import regions_cross
from starskel.polar import as_points
from starskel.task import Task


class Balance(NamedTuple):
    """A balance to try.

    Attributes
    ----------
    on_ring : float
        How much more the edges of the outline insist than those inside.
    area_share : float
        How much areas are corrected.
    yielding : float
        How much less distorted parts insist.
    flipped : bool
        Whether edges of the fans are flipped.
    rounds : int
        How often to stiffen what is squeezed, at most.
    """

    on_ring: float
    area_share: float
    yielding: float
    flipped: bool
    rounds: int = 12


BALANCES = (
    Balance(on_ring=3, area_share=0.95, yielding=1, flipped=True, rounds=1),
    Balance(on_ring=1, area_share=0.95, yielding=1, flipped=False),
    Balance(on_ring=10, area_share=0.95, yielding=0, flipped=False),
    Balance(on_ring=0.1, area_share=0.95, yielding=0, flipped=False),
    Balance(on_ring=0.1, area_share=0.95, yielding=0, flipped=True),
    Balance(on_ring=10, area_share=0.95, yielding=1, flipped=False),
    Balance(on_ring=3, area_share=0.95, yielding=1, flipped=True),
    Balance(on_ring=10, area_share=0, yielding=0, flipped=False),
)
"""What is tried in turn, the most pleasing balance first; each of the others settles pairs that those before
it do not.
"""

CHECKED = 512
"""Frames looked at. A look at 64 missed crossings between them in 4 of 234 pairs, one at 128 in 1."""

TIMES = np.linspace(0, 1, CHECKED + 2)[1:-1]
"""When these frames are: the ends need no look."""

_GLANCES = (16, 4, 1)
"""Every so many-th frame is looked at first, then of the others where none of these cross."""

_SQUEEZED = 0.2
"""Triangles under this part of their area are squeezed."""

_STIFFER = 3.0
"""The factor on the weights round a squeezed triangle, in each round."""

_HOPELESS = 0.8
"""A balance is given up where this part of the frames crosses twice running.

None of 134 seeded pairs that were settled at last had come to it; of unrelated rings of a hundred vertices it
saves four attempts of five.
"""

_MOST_POINTS = 2_000_000
"""Fewer rounds where the frames looked at first would have more vertices than this, all together."""

_BATCH = 8_000
"""So many vertices are looked at before asking again whether to stop: a few hundredths of a second's work."""


class Graphs:
    """The graphs of a pair's fans, with and without flipped edges, each made when it is first asked for.

    Parameters
    ----------
    fans : Fans
    starts : tuple of int
        The points at which rings begin.
    count : int
        How many of their points belong to rings.
    """

    def __init__(self, fans: Fans, starts: tuple[int, ...], count: int) -> None:
        self._fans = fans
        self._made: dict[bool, Graph] = {}
        self.starts = starts
        self.count = count

    def of(self, balance: Balance, task: Task) -> Graph:
        """Give the one that a balance is tried on."""
        if balance.flipped not in self._made:
            fans = with_better_edges(self._fans, task) if balance.flipped else self._fans
            self._made[balance.flipped] = graph_of(mesh_of(fans))
        return self._made[balance.flipped]


def plainest(graphs: Graphs, task: Task) -> Stitch:
    """Give the most pleasing stitch, whether it crosses or not."""
    balance = BALANCES[0]
    graph = graphs.of(balance, task)
    return Stitch.of(graph, edge_weights(graph.mesh, balance.on_ring, balance.yielding), balance.area_share)


def better(graphs: Graphs, task: Task) -> Iterator[tuple[Stitch, bool]]:
    """Give stitches, each with fewer crossing frames than the plainest and all before, and if it has none.

    The last is the best.

    Parameters
    ----------
    graphs : Graphs
    task : Task

    Raises
    ------
    Cancelled
        If the task is told to stop.
    """
    fewest = np.inf
    for number, balance in enumerate(BALANCES):
        for crossings, stitch in _attempts(graphs, balance, task.part(number / len(BALANCES), 1)):
            if crossings < fewest < np.inf:
                yield stitch, not crossings
            fewest = min(fewest, crossings)
            if not crossings:
                return


def _attempts(graphs: Graphs, balance: Balance, task: Task) -> Iterator[tuple[float, Stitch]]:
    """Give stitches, each stiffer where the one before was squeezed, and their shares of crossing frames."""
    graph, looked_at = graphs.of(balance, task), (graphs.count, graphs.starts)
    base = edge_weights(graph.mesh, balance.on_ring, balance.yielding)
    stiffness = np.ones(len(graph.mesh.source))
    affordable = _GLANCES[0] * _MOST_POINTS // (CHECKED * len(BALANCES) * graphs.count)
    before = 0.0
    for _ in range(max(1, min(balance.rounds, affordable))):
        weights = base * np.sqrt(stiffness[graph.mesh.edges].prod(axis=1))
        stitch = Stitch.of(graph, weights, balance.area_share)
        share, squeezed = _glanced(stitch, looked_at, task)
        yield share, stitch
        if not squeezed.any() or min(before, share) >= _HOPELESS:
            return
        before = share
        stiffness[np.unique(graph.mesh.triangles[squeezed])] *= _STIFFER


def _glanced(stitch: Stitch, looked_at: tuple[int, tuple[int, ...]], task: Task) -> tuple[float, Flags]:
    """Look ever more densely until some frames cross; give their share, and what is squeezed in them."""
    unseen = np.ones(CHECKED, dtype=np.bool_)
    for step in _GLANCES:
        glance = np.zeros_like(unseen)
        glance[step // 2 :: step] = True
        share, squeezed = _looked(stitch, TIMES[glance & unseen], looked_at, task)
        if share:
            break
        unseen &= ~glance
    return share, squeezed


def _looked(
    stitch: Stitch, ts: Floats, looked_at: tuple[int, tuple[int, ...]], task: Task
) -> tuple[float, Flags]:
    """Give the share of crossing frames, of so many points and rings that start so, and what is squeezed."""
    count, starts = looked_at
    step = max(1, _BATCH // count)
    mesh, crossings = stitch.graph.mesh, 0
    squeezed = np.zeros(len(mesh.triangles), dtype=np.bool_)
    for k in range(0, len(ts), step):
        task.reach(0)
        times = ts[k : k + step]
        points = stitch.points(times)
        crossing = regions_cross(as_points(points[:, :count]), starts)
        crossings += int(crossing.sum())
        squeezed |= _squeezed(mesh, points[crossing], times[crossing])
    return crossings / len(ts), squeezed


def _squeezed(mesh: Mesh, points: Complex, ts: Floats) -> Flags:
    """Tell which triangles are squeezed at some of the times."""
    t = ts[:, None]
    wanted = (1 - t) * mesh.source_areas + t * mesh.target_areas
    there = triangle_areas(points[:, mesh.triangles])
    return np.asarray(((wanted > 0) & (there < _SQUEEZED * wanted)).any(axis=0))
