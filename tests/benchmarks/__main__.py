"""Run all benchmarks: python -m tests.benchmarks [--seed N] [--pairs N] [--most N]."""

import argparse

from tests.benchmarks import algorithms, blending, decomposing, editing, fluency, holes, images

parser = argparse.ArgumentParser(description="Show speed as ratios within one run, and prove seeded results.")
parser.add_argument("--seed", type=int, default=0, help="of the pairs that are decomposed and proven")
parser.add_argument("--pairs", type=int, default=60, help="how many of them")
parser.add_argument("--most", type=int, default=2000, help="the largest number of vertices")
arguments = parser.parse_args()
decomposing.visibility_against_shapely(arguments.most)
decomposing.growth(arguments.most)
decomposing.stopping(arguments.most)
decomposing.steiner_vertices(arguments.seed, arguments.pairs)
algorithms.algorithms(arguments.seed, arguments.pairs)
decomposing.any_seed(arguments.seed, arguments.pairs)
blending.frames(arguments.most)
holes.holes(range(20), 21, ("stitched", "certified"))
images.pictures()
editing.editing(arguments.most)
fluency.lateness()
