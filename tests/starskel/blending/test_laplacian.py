import threading
from pathlib import Path

import numpy as np
import pytest
from scipy.sparse.linalg import splu

from starskel.blending import laplacian
from starskel.blending.laplacian import KEPT, factor, factors_kept


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
    wanted = rng.normal(size=(3, count, 2))
    right = np.einsum("ij,kjc->kic", matrix, wanted)
    factored = factor(edges, weights, diagonal)
    np.testing.assert_allclose(factored.solve(right), wanted, atol=1e-8)
    np.testing.assert_allclose(factored.solve(right[..., 0]), wanted[..., 0], atol=1e-8)


@every_graph
def test_each_right_side_is_solved_by_itself(edges):
    count = int(edges.max()) + 1
    rng = np.random.default_rng(2)
    right = rng.normal(size=(7, count, 2))
    factored = factor(edges, rng.uniform(0.1, 10, len(edges)), np.ones(count))
    together = factored.solve(right)
    for k in range(7):
        np.testing.assert_array_equal(factored.solve(right[k : k + 1])[0], together[k])
    assert factored.solve(right[:0]).shape == (0, count, 2)


def pages():
    """The memory in use, in bytes."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096


def run_in_a_thread(work):
    thread = threading.Thread(target=work)
    thread.start()
    thread.join()


def test_another_thread_solves_to_the_same_bits():
    factored = factor(GRAPHS["many fans"], np.full(len(GRAPHS["many fans"]), 0.7), np.ones(640))
    right, found = np.random.default_rng(3).normal(size=(2, 640)), []
    run_in_a_thread(lambda: found.append(factored.solve(right)))
    np.testing.assert_array_equal(found[0], factored.solve(right))


only_linux = pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="tells its memory in a file")


@only_linux
def test_threads_that_come_and_go_leave_no_memory_behind():
    edges = GRAPHS["everything linked"]
    weights, diagonal, right = np.ones(len(edges)), np.ones(230), np.ones((1, 230))

    def work():
        for _ in range(8):
            factor(edges, weights, diagonal).solve(right)

    run_in_a_thread(work)
    before = pages()
    for _ in range(30):
        run_in_a_thread(work)
    assert pages() - before < 60e6, "240 factors take 130 MB"


def test_a_thread_keeps_the_factors_that_it_used_last(monkeypatch):
    counted = []
    monkeypatch.setattr(laplacian, "splu", lambda *given, **how: counted.append(given) or splu(*given, **how))
    edges, right = GRAPHS["a triangle"], np.ones((1, 3))
    several = [factor(edges, np.ones(3), np.ones(3)) for _ in range(KEPT + 1)]
    for each in several[:KEPT]:
        each.solve(right)
    several[0].solve(right)
    assert len(counted) == KEPT
    several[KEPT].solve(right)
    several[0].solve(right)
    assert len(counted) == KEPT + 1
    several[1].solve(right)  # the one that had not been used for the longest time
    assert len(counted) == KEPT + 2


def test_other_threads_keep_factors_while_their_work_goes_on(monkeypatch):
    counted, kept = [], []
    monkeypatch.setattr(laplacian, "splu", lambda *given, **how: counted.append(given) or splu(*given, **how))
    factored, right = factor(GRAPHS["a triangle"], np.ones(3), np.ones(3)), np.ones((1, 3))

    def work():
        with factors_kept():
            factored.solve(right)
            with factors_kept():
                factored.solve(right)
            factored.solve(right)
            kept.append(len(laplacian._RECENT.factors))
        kept.append(len(laplacian._RECENT.factors))
        factored.solve(right)
        kept.append(len(laplacian._RECENT.factors))

    run_in_a_thread(work)
    assert len(counted) == 2
    assert kept == [1, 0, 0]
