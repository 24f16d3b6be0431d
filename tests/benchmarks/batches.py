"""The throughput of batches, and killing them: python -m tests.benchmarks.batches [--pairs N] [--kills N].

As many seeded pairs are blended and measured by one process, by two, and by two that are killed at random
moments and begun again. The ratio means something on a machine that has nothing else to do: its load is told.
"""

import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from starskel.files.pairs import ShapePair, write_pairs
from starskel.polygon import Polygon

COMMAND = [sys.executable, "-c", "import sys; from starskel.cli import main; sys.exit(main())", "batch"]
WORDS = ["--methods", "stitched", "--frames", "21"]
VERTICES = 24


def star(seed: int) -> Polygon:
    """Give a polygon of random radii at even angles."""
    radii = np.random.default_rng(seed).uniform(1, 2, VERTICES)
    angles = np.linspace(0, 2 * np.pi, VERTICES, endpoint=False)
    return Polygon(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]))


def keys(folder: Path) -> list[str]:
    """Give the pairs of which whole lines of results are there."""
    path = folder / "results.jsonl"
    lines = path.read_bytes().splitlines(keepends=True) if path.exists() else []
    return [json.loads(line)["key"] for line in lines if line.endswith(b"\n")]


def begun(place: Path, folder: Path, processes: int) -> "subprocess.Popen[bytes]":
    """Begin a batch, or go on with it."""
    words = [str(place), "-o", str(folder), *WORDS, "--processes", str(processes)]
    return subprocess.Popen([*COMMAND, *words], stdout=subprocess.DEVNULL)


def seconds(place: Path, folder: Path, processes: int) -> float:
    """Do a whole batch and give how long it took."""
    start = time.perf_counter()
    if begun(place, folder, processes).wait():
        raise SystemExit("the batch failed")
    return time.perf_counter() - start


def killed(place: Path, folder: Path, count: int, kills: int) -> int:
    """Kill a batch so often, each time after some of what is left; give how often it was alive then."""
    chance, alive = random.Random(7), 0
    for left in range(kills, 0, -1):
        done = len(keys(folder))
        wanted = done + chance.randint(1, max(1, 2 * (count - done) // (left + 1)))
        running = begun(place, folder, 2)
        while running.poll() is None and len(keys(folder)) < wanted:
            time.sleep(0.02)
        alive += running.poll() is None
        running.kill()
        running.wait()
    return alive


def main(count: int, kills: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        place, folders = Path(folder) / "pairs", [Path(folder) / name for name in ("one", "two", "killed")]
        place.mkdir()
        pairs = [ShapePair(f"p{k}", star(k), star(k + count), ((0, 0),)) for k in range(count)]
        write_pairs(place / "pairs.json", pairs)
        loads = [os.getloadavg()[0]]
        one = seconds(place, folders[0], 1)
        two = seconds(place, folders[1], 2)
        loads.append(os.getloadavg()[0])
        print(
            f"{count} pairs by stitched: {count / one:.1f} a second by one process, {count / two:.1f} by two"
        )
        print(f"two are {one / two:.2f} times as fast; load before {loads[0]:.1f}, after {loads[1]:.1f}")
        alive = killed(place, folders[2], count, kills)
        seconds(place, folders[2], 2)
        found = [keys(each) for each in folders]
        once = all(len(set(own)) == len(own) == count for own in found)
        print(f"killed {alive} times and begun again: every pair {'once' if once else 'NOT ONCE'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Say how fast batches are, and whether they lose anything.")
    parser.add_argument("--pairs", type=int, default=2000)
    parser.add_argument("--kills", type=int, default=10)
    arguments = parser.parse_args()
    main(arguments.pairs, arguments.kills)
