"""Timing for comparisons within one run: the machines are shared, so only ratios mean anything."""

import time
from collections.abc import Callable, Sequence

import numpy as np


def seconds(work: Callable[[], object], least: float = 0.1) -> float:
    """The least time that a piece of work took, over as many runs as fit into `least` seconds."""
    best, spent = np.inf, 0.0
    while spent < least:
        start = time.perf_counter()
        work()
        took = time.perf_counter() - start
        best, spent = min(best, took), spent + took
    return float(best)


def exponent(sizes: Sequence[int], times: Sequence[float]) -> float:
    """The fitted exponent of growth."""
    return float(np.polyfit(np.log(sizes), np.log(times), 1)[0])


def table(title: str, heads: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    print(f"\n{title}")
    print("".join(f"{head:>16}" for head in heads))
    for row in rows:
        print("".join(f"{cell:>16.3g}" if isinstance(cell, float) else f"{cell!s:>16}" for cell in row))
