import numpy as np
import pytest

from starskel.blending.dissection import BLOCK, dissect
from starskel.blending.elimination import factor


def grid(rows, columns):
    points = np.arange(rows * columns).reshape(rows, columns)
    across = np.stack([points[:, :-1].ravel(), points[:, 1:].ravel()], axis=1)
    down = np.stack([points[:-1].ravel(), points[1:].ravel()], axis=1)
    return np.concatenate([across, down])


def wheels(ring, hubs):
    """A ring whose runs are fanned from hubs, the hubs linked in a row."""
    edges = [(k, (k + 1) % ring) for k in range(ring)] + [(ring + h, ring + h + 1) for h in range(hubs - 1)]
    for h in range(hubs):
        edges += [(k % ring, ring + h) for k in range(h * ring // hubs, (h + 1) * ring // hubs + 1)]
    return np.unique(np.sort(np.array(edges), axis=1), axis=0)


GRAPHS = {
    "a triangle": np.array([(0, 1), (0, 2), (1, 2)]),
    "a small fan": wheels(20, 1),
    "a large fan": wheels(700, 1),
    "many fans": wheels(600, 40),
    "a chain": np.stack([np.arange(499), np.arange(1, 500)], axis=1),
    "a grid": grid(25, 25),
    "everything linked": np.argwhere(np.triu(np.ones((230, 230)), 1)),
}

every_graph = pytest.mark.parametrize("edges", GRAPHS.values(), ids=GRAPHS)


@every_graph
def test_no_edge_leads_from_one_block_to_another_and_no_point_is_lost(edges):
    count = int(edges.max()) + 1
    parts = dissect(edges, count)
    points = np.concatenate([parts.separator, parts.blocks[parts.blocks < count]])
    np.testing.assert_array_equal(np.sort(points), np.arange(count))
    assert parts.blocks.shape[1] <= 2 * BLOCK
    home = np.full(count, -1)
    for k, block in enumerate(parts.blocks):
        home[block[block < count]] = k
    i, j = home[edges].T
    assert ((i == j) | (i < 0) | (j < 0)).all()


@every_graph
def test_solutions_are_those_of_the_whole_matrix(edges):
    count = int(edges.max()) + 1
    rng = np.random.default_rng(1)
    weights, diagonal = rng.uniform(0.1, 10, len(edges)), np.zeros(count)
    diagonal[rng.integers(count)] = 2.0
    matrix = np.diag(diagonal)
    i, j = edges.T
    for a, b in ((i, j), (j, i)):
        matrix[a, b] -= weights
        np.add.at(matrix, (a, a), weights)
    wanted = rng.normal(size=(3, count))
    solution = factor(dissect(edges, count), weights, diagonal).solve(wanted @ matrix)
    np.testing.assert_allclose(solution, wanted, atol=1e-8)


def test_large_meshes_fall_into_many_small_blocks():
    parts = dissect(wheels(2000, 3), 2003)
    assert len(parts.separator) < 80
    assert parts.blocks.shape[1] <= BLOCK
