"""Fuzz the readers at length: python -m tests.fuzzing [READER ...] [--examples N] [--seed N] [--atheris].

Each input must be read or refused by an error of the library's own within two seconds of processor time and
half a gigabyte. Each reader has a process of its own. With --atheris, of the extra `fuzz`, coverage leads the
way. What is neither read nor refused is kept in tests/files/broken.
"""

import argparse
import subprocess
import sys

from tests.fuzzing.readers import READERS

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("readers", nargs="*", default=list(READERS), metavar="READER", help=", ".join(READERS))
parser.add_argument("--examples", type=int, default=10_000, help="inputs of each reader")
parser.add_argument("--seed", type=int, default=0)
parser.add_argument("--atheris", action="store_true", help="follow coverage")
arguments = parser.parse_args()
how = "tests.fuzzing.following" if arguments.atheris else "tests.fuzzing.guessing"
for name in arguments.readers:
    command = [sys.executable, "-m", how, name, str(arguments.examples), str(arguments.seed)]
    done = subprocess.run(command, check=False)
    if done.returncode:
        sys.exit(f"{name}: ended with status {done.returncode}")
