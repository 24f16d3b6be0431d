"""What comes of a finished gesture: a step of the history, or a refusal that points at the fault."""

from collections.abc import Callable, Sequence

from app.model import parts
from app.model.document import Document
from app.model.marks import Side, other
from app.model.selection import Selection, everything
from app.tools.refusal import refused_ring
from app.tools.select import SelectTool
from app.tools.tool import Commit, Response, Tool, ToolContext
from starskel.arrays import Floats
from starskel.errors import InvalidPolygon
from starskel.polygon import Polygon


def drawn(context: ToolContext, side: Side, ring: Floats, tool: Tool, name: str) -> Response:
    """Put a newly drawn shape in the place of the one on its canvas.

    The tool stays in hand while the other canvas is empty; else the new shape is there to be selected, so
    that a stray press does not begin to replace one.
    """
    return _stored(context, side, ring, lambda: context.document.draw(side, Polygon(ring)), tool, name)


def drawn_parts(context: ToolContext, side: Side, rings: Sequence[Floats], tool: Tool, name: str) -> Response:
    """Put newly drawn rings in the place of the whole shape on a canvas, as `drawn` does with one."""

    def verb() -> Document:
        return parts.draw(context.document, side, [Polygon(ring) for ring in rings])

    return _stored(context, side, rings[0], verb, tool, name)


def _stored(  # noqa: PLR0913, PLR0917 -- as those above, and how
    context: ToolContext, side: Side, ring: Floats, verb: Callable[[], Document], tool: Tool, name: str
) -> Response:
    try:
        document = verb()
    except InvalidPolygon as error:
        return Response(tool, refusal=refused_ring(side, ring, error))
    if context.document.polygon(other(side)) is None:
        return Response(tool, Commit(document, name), Selection(side))
    return Response(SelectTool(side), Commit(document, name), everything(document, side))
