"""How long setting up a blend, unfolding a frame and measuring all take, by method."""

import numpy as np

import starskel
from tests.benchmarks.decomposing import paired
from tests.benchmarks.timing import seconds, table
from tests.families import blob

TIMES = np.linspace(0.05, 0.95, 10)


def frames(most: int) -> None:
    for n in [n for n in (50, 200, 1000, 2000) if n <= most]:
        pair = paired(blob(n, 1), blob(n, 2))
        decomposition = starskel.decompose(pair)
        rows = []
        for method in starskel.METHODS:
            set_up = seconds(
                lambda m=method, p=pair, d=decomposition: starskel.blend(p, method=m, decomposition=d), 0.01
            )
            blend = starskel.blend(pair, method=method, decomposition=decomposition)
            single = seconds(lambda b=blend: [b.at(float(t)) for t in TIMES]) / len(TIMES)
            measured = seconds(lambda b=blend: starskel.measure(b), 0.01)
            rows.append((method, set_up * 1e3, measured * 1e3, single * 1e3))
        least = min(row[3] for row in rows)
        rows = [(*row, row[3] / least) for row in rows]
        table(
            f"Blends of {n} vertices", ("method", "set-up ms", "measure ms", "frame ms", "times least"), rows
        )
