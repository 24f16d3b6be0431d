"""A process of its own that gets little memory: what asks for more fails there, however shortly."""

import re
import resource
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path

_LOADED = (
    "starskel",
    "starskel.reading.svg",
    "starskel.reading.silhouette",
    "starskel.files.projects.project_file",
)


class Limited:
    """Calls functions there: results come back, and what is raised.

    Parameters
    ----------
    most : int
        Bytes that it gets besides what the interpreter and the library take before.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._pool = self._begun()

    def __call__(self, function: Callable[..., object], *arguments: object) -> object:
        """Call a function that can be imported there."""
        try:
            return self._pool.submit(function, *arguments).result()
        except BrokenProcessPool:
            self._pool = self._begun()  # the next has nothing to do with it
            raise

    def end(self) -> None:
        """End the process."""
        self._pool.shutdown()

    def _begun(self) -> ProcessPoolExecutor:
        return ProcessPoolExecutor(1, get_context("spawn"), initializer=_hold, initargs=(self._most,))


def _hold(most: int) -> None:
    for name in _LOADED:
        import_module(name)
    resource.setrlimit(resource.RLIMIT_DATA, (held() + most, held() + most))


def held() -> int:
    """Give how many bytes this process may write to."""
    found = re.search(r"VmData:\s+(\d+) kB", Path("/proc/self/status").read_text())
    assert found
    return 1024 * int(found[1])
