"""Put outlines that come from elsewhere in the place of a shape."""

from collections.abc import Mapping

from app.model import clipping as clippings
from app.model import parts
from app.model.clipping import Clipping
from app.model.marks import Side
from app.model.selection import Selection, everything
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.refusal import refused_ring
from app.tools.select import SelectTool
from app.tools.tool import Commit, Response, ToolContext
from starskel.errors import InvalidPolygon
from starskel.polygon import Polygon
from starskel.shapes.shape import Shape


def pasted(context: ToolContext, side: Side, clipping: Clipping) -> Response:
    """Put what was copied in the place of the shape on a canvas, or add its parts to those there."""
    try:
        document = clippings.pasted(context.document, side, clipping)
    except InvalidPolygon as error:
        ring = clipping.shape.rings[0].vertices
        return Response(SelectTool(side), refusal=refused_ring(side, ring, error))
    commit = Commit(document, QT_TRANSLATE_NOOP("Step", "Paste shape"))
    chosen = clippings.everything_of(document, side, len(clipping.shape))
    return Response(SelectTool(side), commit, chosen)


def put(context: ToolContext, shapes: Mapping[Side, Shape], name: str) -> Response:
    """Put shapes, with all their parts and holes, in the places of those on their canvases, as one step."""
    document, sides = context.document, list(shapes)
    try:
        for side, shape in shapes.items():
            document = parts.draw(document, side, [Polygon(ring.vertices) for ring in shape.rings])
    except InvalidPolygon as error:
        ring = shapes[sides[-1]].rings[0].vertices
        return Response(SelectTool(sides[-1]), refusal=refused_ring(sides[-1], ring, error))
    chosen = everything(document, sides[0]) if len(sides) == 1 else Selection(sides[0])
    return Response(SelectTool(sides[0]), Commit(document, name), chosen)


def cut(context: ToolContext, selection: Selection) -> Response:
    """Take what is selected off its canvas: parts with their holes, or the whole shape."""
    commit = Commit(clippings.cut(context.document, selection), QT_TRANSLATE_NOOP("Step", "Cut shape"))
    return Response(SelectTool(selection.side), commit, Selection(selection.side))
