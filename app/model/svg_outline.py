"""An outline as SVG, as it goes over the clipboard."""

from app.model.transforms import box_of
from starskel.files.numbers import decimal
from starskel.predicates import Floats


def outline_svg(ring: Floats) -> str:
    """Give a ring as SVG of the same size; y runs down there."""
    box = box_of(ring)
    (width, height), (left, top) = box.size, (box.low[0], -box.high[1])
    places = " L".join(f"{decimal(x)} {decimal(-y)}" for x, y in ring.tolist())
    view = " ".join(map(decimal, (left, top, width, height)))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{decimal(width)}" height="{decimal(height)}"'
        f' viewBox="{view}"><path d="M{places} Z"/></svg>'
    )
