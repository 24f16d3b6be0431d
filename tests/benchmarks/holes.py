"""Holes of seeded pairs against shapely: in how many frames they leave their outline, meet or cross.

python -m tests.benchmarks.holes [--seeds N] [--first N] [--frames N] [--methods A,B]. Ends with status 1 if
a certified blend has such a frame, or if there is none.
"""

import argparse
import sys
import time
from collections.abc import Sequence

import numpy as np
import shapely

import starskel
from starskel import ShapeBlend, StarskelError
from starskel.shapes.certified.blend import CertifiedShapeBlend
from tests.benchmarks.timing import table
from tests.starskel.shapes.regions import holed_pair


def faults_of(blend: ShapeBlend, frames: int) -> tuple[int, int]:
    """Count the frames between source and target that are invalid, and those with a hole outside."""
    invalid = outside = 0
    for t in np.linspace(0, 1, frames)[1:-1]:
        invalid += not blend.shape_at(t).is_valid
        outline, *holes = map(shapely.Polygon, blend.at(t))
        outside += any(not shapely.contains_xy(outline, *hole.exterior.coords[0]) for hole in holes)
    return invalid, outside


def holes(seeds: Sequence[int], frames: int, methods: Sequence[str]) -> bool:
    """Print what becomes of the holes by each method; tell whether all certified blends are sound."""
    rows, sound = [], True
    for method in methods:
        seconds, counts, faulty, refused, repaired = 0.0, np.zeros(2, dtype=int), [], [], 0
        for seed in seeds:
            pair, start = holed_pair(seed), time.process_time()
            try:
                blend = starskel.blend(pair, method=method)
            except StarskelError as error:
                refused.append(f"{seed}: {error}")
                continue
            seconds += time.process_time() - start
            found = faults_of(blend, frames)
            counts += found
            faulty += [seed] if any(found) else []
            repaired += isinstance(blend, CertifiedShapeBlend) and blend.how != "as stitched"
        sound &= method != "certified" or not (faulty or refused)
        rows.append((method, len(refused), len(faulty), *counts.tolist(), repaired, seconds / len(seeds)))
        print(f"{method}: faulty {faulty}", *refused, sep="\n")
    heads = "method", "refused", "faulty pairs", "invalid frames", "hole outside", "repaired", "seconds each"
    table(f"{len(seeds)} pairs with one to four holes, {frames - 2} frames between", heads, rows)
    return sound


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=300)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--frames", type=int, default=21)
    parser.add_argument("--methods", default="stitched,certified")
    arguments = parser.parse_args()
    chosen = range(arguments.first, arguments.first + arguments.seeds)
    sys.exit(not holes(chosen, arguments.frames, arguments.methods.split(",")))
