"""The bounds that each input is held to: read or refused within two seconds and half a gigabyte."""

import faulthandler
import hashlib
import resource
import time
import warnings
from collections import Counter
from pathlib import Path

from starskel import StarskelError
from tests.fuzzing.readers import ROOT, Reader
from tests.limited import held

SECONDS = 2.0
"""Of processor time, for one input."""

BYTES = 512 << 20
"""Of memory that the process may write to, the interpreter and all libraries included: asking for more fails,
so that no input can take more, however shortly."""

LAST = ROOT / "build" / "fuzzing"
"""Where the input lies that is being read: a crash leaves it there."""

KEPT = ROOT / "tests" / "files" / "broken"
"""Where inputs are put that were neither read nor refused: there they are tried by the tests from then on."""


class Bound(Exception):  # noqa: N818 -- it says what was overstepped
    """An input took more time than it may."""


class Bounded:
    """A reader held to the bounds, and what came of all its inputs."""

    def __init__(self, reader: Reader) -> None:
        warnings.simplefilter("error")
        faulthandler.enable()
        LAST.mkdir(parents=True, exist_ok=True)
        self._least = held()
        self._reader = reader
        self._outcomes: Counter[str] = Counter()
        self._longest = 0.0

    def read(self, content: bytes) -> None:
        """Read an input.

        Raises
        ------
        Exception
            Whatever it raises but errors of the library's own; MemoryError and Bound where it takes too much.
        """
        self.last.write_bytes(content)
        grown = held() - self._least  # by what is kept of the inputs before, and by the fuzzer itself
        resource.setrlimit(resource.RLIMIT_DATA, (BYTES + grown, resource.RLIM_INFINITY))
        start = time.process_time()
        try:
            self._reader.read(content)
            self._outcomes["read"] += 1
        except StarskelError:
            self._outcomes["refused"] += 1
        taken = time.process_time() - start
        self._longest = max(self._longest, taken)
        if taken > SECONDS:
            raise Bound(f"{taken:.1f} s for {len(content)} bytes")

    @property
    def last(self) -> Path:
        """Where the last input lies."""
        return LAST / f"input.{self._reader.name}"

    @property
    def count(self) -> int:
        """How many inputs there have been."""
        return self._outcomes.total()

    def keep(self) -> Path:
        """Put the last input among those that the tests try."""
        content = self.last.read_bytes()
        kept = KEPT / f"{hashlib.sha256(content).hexdigest()[:8]}.{self._reader.name}"
        kept.write_bytes(content)
        return kept

    def __str__(self) -> str:
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        outcomes = f"{self._outcomes['read']} read, {self._outcomes['refused']} refused"
        return f"{self._reader.name}: {outcomes}, longest {self._longest:.2f} s, peak {peak:.0f} MB"
