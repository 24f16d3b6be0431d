"""How far long work is, for those who watch a terminal."""

import sys
from types import TracebackType
from typing import TextIO

_WIDTH = 30


class Progress:
    """A bar on the last line of a terminal, by default that of standard error; nothing where there is none.

    Used as a context, so that the bar is gone before anything else is written.

    Attributes
    ----------
    label : str
        What is being worked at.
    """

    def __init__(self, label: str, stream: TextIO | None = None) -> None:
        self.label = label
        self._stream = stream or sys.stderr
        self._shown: tuple[int, str] | None = None
        self._visible = self._stream.isatty()

    def __enter__(self) -> "Progress":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.clear()

    def clear(self) -> None:
        """Take the bar away, so that something else can be written; it comes back with the next fraction."""
        if self._shown is not None:
            self._write("\r\x1b[K")
            self._shown = None

    def __call__(self, fraction: float) -> None:
        """Show this fraction as done."""
        percent = int(100 * fraction)
        if self._visible and (percent, self.label) != self._shown:
            self._shown = percent, self.label
            done = "#" * (_WIDTH * percent // 100)
            self._write(f"\r{done:.<{_WIDTH}} {percent:3} % {self.label}\x1b[K")

    def _write(self, text: str) -> None:
        self._stream.write(text)
        self._stream.flush()
