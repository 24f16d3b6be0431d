"""What a worker leaves in its thread is freed before a slot ends."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def freeing_factors() -> Iterator[None]:
    """Free the factors that were made in here.

    To Python each call of a slot in a QThread is a thread of its own; what that keeps would be lost.
    """
    try:
        yield
    finally:
        # not imported here: the window opens without it; while it is still loaded nothing was factored
        module = sys.modules.get("starskel.blending.laplacian")
        if (forget := getattr(module, "forget_factors", None)) is not None:
            forget()
