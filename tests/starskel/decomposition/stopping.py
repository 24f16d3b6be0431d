"""Work that is told to stop."""

from collections.abc import Callable

import pytest

from starskel.errors import Cancelled
from starskel.task import ShouldStop


def check_stops(work: Callable[[ShouldStop], object], calls: int) -> None:
    """Check that work which is told to stop after so many questions asks no more of them."""
    asked = 0

    def should_stop() -> bool:
        nonlocal asked
        asked += 1
        return asked > calls

    with pytest.raises(Cancelled):
        work(should_stop)
    assert asked == calls + 1
