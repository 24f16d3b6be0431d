"""The paper's two algorithms side by side: pieces, Steiner vertices, time."""

import numpy as np

from starskel.decomposition import decompose
from starskel.decomposition.decompose import ALGORITHMS
from tests.benchmarks.decomposing import paired
from tests.benchmarks.timing import seconds, table
from tests.families import blob, comb, related, spiral, subdivided, turned, two_opt

FAMILIES = {
    "random 12": lambda seed: (two_opt(12, seed), two_opt(12, seed + 1000)),
    "random 20": lambda seed: (two_opt(20, seed), two_opt(20, seed + 1000)),
    "random 40": lambda seed: (two_opt(40, seed), two_opt(40, seed + 1000)),
    "grid 20": lambda seed: (two_opt(20, seed, 6), two_opt(20, seed + 1000, 6)),
    "related 20": lambda seed: related(20, seed),
    "combs": lambda seed: (comb(6), np.roll(comb(6), 3 + seed, axis=0)),
    "spirals": lambda seed: (spiral(30), np.roll(spiral(30, 1.5), 1 + seed, axis=0)),
    "straight runs": lambda seed: (
        subdivided(two_opt(8, seed), 4),
        turned(subdivided(two_opt(8, ~seed & 99), 4), 1),
    ),
    "smooth 100": lambda seed: (blob(100, seed), blob(100, seed + 1, 4)),
}


def algorithms(seed: int, pairs: int) -> None:
    """Decompose a few pairs of each family by both algorithms; means, and the ratio of times."""
    rows = []
    for name, family in FAMILIES.items():
        chosen = [paired(*family(seed + k)) for k in range(max(1, pairs // 10))]
        row: list[object] = [name]
        times = []
        for algorithm in ALGORITHMS:
            found = [decompose(pair, algorithm=algorithm) for pair in chosen]
            row += [
                float(np.mean([len(d.pieces) for d in found])),
                float(np.mean([len(d.source) - len(d.pair) for d in found])),
            ]
            times.append(
                sum(seconds(lambda p=p, a=algorithm: decompose(p, algorithm=a), 0.01) for p in chosen)
            )
        rows.append((*row, times[0] * 1e3 / len(chosen), times[1] / times[0]))
    heads = ("family", "minimal: pieces", "Steiner", "convex: pieces", "Steiner", "minimal ms", "convex x")
    table("Both algorithms, on average", heads, rows)
