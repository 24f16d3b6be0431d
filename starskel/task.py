"""Long work that reports how far it is and stops when it is told to."""

from collections.abc import Callable
from dataclasses import dataclass

from starskel.errors import Cancelled, StarskelError

Progress = Callable[[float], None]
ShouldStop = Callable[[], bool]


@dataclass(frozen=True)
class Task:
    """A stretch of work: the part [start, end] of the whole that the caller watches.

    Parameters
    ----------
    progress : callable, optional
        Called with the fraction done, in [0, 1].
    should_stop : callable, optional
        Asked often; where it answers True the work ends with `Cancelled`.
    start, end : float
        The share of the whole that this stretch stands for.

    Raises
    ------
    StarskelError
        If what is to be called cannot be called.
    """

    progress: Progress | None = None
    should_stop: ShouldStop | None = None
    start: float = 0.0
    end: float = 1.0

    def __post_init__(self) -> None:
        for name, given in (("progress", self.progress), ("should_stop", self.should_stop)):
            if given is not None and not callable(given):
                raise StarskelError(f"{name} cannot be called", "give a function, or leave it out")

    def reach(self, fraction: float) -> None:
        """Report that this fraction of the stretch is done.

        Raises
        ------
        Cancelled
            If the caller wants to stop.
        """
        if self.should_stop is not None and self.should_stop():
            raise Cancelled
        if self.progress is not None:
            self.progress(self.start + fraction * (self.end - self.start))

    def part(self, start: float, end: float) -> "Task":
        """Give the stretch between two fractions of this one."""
        width = self.end - self.start
        return Task(self.progress, self.should_stop, self.start + start * width, self.start + end * width)

    @property
    def quiet(self) -> "Task":
        """The same work with nothing reported: inner work that can only be stopped."""
        return Task(None, self.should_stop)


UNWATCHED = Task()
"""Work that nobody watches and nobody stops."""
