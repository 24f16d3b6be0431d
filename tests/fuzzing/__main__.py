"""Fuzz the readers at length: python -m tests.fuzzing [READER ...] [--examples N] [--seed N] [--atheris].

Each input must be read or refused by an error of the library's own within two seconds of processor time, and
the process must stay below half a gigabyte. With --atheris, where it is installed, coverage leads the way.
"""

import argparse
import faulthandler
import resource
import sys
import time
import warnings
from collections import Counter
from inspect import isfunction
from pathlib import Path

from hypothesis import HealthCheck, Phase, given, seed, settings

from starskel import StarskelError
from tests.fuzzing.mutations import broken
from tests.fuzzing.readers import READERS, Reader

LAST = Path("build/fuzzing.input")
"""Where the input lies that is being read: a crash leaves it there."""

SECONDS = 2.0
BYTES = 512 << 20


class Bound(Exception):  # noqa: N818 -- it says what was overstepped
    """An input took more time than it may."""


def check(reader: Reader, content: bytes, outcomes: Counter[str]) -> float:
    """Read an input; give the seconds that it took."""
    LAST.write_bytes(content)
    start = time.process_time()
    try:
        reader.read(content)
        outcomes["read"] += 1
    except StarskelError:
        outcomes["refused"] += 1
    taken = time.process_time() - start
    if taken > SECONDS:
        raise Bound(f"{taken:.1f} s for {len(content)} bytes")
    return taken


def fuzz(reader: Reader, examples: int, first: int) -> None:
    """Run hypothesis over one reader, and tell what came of it."""
    outcomes: Counter[str] = Counter()
    longest = 0.0

    @seed(first)
    @settings(
        max_examples=examples,
        database=None,
        deadline=None,
        phases=(Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
    )
    @given(content=broken(reader.seeds()))
    def run(content: bytes) -> None:
        nonlocal longest
        longest = max(longest, check(reader, content, outcomes))

    run()
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    told = (
        f"{outcomes['read']} read, {outcomes['refused']} refused, longest {longest:.2f} s, peak {peak:.0f} MB"
    )
    print(f"{reader.name}: {told}", flush=True)


def follow_coverage(reader: Reader, examples: int) -> None:
    """Run atheris over one reader; it ends the process."""
    import atheris  # noqa: PLC0415 -- few have it

    def run(content: bytes) -> None:
        check(reader, content, Counter())

    own = [module for name, module in sys.modules.items() if name.startswith("starskel.")]
    for function in {value for module in own for value in vars(module).values() if isfunction(value)}:
        if function.__module__.startswith("starskel."):
            atheris.instrument_func(function)
    limits = [f"-runs={examples}", f"-timeout={SECONDS + 1:.0f}", f"-rss_limit_mb={BYTES >> 20}"]
    atheris.Setup([sys.argv[0], *limits], run)
    atheris.Fuzz()


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("readers", nargs="*", default=list(READERS), metavar="READER", help=", ".join(READERS))
parser.add_argument("--examples", type=int, default=10_000, help="inputs of each reader")
parser.add_argument("--seed", type=int, default=0)
parser.add_argument("--atheris", action="store_true", help="follow coverage in one reader")
arguments = parser.parse_args()
warnings.simplefilter("error")
faulthandler.enable()
LAST.parent.mkdir(exist_ok=True)
resource.setrlimit(resource.RLIMIT_DATA, (2 * BYTES, 2 * BYTES))
for name in arguments.readers:
    if arguments.atheris:
        follow_coverage(READERS[name], arguments.examples)
    else:
        fuzz(READERS[name], arguments.examples, arguments.seed)
