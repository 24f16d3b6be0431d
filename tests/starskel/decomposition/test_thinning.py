"""Straight runs of very large rings: thinned out for the search for pieces, and whole in what it gives."""

import numpy as np
import pytest

import starskel
from starskel.decomposition import thinning
from starskel.decomposition.verify import faults

L = np.array([(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4)], dtype=float)
U = np.array([(0, 0), (5, 0), (5, 4), (4, 4), (4, 1), (1, 1), (1, 4), (0, 4)], dtype=float)
STAR = np.array([((1 + k % 2) * np.cos(k), (1 + k % 2) * np.sin(k)) for k in np.arange(10) * np.pi / 5])


def filled(corners, count):
    """Put so many vertices on each edge."""
    shares = np.arange(count)[:, None, None] / count
    return (corners + shares * (np.roll(corners, -1, axis=0) - corners)).transpose(1, 0, 2).reshape(-1, 2)


@pytest.mark.parametrize("algorithm", ["minimal", "convex"])
@pytest.mark.parametrize(
    ("source", "target"), [(L, U), (U, STAR), (U, U @ [[0, -1], [1, 0]])], ids=["0", "1", "2"]
)
def test_thinned_rings_give_pieces_of_all_vertices(source, target, algorithm, monkeypatch):
    pair = starskel.match(filled(source, 30), filled(target, 30), marks=[(0, 0), (60, 60)])
    whole = starskel.decompose(pair, algorithm=algorithm)
    monkeypatch.setattr(thinning, "MANY", 40)
    found = starskel.decompose(pair, algorithm=algorithm)
    assert not faults(found)
    assert len(found.pieces) <= len(whole.pieces) + 2
    ring = set(range(len(pair.source)))
    assert ring <= {v for piece in found.pieces for v in piece}


def test_what_turns_in_one_polygon_stays(monkeypatch):
    monkeypatch.setattr(thinning, "MANY", 40)
    round_ring = np.array([(np.cos(t), np.sin(t)) for t in np.linspace(0, 2 * np.pi, 100, endpoint=False)])
    pair = starskel.match(round_ring, filled(U, 20), marks=[(0, 0)])
    found = starskel.decompose(pair)
    assert not faults(found)
    assert len(found.source) >= len(pair.source) >= 160


def test_ten_thousand_collinear_vertices_on_each_side_are_decomposed(monkeypatch):
    square = starskel.match(filled(U[[0, 1, 2, 7]], 2500), filled(L[[0, 1, 5]], 3400), marks=[(0, 0)])
    assert len(square.source) >= 10_200
    found = starskel.decompose(square)
    assert len(found.pieces) == 1
    assert not faults(found)
    monkeypatch.setattr(thinning, "MANY", 200)
    bent = starskel.match(filled(L, 1700), filled(U, 1250), marks=[(0, 0)])
    assert len(bent.source) >= 10_200
    assert not faults(starskel.decompose(bent))
