"""How far long work is, for those who watch a terminal."""

import sys
from types import TracebackType

_WIDTH = 30


class Progress:
    """A bar on the last line of the terminal; nothing at all where standard error is no terminal.

    Used as a context, so that the bar is gone before anything else is written.
    """

    def __init__(self, label: str) -> None:
        self._label = label
        self._shown = -1
        self._visible = sys.stderr.isatty()

    def __enter__(self) -> "Progress":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._shown >= 0:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)

    def __call__(self, fraction: float) -> None:
        """Show this fraction as done."""
        percent = int(100 * fraction)
        if self._visible and percent != self._shown:
            self._shown = percent
            done = "#" * (_WIDTH * percent // 100)
            print(
                f"\r{done:.<{_WIDTH}} {percent:3} % {self._label}\x1b[K", end="", file=sys.stderr, flush=True
            )
