"""What comes of a finished gesture: a step of the history, or a refusal that points at the fault."""

from app.model.marks import Side, other
from app.model.selection import Selection, everything
from app.tools.select import SelectTool
from app.tools.tool import Commit, Response, Scene, Tool, refused_ring
from starskel.errors import InvalidPolygon
from starskel.polygon import Polygon
from starskel.predicates import Floats


def drawn(scene: Scene, side: Side, ring: Floats, tool: Tool, name: str) -> Response:
    """Put a newly drawn shape in the place of the one on its canvas.

    The tool stays in hand while the other canvas is empty; else the new shape is there to be selected, so
    that a stray press does not begin to replace one.
    """
    try:
        document = scene.document.draw(side, Polygon(ring))
    except InvalidPolygon as error:
        return Response(tool, refusal=refused_ring(side, ring, error))
    if scene.document.polygon(other(side)) is None:
        return Response(tool, Commit(document, name), Selection(side))
    return Response(SelectTool(side), Commit(document, name), everything(document, side))
