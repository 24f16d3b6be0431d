"""A shape as SVG, as it goes over the clipboard."""

import numpy as np

from app.model.transforms import box_of
from starskel.arrays import Floats
from starskel.files.decimals import decimal
from starskel.shapes.shape import Shape


def outline_svg(shape: Shape) -> str:
    """Give a shape as SVG of the same size, one path; holes run the other way round. y runs down there."""
    box = box_of(np.concatenate([ring.vertices for ring in shape.rings]))
    (width, height), (left, top) = box.size, (box.low[0], -box.high[1])
    view = " ".join(map(decimal, (left, top, width, height)))
    rings = zip(shape.rings, shape.outer, strict=True)
    paths = [_path(ring.vertices if outer < 0 else ring.vertices[::-1]) for ring, outer in rings]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{decimal(width)}" height="{decimal(height)}"'
        f' viewBox="{view}"><path d="{" ".join(paths)}"/></svg>'
    )


def _path(ring: Floats) -> str:
    places = " L".join(f"{decimal(x)} {decimal(-y)}" for x, y in ring.tolist())
    return f"M{places} Z"
