"""Put outlines that come from elsewhere in the place of a shape."""

from collections.abc import Mapping

from app.model import parts
from app.model.marks import Side
from app.model.selection import Selection, everything
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.select import SelectTool
from app.tools.tool import Commit, Response, Scene, refused_ring
from starskel.errors import InvalidPolygon
from starskel.polygon import Polygon
from starskel.predicates import Floats
from starskel.shapes.shape import Shape


def pasted(scene: Scene, side: Side, ring: Floats) -> Response:
    """Put a ring in the place of the shape on a canvas."""
    try:
        polygon = Polygon(ring)
    except InvalidPolygon as error:
        return Response(SelectTool(side), refusal=refused_ring(side, ring, error))
    document = scene.document.draw(side, polygon)
    commit = Commit(document, QT_TRANSLATE_NOOP("Step", "Paste shape"))
    return Response(SelectTool(side), commit, everything(document, side))


def put(scene: Scene, shapes: Mapping[Side, Shape], name: str) -> Response:
    """Put shapes, with all their parts and holes, in the places of those on their canvases, as one step."""
    document, sides = scene.document, list(shapes)
    try:
        for side, shape in shapes.items():
            document = parts.draw(document, side, [Polygon(ring.vertices) for ring in shape.rings])
    except InvalidPolygon as error:
        ring = shapes[sides[-1]].rings[0].vertices
        return Response(SelectTool(sides[-1]), refusal=refused_ring(sides[-1], ring, error))
    chosen = everything(document, sides[0]) if len(sides) == 1 else Selection(sides[0])
    return Response(SelectTool(sides[0]), Commit(document, name), chosen)


def cut(scene: Scene, side: Side) -> Response:
    """Take the shape off a canvas."""
    commit = Commit(scene.document.draw(side, None), QT_TRANSLATE_NOOP("Step", "Cut shape"))
    return Response(SelectTool(side), commit, Selection(side))
