"""Picture: an image to draw over, as a project holds it."""

from dataclasses import dataclass
from typing import Annotated

import msgspec

Length = Annotated[float, msgspec.Meta(gt=0)]
Share = Annotated[float, msgspec.Meta(ge=0, le=1)]


@dataclass(frozen=True)
class Picture:
    """An image behind a shape.

    Attributes
    ----------
    content : bytes
        An image file, PNG or JPEG; as text, base64.
    middle : (float, float)
        Where its middle is, in document units.
    size : (float, float)
        Its width and height in document units.
    opacity : float
        From 0, not to be seen, to 1, hiding what is behind it.
    locked : bool
        Whether it stays where it is.
    """

    content: bytes
    middle: tuple[float, float]
    size: tuple[Length, Length]
    opacity: Share = 0.5
    locked: bool = False
