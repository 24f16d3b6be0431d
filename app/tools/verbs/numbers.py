"""Place, size and turn what is selected by numbers."""

from dataclasses import replace

from app.model import transforms
from app.model.point import Point
from app.model.texts import QT_TRANSLATE_NOOP
from app.model.transforms import Box, box_of
from app.tools.moving import placed
from app.tools.select import SelectTool
from app.tools.tool import Response, ToolContext
from starskel.arrays import Floats


def selected_box(context: ToolContext) -> Box | None:
    """Give the box around what is selected, None where nothing is."""
    rows = sorted(context.selection.vertices)
    return box_of(context.document.vertices(context.selection.side)[rows]) if rows else None


def centred(context: ToolContext, middle: Point) -> Response:
    """Move the selection so that the middle of its box comes to a place."""
    points, box = _selected(context)
    offset = middle[0] - box.middle[0], middle[1] - box.middle[1]
    return _put(context, transforms.moved(points, offset), QT_TRANSLATE_NOOP("Step", "Move vertices"))


def sized(context: ToolContext, size: Point) -> Response:
    """Scale the selection about its middle to a size; a side of length 0 stays."""
    points, box = _selected(context)
    x, y = (new / old if old else 1.0 for new, old in zip(size, box.size, strict=True))
    return _put(context, transforms.scaled(points, box.middle, (x, y)), QT_TRANSLATE_NOOP("Step", "Scale"))


def turned(context: ToolContext, angle: float) -> Response:
    """Turn the selection about its middle, counter-clockwise, in radians."""
    points, box = _selected(context)
    return _put(context, transforms.turned(points, box.middle, angle), QT_TRANSLATE_NOOP("Step", "Turn"))


def _selected(context: ToolContext) -> tuple[Floats, Box]:
    points = context.document.vertices(context.selection.side)[sorted(context.selection.vertices)]
    return points, box_of(points)


def _put(context: ToolContext, points: Floats, name: str) -> Response:
    selection = context.selection
    ring = context.document.vertices(selection.side).copy()
    ring[sorted(selection.vertices)] = points
    response = placed(context, SelectTool(selection.side), selection, ring, name)
    if response.commit is None:
        return response
    return replace(response, commit=replace(response.commit, joins=("numbers", name, selection)))
