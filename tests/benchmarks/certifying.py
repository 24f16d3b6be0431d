"""Certificates against brute force: many frames of certified blends are looked at, one by one.

python -m tests.benchmarks.certifying [FILE ...] [--samples N] [--seeds N]: the pairs of files, and of the
seeded families. Ends with status 1 if a frame of a certified blend crosses itself.
"""

import argparse
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import starskel
from starskel.arrays import Floats
from starskel.blending.certified import CertifiedBlend
from starskel.correspondence import Correspondence
from starskel.files.pairs import read_pairs
from starskel.outline import cross_themselves
from tests.families import related, two_opt

BATCH = 200_000
"""So many vertices of frames are looked at together."""


def crossing_samples(blend: CertifiedBlend, samples: int) -> int:
    """Count the frames that cross themselves, of evenly spread ones."""
    ts = np.linspace(0, 1, samples)
    step = max(1, BATCH // len(blend.pair))
    return sum(int(cross_themselves(blend.frames(ts[k : k + step])).sum()) for k in range(0, samples, step))


def families(seeds: int) -> Iterator[tuple[str, Correspondence]]:
    """Give the seeded families, matched by index: random rings, and related ones."""
    for n in (12, 20):
        for seed in range(seeds):
            yield f"random-{n}-{seed}", by_index(two_opt(n, seed), two_opt(n, seed + 1000))
    for seed in range(seeds):
        yield f"related-20-{seed}", by_index(*related(20, seed))


def from_file(path: Path) -> Iterator[tuple[str, Correspondence]]:
    """Give the pairs of a file."""
    given = read_pairs(path)
    for name in given.ids:
        pair = given.pair(name)
        yield name, starskel.match(pair.source, pair.target, pair.marks)


def by_index(source: Floats, target: Floats) -> Correspondence:
    return starskel.match(source, target, [(k, k) for k in range(len(source))])


def certified(pairs: Iterator[tuple[str, Correspondence]], samples: int) -> bool:
    """Print what each pair's certificate is worth; tell whether all hold."""
    print(f"{'pair':>26}{'vertices':>10}{'seconds':>9}{'keys':>6}{'clearance':>11}{'crossing':>10}  how")
    holds, hows = True, []
    for name, pair in pairs:
        start = time.process_time()
        blend = CertifiedBlend(starskel.decompose(pair))
        took = time.process_time() - start
        crossing = crossing_samples(blend, samples)
        size = float(np.ptp(pair.source, axis=0).max())
        print(
            f"{name:>26}{len(pair):>10}{took:>9.2f}{len(blend.keys):>6}{blend.clearance / size:>11.1e}"
            f"{crossing:>10}  {blend.how}",
            flush=True,
        )
        holds &= not crossing
        hows.append(str(blend.how))
    print(
        f"{len(hows)} pairs, {samples} frames each: { ({how: hows.count(how) for how in sorted(set(hows))}) }"
    )
    return holds


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="*", type=Path, help="of pairs")
    parser.add_argument("--samples", type=int, default=20_000)
    parser.add_argument("--seeds", type=int, default=60, help="of each family")
    arguments = parser.parse_args()
    every = [certified(from_file(file), arguments.samples) for file in arguments.files]
    sys.exit(not all([*every, certified(families(arguments.seeds), arguments.samples)]))
