"""Pairs for the tests of all methods, each decomposed once."""

from functools import cache

import numpy as np

from starskel.arrays import Floats
from starskel.correspondence import Correspondence, match
from starskel.decomposition import Decomposition, decompose
from tests.conftest import FILES
from tests.families import two_opt

NAMED = (
    "letter-T-Y",
    "letter-K-X",
    "letter-C-S",
    "star5-to-star8",
    "wrench-hammer",
    "run-walk",
    "hand-open",
    "arms-swing",
    "arms-over-under",
    "spiral-opposite",
)
RANDOM = tuple(f"random-{n}-{seed}" for n, seed in ((6, 1), (9, 2), (12, 3), (12, 5), (16, 7)))
CASES = (*NAMED, *RANDOM)


@cache
def shapes(name: str) -> tuple[Floats, Floats, tuple[tuple[int, int], ...]]:
    """The two rings of a case, and its marks."""
    if name in RANDOM:
        _, n, seed = name.split("-")
        return two_opt(int(n), int(seed)), two_opt(int(n), int(seed) + 50), ((0, 0), (3, 3))
    pair = FILES[name].pair(name)
    return pair.source.vertices, pair.target.vertices, pair.marks


@cache
def pair_of(name: str) -> Correspondence:
    """The complete correspondence of a case."""
    return match(*shapes(name))


@cache
def decomposition_of(name: str) -> Decomposition:
    """Its decomposition."""
    return decompose(pair_of(name))


def size_of(pair: Correspondence) -> float:
    """The longer side of the larger box."""
    return float(max(np.ptp(pair.source, axis=0).max(), np.ptp(pair.target, axis=0).max()))
