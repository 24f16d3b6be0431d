"""What menus do to a shape: each verb answers with a step of the history, or says why it cannot."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from app.model import reshaping
from app.model.document import Document
from app.model.marks import Side, other
from app.model.point import Point
from app.model.selection import Selection, at_places, everything
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.adjust import done
from app.tools.refusal import Refusal, refused_ring
from app.tools.select import SelectTool
from app.tools.tool import Commit, Response, Scene
from starskel.errors import StarskelError


@dataclass(frozen=True)
class Simplify:
    """Fewer vertices, as far as the tolerance goes.

    Attributes
    ----------
    selection : Selection
        Which of them may go.
    pixel : float
        The size of a pixel, in document units.
    """

    selection: Selection
    pixel: float

    options: ClassVar[str] = "simplify"
    trail: ClassVar[tuple[Point, ...]] = ()

    @property
    def side(self) -> Side:
        return self.selection.side

    def on(self, scene: Scene) -> Response:
        tolerance = scene.settings.tolerance * self.pixel
        name = QT_TRANSLATE_NOOP("Step", "Simplify")
        verb = partial(reshaping.simplify, scene.document, self.side, tolerance, self.selection.vertices)
        return _reshaped(scene, self.selection, verb, name)


@dataclass(frozen=True)
class Refine:
    """More vertices, evenly.

    Attributes
    ----------
    selection : Selection
        Between which of them they are added.
    """

    selection: Selection

    options: ClassVar[str] = "refine"
    trail: ClassVar[tuple[Point, ...]] = ()

    @property
    def side(self) -> Side:
        return self.selection.side

    def on(self, scene: Scene) -> Response:
        added, name = scene.settings.added, QT_TRANSLATE_NOOP("Step", "Refine")
        verb = partial(reshaping.refine, scene.document, self.side, added, self.selection.vertices)
        return _reshaped(scene, self.selection, verb, name)


def simplify(scene: Scene, pixel: float) -> Response:
    """Leave out vertices of the selection, or of the whole shape; how far can be adjusted afterwards."""
    selection = meant(scene)
    return done(Simplify(selection, pixel), scene, SelectTool(selection.side))


def refine(scene: Scene, pixel: float) -> Response:
    """Add vertices along the selection, or the whole shape; their number can be adjusted afterwards."""
    selection = meant(scene)
    return done(Refine(selection), scene, SelectTool(selection.side))


def mirror_across(scene: Scene, pixel: float) -> Response:
    """Exchange left and right."""
    return _mirrored(scene, (-1, 1))


def mirror_down(scene: Scene, pixel: float) -> Response:
    """Exchange above and below."""
    return _mirrored(scene, (1, -1))


def set_first(scene: Scene, pixel: float) -> Response:
    """Let the vertices count from the selected one on."""
    side, vertices = scene.selection.side, scene.selection.vertices
    if len(vertices) != 1:
        return Response(SelectTool(side))
    (vertex,) = vertices
    document = reshaping.set_first(scene.document, side, vertex)
    commit = Commit(document, QT_TRANSLATE_NOOP("Step", "Set first vertex"))
    return Response(SelectTool(side), commit, Selection(side, frozenset([0])))


def copy_across(scene: Scene, pixel: float) -> Response:
    """Copy the shape to the other canvas."""
    side = meant(scene).side
    document = reshaping.copy_across(scene.document, side)
    commit = Commit(document, QT_TRANSLATE_NOOP("Step", "Copy to other canvas"))
    return Response(SelectTool(other(side)), commit, everything(document, other(side)))


def exchange(scene: Scene, pixel: float) -> Response:
    """Exchange the shapes of the two canvases, with their marks: the blend runs the other way."""
    commit = Commit(scene.document.exchanged(), QT_TRANSLATE_NOOP("Step", "Reverse"))
    return Response(SelectTool(), commit, Selection())


def meant(scene: Scene) -> Selection:
    """Give the selection where it is at least two vertices, else the whole shape that was worked on last.

    Where that canvas is empty, the only other shape is meant.
    """
    if len(scene.selection.vertices) > 1:
        return scene.selection
    side = scene.selection.side
    return everything(scene.document, side if scene.document.polygon(side) is not None else other(side))


def _mirrored(scene: Scene, factors: tuple[int, int]) -> Response:
    selection = meant(scene)
    side, rows = selection.side, sorted(selection.vertices)
    if not rows:
        return Response(SelectTool(side))
    ring = reshaping.mirrored(scene.document, side, rows, factors)
    try:
        document = reshaping.turn_round(scene.document, side, ring)
    except StarskelError as error:
        return Response(SelectTool(side), refusal=refused_ring(side, ring, error))
    commit = Commit(document, QT_TRANSLATE_NOOP("Step", "Mirror"))
    return Response(SelectTool(side), commit, at_places(document, side, ring[rows]))


def _reshaped(scene: Scene, selection: Selection, verb: Callable[[], Document], name: str) -> Response:
    """Change how many vertices there are; what is left of those selected stays selected."""
    side, ring = selection.side, scene.document.vertices(selection.side)
    if not len(ring):
        return Response(SelectTool(side))
    try:
        document = verb()
    except StarskelError as error:
        return Response(SelectTool(side), refusal=Refusal(side, error))
    whole = len(selection.vertices) == len(ring)
    left = at_places(document, side, ring[sorted(selection.vertices)])
    return Response(SelectTool(side), Commit(document, name), everything(document, side) if whole else left)


VERBS: dict[str, Callable[[Scene, float], Response]] = {
    "copy-across": copy_across,
    "exchange": exchange,
    "mirror-across": mirror_across,
    "mirror-down": mirror_down,
    "simplify": simplify,
    "refine": refine,
    "set-first": set_first,
}
"""Each with the name of its command."""
