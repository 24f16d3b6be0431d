"""How far long work is, for those who watch a terminal."""

import sys
from types import TracebackType
from typing import TextIO

_WIDTH = 30


class Progress:
    """A bar on the last line of a terminal, by default that of standard error; nothing where there is none.

    Used as a context, so that the bar is gone before anything else is written.
    """

    def __init__(self, label: str, stream: TextIO | None = None) -> None:
        self._label = label
        self._stream = stream or sys.stderr
        self._shown = -1
        self._visible = self._stream.isatty()

    def __enter__(self) -> "Progress":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._shown >= 0:
            self._write("\r\x1b[K")

    def __call__(self, fraction: float) -> None:
        """Show this fraction as done."""
        percent = int(100 * fraction)
        if self._visible and percent != self._shown:
            self._shown = percent
            done = "#" * (_WIDTH * percent // 100)
            self._write(f"\r{done:.<{_WIDTH}} {percent:3} % {self._label}\x1b[K")

    def _write(self, text: str) -> None:
        self._stream.write(text)
        self._stream.flush()
