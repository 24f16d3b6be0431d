import numpy as np
import pytest

from starskel.correspondence import Correspondence
from starskel.decomposition import decompose
from starskel.decomposition.canonical import canonical
from starskel.decomposition.pieces import from_least
from tests.families import comb, related, subdivided, turned, two_opt

PAIRS = {
    **{f"random {seed}": (two_opt(16, seed), two_opt(16, seed + 50)) for seed in (1, 2, 3, 7, 10, 14)},
    "random 30": (two_opt(30, 4), two_opt(30, 1004)),
    "related": related(20, 26),
    "straight runs": (subdivided(two_opt(8, 6), 4), turned(subdivided(two_opt(8, 1006), 4), 0.5)),
}


def paired(source, target) -> Correspondence:
    rows = np.arange(len(source))
    return Correspondence(source, target, (), rows, rows)


def mirrored(ring):
    return np.roll((ring * (-1, 1))[::-1], 1, axis=0)


CHANGES = {
    "moved": lambda ring: ring + np.array((1000, -50)),
    "turned": lambda ring: turned(ring, 1.0),
    "scaled up": lambda ring: ring * 1e6,
    "scaled down": lambda ring: ring * 1e-6,
    "start shifted": lambda ring: np.roll(ring, 5, axis=0),
    "mirrored": mirrored,
}


def distances(rings):
    """All distances in both rings: what moving, turning and mirroring leave alone, and scaling but scales."""
    z = np.stack([ring.view(np.complex128)[:, 0] for ring in rings])
    apart = np.abs(z[:, :, None] - z[:, None])
    return apart / apart.max()


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
@pytest.mark.parametrize("name", PAIRS)
def test_a_pair_is_read_in_one_way_wherever_it_lies(name, change):
    pair, moved = paired(*PAIRS[name]), paired(*map(change, PAIRS[name]))
    read, again = ([np.ascontiguousarray(ring) for ring in canonical(p).read(p)] for p in (pair, moved))
    np.testing.assert_allclose(distances(again), distances(read), atol=1e-9)


@pytest.mark.parametrize("name", PAIRS)
def test_swapped_polygons_are_read_alike_to_the_bit(name):
    source, target = PAIRS[name]
    there, back = paired(source, target), paired(target, source)
    for first, second in zip(canonical(there).read(there), canonical(back).read(back), strict=True):
        np.testing.assert_array_equal(first, second)


@pytest.mark.parametrize("shift", [1, 4, 9])
def test_symmetric_pairs_are_read_alike_wherever_they_start(shift):
    """Distances alone do not tell the two ends of a comb apart."""
    pair = paired(comb(5), comb(5) * 2)
    shifted = paired(np.roll(comb(5), shift, axis=0), np.roll(comb(5) * 2, shift, axis=0))
    for first, second in zip(canonical(pair).read(pair), canonical(shifted).read(shifted), strict=True):
        np.testing.assert_array_equal(first, second)


@pytest.mark.parametrize("name", PAIRS)
def test_a_mirrored_pair_has_the_mirrored_decomposition(name):
    source, target = PAIRS[name]
    n = len(source)
    there, back = decompose(paired(source, target)), decompose(paired(mirrored(source), mirrored(target)))
    for side in ("source", "target"):
        np.testing.assert_array_equal(getattr(back, side)[n:], getattr(there, side)[n:] * (-1, 1))
    expected = [tuple(v if v >= n else -v % n for v in piece)[::-1] for piece in there.pieces]
    assert list(map(from_least, back.pieces)) == list(map(from_least, expected))
