"""The best places for Steiner vertices near to where they stand, by the kernels of the pieces round them.

The kernel of a piece is measured against the piece: its area over the square of the piece's perimeter.
"""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Complex, Floats, Indices
from starskel.decomposition.board import AT_ONCE, Board
from starskel.decomposition.kernels.clipping import Convex, boxes
from starskel.decomposition.kernels.half_planes import Lines, left_of_all
from starskel.decomposition.pieces import Piece, chain_after
from starskel.rings import Rings, blocks
from starskel.task import Task

WAYS = 8
"""Places are tried in so many directions."""


@dataclass(frozen=True, eq=False)
class BestPlaces:
    """What comes of the best place for each of k vertices, on each side, if all others stay.

    Attributes
    ----------
    places : (2, k, 2) array
    gains : (2, k) array
        The worth of the place, that of the worst kernel round it, over the same for where the vertex stands.
    stayed, moved : (2, c) complex arrays
        The middles of the kernels of the pieces round each vertex in turn, with it where it stands and there.
    """

    places: Floats
    gains: Floats
    stayed: Complex
    moved: Complex


def best_places(board: Board, around: dict[int, list[Piece]], stride: float, task: Task) -> BestPlaces:
    """Try places round all vertices, as many at once as one waits for when it is told to stop."""
    stars = list(around.items())
    sizes = np.array([sum(map(len, near)) for _, near in stars])
    found = [_best_places(board, dict(stars[part]), stride, task) for part in blocks(sizes, AT_ONCE)]
    every = zip(*((best.places, best.gains, best.stayed, best.moved) for best in found), strict=True)
    return BestPlaces(*(np.concatenate(parts, axis=1) for parts in every))


def _best_places(board: Board, around: dict[int, list[Piece]], stride: float, task: Task) -> BestPlaces:
    task.reach(0)
    chains = Rings.of([chain_after(piece, vertex) for vertex, near in around.items() for piece in near])
    counts = np.array([len(near) for near in around.values()])
    owner = np.repeat(np.arange(len(counts)), counts)
    own = board.at[:, list(around)]
    places = own[..., None] + _ways(
        board.at[:, chains.rows[chains.first]] - own[:, owner], chains, counts, stride
    )
    middles, worth = _worth(board.at[:, chains.rows], places, chains, owner, task)
    least = np.minimum.reduceat(worth, np.cumsum(counts) - counts, axis=1)
    best = least.argmax(axis=2)[..., None]
    with np.errstate(divide="ignore", invalid="ignore"):  # a kernel may be thinner than rounding can tell
        gains = np.take_along_axis(least, best, axis=2) / least[..., :1]
    moved = np.take_along_axis(middles, best[:, owner], axis=2)
    chosen = np.take_along_axis(places, best, axis=2).view(np.float64)
    return BestPlaces(chosen, gains[..., 0], middles[..., 0], moved[..., 0])


def _ways(spokes: Complex, chains: Rings, counts: Indices, stride: float) -> Complex:
    """Give the ways of vertices to the places to try: none, then WAYS round them.

    The first leads towards the first neighbour: so they turn with the shape.
    """
    first = np.cumsum(counts) - counts
    owner = np.repeat(np.arange(len(counts)), counts)
    foremost = np.lexsort((chains.rows[chains.first], owner))[first]
    length = np.add.reduceat(np.abs(spokes), first, axis=1) / counts
    step = stride * length * np.sign(spokes[:, foremost])
    turns = np.append(0, np.exp(2j * np.pi / WAYS * np.arange(WAYS)))
    ways: Complex = step[..., None] * turns
    return ways


def _worth(
    ends: Complex, tried: Complex, chains: Rings, owner: Indices, task: Task
) -> tuple[Complex, Floats]:
    """Give the kernels of the rings that places make with chains: middles, and areas against the rings.

    A kernel is cut along the chain once, and for each place along the two edges there.
    """
    cells = kernels_of_chains(ends, chains, owner, task)
    start, end = ends[:, chains.first, None], ends[:, chains.last, None]
    places = tried[:, owner]
    cells = cells.chosen(np.repeat(np.arange(len(cells.size)), places.shape[2]))
    cells = cells.left_of(places.ravel(), np.broadcast_to(start, places.shape).ravel())
    cells = cells.left_of(np.broadcast_to(end, places.shape).ravel(), places.ravel())
    along = np.abs(np.roll(ends, -1, axis=1) - ends)
    along[:, chains.last] = 0
    perimeters = np.add.reduceat(along, chains.first, axis=1)[..., None]
    perimeters = perimeters + np.abs(places - start) + np.abs(places - end)
    middles, areas = cells.measured()
    return middles.reshape(places.shape), areas.reshape(places.shape) / perimeters**2


def kernels_of_chains(ends: Complex, chains: Rings, owner: Indices, task: Task) -> Convex:
    """Give what lies to the left of all links of chains, in the boxes round all chains of their owners.

    Parameters
    ----------
    ends : (s, h) complex array
        The vertices of the chains on so many sides.
    chains : Rings
        They are not closed.
    owner : (k,) array of int
        Whose the chains are, in rising order.

    Returns
    -------
    s k cells, side by side.
    """
    sides, h = ends.shape
    foremost = chains.first[np.searchsorted(owner, np.arange(owner[-1] + 1))]
    shift = np.arange(sides)[:, None]
    box = boxes(ends.ravel(), (foremost + h * shift).ravel()).corners.reshape(sides, -1, 4)[:, owner]
    links = np.delete(np.arange(h), chains.last)
    start = np.concatenate([ends[:, links].ravel(), box.ravel()])
    end = np.concatenate([ends[:, links + 1].ravel(), np.roll(box, -1, axis=2).ravel()])
    cell = chains.owner[links] + len(owner) * shift
    order = np.argsort(np.concatenate([cell.ravel(), np.arange(sides * len(owner)).repeat(4)]), kind="stable")
    return left_of_all(Lines(start[order], (end - start)[order], np.tile(chains.counts + 3, sides)), task)
