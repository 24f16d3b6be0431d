"""Picture: an image to draw over, as a project holds it."""

from dataclasses import dataclass
from typing import Annotated

import msgspec

from starskel.arrays import Floats
from starskel.images.placed import box_placement

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
        Its width and height in document units, before it is turned.
    opacity : float
        From 0, not to be seen, to 1, hiding what is behind it.
    locked : bool
        Whether it stays where it is.
    rotation : float
        How far it is turned about its middle, in radians, counter-clockwise.
    cropped : bool
        Whether only what is inside the shape is shown behind it; blends never carry more.
    """

    content: bytes
    middle: tuple[float, float]
    size: tuple[Length, Length]
    opacity: Share = 0.5
    locked: bool = False
    rotation: float = 0.0
    cropped: bool = False

    @property
    def placement(self) -> Floats:
        """The affine map, (2, 3), from shares of its width to the right and of its height down."""
        return box_placement(self.middle, self.size, self.rotation)
