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
from app.tools.tool import Commit, Response, ToolContext
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

    def on(self, context: ToolContext) -> Response:
        tolerance = context.settings.tolerance * self.pixel
        name = QT_TRANSLATE_NOOP("Step", "Simplify")
        verb = partial(reshaping.simplify, context.document, self.side, tolerance, self.selection.vertices)
        return _reshaped(context, self.selection, verb, name)


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

    def on(self, context: ToolContext) -> Response:
        added, name = context.settings.added, QT_TRANSLATE_NOOP("Step", "Refine")
        verb = partial(reshaping.refine, context.document, self.side, added, self.selection.vertices)
        return _reshaped(context, self.selection, verb, name)


def simplify(context: ToolContext, pixel: float) -> Response:
    """Leave out vertices of the selection, or of the whole shape; how far can be adjusted afterwards."""
    selection = meant(context)
    return done(Simplify(selection, pixel), context, SelectTool(selection.side))


def refine(context: ToolContext, pixel: float) -> Response:
    """Add vertices along the selection, or the whole shape; their number can be adjusted afterwards."""
    selection = meant(context)
    return done(Refine(selection), context, SelectTool(selection.side))


def mirror_across(context: ToolContext, pixel: float) -> Response:
    """Exchange left and right."""
    return _mirrored(context, (-1, 1))


def mirror_down(context: ToolContext, pixel: float) -> Response:
    """Exchange above and below."""
    return _mirrored(context, (1, -1))


def set_first(context: ToolContext, pixel: float) -> Response:
    """Let the vertices count from the selected one on."""
    side, vertices = context.selection.side, context.selection.vertices
    if len(vertices) != 1:
        return Response(SelectTool(side))
    (vertex,) = vertices
    document = reshaping.set_first(context.document, side, vertex)
    commit = Commit(document, QT_TRANSLATE_NOOP("Step", "Set first vertex"))
    return Response(SelectTool(side), commit, Selection(side, frozenset([0])))


def copy_across(context: ToolContext, pixel: float) -> Response:
    """Copy the shape to the other canvas."""
    side = meant(context).side
    document = reshaping.copy_across(context.document, side)
    commit = Commit(document, QT_TRANSLATE_NOOP("Step", "Copy to other canvas"))
    return Response(SelectTool(other(side)), commit, everything(document, other(side)))


def exchange(context: ToolContext, pixel: float) -> Response:
    """Exchange the shapes of the two canvases, with their marks: the blend runs the other way."""
    commit = Commit(context.document.exchanged(), QT_TRANSLATE_NOOP("Step", "Reverse"))
    return Response(SelectTool(), commit, Selection())


def meant(context: ToolContext) -> Selection:
    """Give the selection where it is at least two vertices, else the whole shape that was worked on last.

    Where that canvas is empty, the only other shape is meant.
    """
    if len(context.selection.vertices) > 1:
        return context.selection
    side = context.selection.side
    return everything(context.document, side if context.document.polygon(side) is not None else other(side))


def _mirrored(context: ToolContext, factors: tuple[int, int]) -> Response:
    selection = meant(context)
    side, rows = selection.side, sorted(selection.vertices)
    if not rows:
        return Response(SelectTool(side))
    ring = reshaping.mirrored(context.document, side, rows, factors)
    try:
        document = reshaping.turn_round(context.document, side, ring)
    except StarskelError as error:
        return Response(SelectTool(side), refusal=refused_ring(side, ring, error))
    commit = Commit(document, QT_TRANSLATE_NOOP("Step", "Mirror"))
    return Response(SelectTool(side), commit, at_places(document, side, ring[rows]))


def _reshaped(
    context: ToolContext, selection: Selection, verb: Callable[[], Document], name: str
) -> Response:
    """Change how many vertices there are; what is left of those selected stays selected."""
    side, ring = selection.side, context.document.vertices(selection.side)
    if not len(ring):
        return Response(SelectTool(side))
    try:
        document = verb()
    except StarskelError as error:
        return Response(SelectTool(side), refusal=Refusal(side, error))
    whole = len(selection.vertices) == len(ring)
    left = at_places(document, side, ring[sorted(selection.vertices)])
    return Response(SelectTool(side), Commit(document, name), everything(document, side) if whole else left)


VERBS: dict[str, Callable[[ToolContext, float], Response]] = {
    "copy-across": copy_across,
    "exchange": exchange,
    "mirror-across": mirror_across,
    "mirror-down": mirror_down,
    "simplify": simplify,
    "refine": refine,
    "set-first": set_first,
}
"""Each with the name of its command."""
