"""What callers give of pictures, checked."""

import numpy as np
from numpy.typing import ArrayLike

from starskel.arguments import finite
from starskel.errors import StarskelError
from starskel.limits import PICTURE_SIDE

View = tuple[float, float, float, float]
"""A box in the document: left, bottom, right, top."""

Size = tuple[int, int]


def checked_view(view: ArrayLike) -> View:
    """Give a view whose right lies right of its left, and its top above its bottom.

    Raises
    ------
    StarskelError
        If it does not, or is no view.
    """
    left, bottom, right, top = finite(view, 4, "the view").tolist()
    if not (left < right and bottom < top):
        raise StarskelError(
            f"the view {(left, bottom, right, top)} has no area", "give its left, bottom, right and top"
        )
    return left, bottom, right, top


def checked_size(size: Size | int, view: View) -> Size:
    """Give width and height; of a longer side alone the other one as the view asks for.

    Raises
    ------
    StarskelError
        If these are no whole numbers, or there would be too many pixels.
    """
    left, bottom, right, top = view
    sides = np.asarray(size) if np.ndim(size) < 2 else np.empty(0)
    if sides.dtype.kind not in "iu" or sides.shape not in ((), (2,)):
        raise StarskelError(f"the size is {size!r}", "give width and height in pixels, or the longer of both")
    if sides.shape == ():
        scale = int(sides) / max(right - left, top - bottom)
        sides = np.array([max(1, round(side * scale)) for side in (right - left, top - bottom)])
    width, height = int(sides[0]), int(sides[1])
    if not 1 <= min(width, height) <= max(width, height) <= PICTURE_SIDE:
        raise StarskelError(
            f"an image of {width} × {height} pixels", f"give from 1 to {PICTURE_SIDE} pixels a side"
        )
    return width, height


def checked_share(share: float) -> float:
    """Give how much of the target is seen.

    Raises
    ------
    StarskelError
        If it is no number from 0 to 1.
    """
    (number,) = finite([share], 1, "what the fade gives").tolist()
    if not 0 <= number <= 1:
        raise StarskelError(f"the fade gives {number:g}", "let it give numbers from 0 to 1")
    return float(number)
