"""Fuzz one reader by guessing: hypothesis breaks valid files and shortens what it finds.

python -m tests.fuzzing.guessing READER EXAMPLES SEED
"""

import sys

from hypothesis import HealthCheck, Phase, given, seed, settings

from tests.fuzzing.bounds import Bounded
from tests.fuzzing.mutations import broken
from tests.fuzzing.readers import READERS


def fuzz(name: str, examples: int, first: int) -> None:
    """Give a reader so many inputs, and tell what came of them."""
    bounded = Bounded(READERS[name])

    @seed(first)
    @settings(
        max_examples=examples,
        database=None,
        deadline=None,
        phases=(Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
    )
    @given(content=broken(READERS[name].seeds()))
    def run(content: bytes) -> None:
        bounded.read(content)

    try:
        run()
    except BaseException:
        print(f"kept as {bounded.keep()}", file=sys.stderr)  # the shortest was tried last
        raise
    print(bounded, flush=True)


fuzz(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
