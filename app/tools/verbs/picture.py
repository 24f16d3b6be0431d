"""What menus and numbers do to the picture behind a shape."""

from dataclasses import replace
from math import radians

from app.model import placing
from app.model.marks import Side
from app.model.point import Point
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.outcome import drawn_parts
from app.tools.picture import MOVE, SCALE, TURNING, PictureTool, put_picture
from app.tools.tool import Response, ToolContext
from starskel.files.projects.picture import Picture
from starskel.shapes.shape import Shape


def with_picture(context: ToolContext, side: Side, picture: Picture) -> Response:
    """Put a picture behind a shape, in hand to be placed."""
    return put_picture(context, side, picture, QT_TRANSLATE_NOOP("Step", "Place picture"))


def without_picture(context: ToolContext, side: Side) -> Response:
    """Take the picture away from behind a shape."""
    return put_picture(context, side, None, QT_TRANSLATE_NOOP("Step", "Remove picture"))


def fade_picture(context: ToolContext, side: Side, opacity: float) -> Response:
    """Show the picture more or less; changes in a row count as one step."""
    name = QT_TRANSLATE_NOOP("Step", "Picture opacity")
    return _changed(context, side, name, joined=True, opacity=opacity)


def lock_picture(context: ToolContext, side: Side, *, locked: bool) -> Response:
    """Let the picture stay where it is, or be moved again."""
    return _changed(context, side, QT_TRANSLATE_NOOP("Step", "Lock picture"), locked=locked)


def crop_picture(context: ToolContext, side: Side, *, cropped: bool) -> Response:
    """Show only what of the picture is inside the shape, or all of it."""
    return _changed(context, side, QT_TRANSLATE_NOOP("Step", "Crop picture"), cropped=cropped)


def centre_picture(context: ToolContext, side: Side, middle: Point) -> Response:
    """Move the picture so that its middle comes to a place."""
    return _changed(context, side, MOVE, joined=True, middle=middle)


def resize_picture(context: ToolContext, side: Side, size: Point) -> Response:
    """Give the picture another width and height, about its middle."""
    return _changed(context, side, SCALE, joined=True, size=size)


def turn_picture(context: ToolContext, side: Side, degrees: float) -> Response:
    """Turn the picture about its middle to an angle, counter-clockwise from upright."""
    picture = context.document.picture(side)
    if picture is None:
        return Response(PictureTool(side))
    turned = placing.turned(replace(picture, rotation=0.0), radians(degrees))
    return put_picture(context, side, turned, TURNING, joined=True)


def traced(context: ToolContext, side: Side, shape: Shape) -> Response:
    """Put an outline that was traced in the place of the shape, with all its parts and holes."""
    rings = [ring.vertices for ring in shape.rings]
    return drawn_parts(context, side, rings, PictureTool(side), QT_TRANSLATE_NOOP("Step", "Trace outline"))


def _changed(
    context: ToolContext, side: Side, name: str, *, joined: bool = False, **values: object
) -> Response:
    picture = context.document.picture(side)
    if picture is None:
        return Response(PictureTool(side))
    return put_picture(context, side, replace(picture, **values), name, joined=joined)  # type: ignore[arg-type] # each value is of its own field
