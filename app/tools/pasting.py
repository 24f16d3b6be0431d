"""Put outlines that come from elsewhere in the place of a shape."""

from app.model.marks import Side
from app.model.selection import Selection, everything
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.select import SelectTool
from app.tools.tool import Commit, Response, Scene, refused_ring
from starskel.errors import InvalidPolygon
from starskel.polygon import Polygon
from starskel.predicates import Floats


def pasted(scene: Scene, side: Side, ring: Floats) -> Response:
    """Put a ring in the place of the shape on a canvas."""
    try:
        polygon = Polygon(ring)
    except InvalidPolygon as error:
        return Response(SelectTool(side), refusal=refused_ring(side, ring, error))
    document = scene.document.draw(side, polygon)
    commit = Commit(document, QT_TRANSLATE_NOOP("Step", "Paste shape"))
    return Response(SelectTool(side), commit, everything(document, side))


def cut(scene: Scene, side: Side) -> Response:
    """Take the shape off a canvas."""
    commit = Commit(scene.document.draw(side, None), QT_TRANSLATE_NOOP("Step", "Cut shape"))
    return Response(SelectTool(side), commit, Selection(side))
