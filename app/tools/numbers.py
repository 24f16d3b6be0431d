"""Place, size and turn what is selected by numbers."""

from dataclasses import replace

from app.model import transforms
from app.model.point import Point
from app.model.texts import QT_TRANSLATE_NOOP
from app.model.transforms import Box, box_of
from app.tools.moving import placed
from app.tools.select import SelectTool
from app.tools.tool import Response, Scene
from starskel.arrays import Floats


def selected_box(scene: Scene) -> Box | None:
    """Give the box around what is selected, None where nothing is."""
    rows = sorted(scene.selection.vertices)
    return box_of(scene.document.vertices(scene.selection.side)[rows]) if rows else None


def centred(scene: Scene, middle: Point) -> Response:
    """Move the selection so that the middle of its box comes to a place."""
    points, box = _selected(scene)
    offset = middle[0] - box.middle[0], middle[1] - box.middle[1]
    return _put(scene, transforms.moved(points, offset), QT_TRANSLATE_NOOP("Step", "Move vertices"))


def sized(scene: Scene, size: Point) -> Response:
    """Scale the selection about its middle to a size; a side of length 0 stays."""
    points, box = _selected(scene)
    x, y = (new / old if old else 1.0 for new, old in zip(size, box.size, strict=True))
    return _put(scene, transforms.scaled(points, box.middle, (x, y)), QT_TRANSLATE_NOOP("Step", "Scale"))


def turned(scene: Scene, angle: float) -> Response:
    """Turn the selection about its middle, counter-clockwise, in radians."""
    points, box = _selected(scene)
    return _put(scene, transforms.turned(points, box.middle, angle), QT_TRANSLATE_NOOP("Step", "Turn"))


def _selected(scene: Scene) -> tuple[Floats, Box]:
    points = scene.document.vertices(scene.selection.side)[sorted(scene.selection.vertices)]
    return points, box_of(points)


def _put(scene: Scene, points: Floats, name: str) -> Response:
    selection = scene.selection
    ring = scene.document.vertices(selection.side).copy()
    ring[sorted(selection.vertices)] = points
    response = placed(scene, SelectTool(selection.side), selection, ring, name)
    if response.commit is None:
        return response
    return replace(response, commit=replace(response.commit, joins=("numbers", name, selection)))
