"""Draw regular figures by one drag: rectangle, ellipse, regular polygon, star."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import atan2, degrees, hypot
from typing import ClassVar

from app.model import figures
from app.model.marks import Side
from app.model.point import Point
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.outcome import drawn
from app.tools.pick import distance
from app.tools.settings import ToolSettings
from app.tools.snapping import begun_at, caught, targets_for_drawing
from app.tools.tool import Catch, Key, Overlay, Pointer, Response, Tool, ToolContext
from starskel.arrays import Floats


@dataclass(frozen=True)
class Figure:
    """A kind of figure.

    Attributes
    ----------
    name : str
        That of its tool.
    step : str
        What the history calls drawing one.
    hint : str
        How it is drawn, in one line.
    round : bool
        Whether a drag goes from the middle to a vertex, else from corner to corner.
    ring : callable
        Gives the figure that a drag from one place to another opens.
    """

    name: str
    step: str
    hint: str
    round: bool
    ring: Callable[[ToolSettings, Point, Point], Floats]


FIGURES = (
    Figure(
        "rectangle",
        QT_TRANSLATE_NOOP("Step", "Draw rectangle"),
        QT_TRANSLATE_NOOP(
            "Hint", "Drag from corner to corner. Shift makes a square; Ctrl suspends snapping."
        ),
        round=False,
        ring=lambda _, start, end: figures.rectangle(start, end),
    ),
    Figure(
        "ellipse",
        QT_TRANSLATE_NOOP("Step", "Draw ellipse"),
        QT_TRANSLATE_NOOP(
            "Hint", "Drag from corner to corner of its box. Shift makes a circle; Ctrl suspends snapping."
        ),
        round=False,
        ring=lambda settings, start, end: figures.ellipse(start, end, settings.roundness),
    ),
    Figure(
        "regular-polygon",
        QT_TRANSLATE_NOOP("Step", "Draw regular polygon"),
        QT_TRANSLATE_NOOP(
            "Hint", "Drag from the middle to a corner. Shift turns by steps of 15°; Ctrl suspends snapping."
        ),
        round=True,
        ring=lambda settings, start, end: figures.regular_polygon(start, end, settings.corners),
    ),
    Figure(
        "star",
        QT_TRANSLATE_NOOP("Step", "Draw star"),
        QT_TRANSLATE_NOOP(
            "Hint", "Drag from the middle to a point. Shift turns by steps of 15°; Ctrl suspends snapping."
        ),
        round=True,
        ring=lambda settings, start, end: figures.star(start, end, settings.points, settings.inner),
    ),
)


@dataclass(frozen=True)
class FigureTool(Tool):
    """Ready to drag a figure open."""

    figure: Figure
    side: Side = "source"
    catch: Catch | None = None

    @property
    def name(self) -> str:  # type: ignore[override] # a constant of tools of one kind
        return self.figure.name

    @property
    def hint(self) -> str:  # type: ignore[override] # as above
        return self.figure.hint

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        catch = begun_at(context, pointer)
        return Response(Stretching(self, pointer.side, catch.at, Catch(catch.at)))

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        return Response(replace(self, side=pointer.side, catch=begun_at(context, pointer)))

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        return Overlay(catch=self.catch) if side == self.side else Overlay()


@dataclass(frozen=True)
class Stretching(Tool):
    """A figure being dragged open."""

    idle: FigureTool
    side: Side
    start: Point
    catch: Catch
    opened: bool = False

    hint: ClassVar[str] = QT_TRANSLATE_NOOP("Hint", "Release to draw the figure; Esc gives it up.")
    busy: ClassVar[bool] = True

    @property
    def name(self) -> str:  # type: ignore[override] # as above
        return self.idle.name

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        if pointer.side != self.side:
            return Response(self)
        catch = self._caught(context, pointer)
        width, height = abs(catch.at[0] - self.start[0]), abs(catch.at[1] - self.start[1])
        extent = hypot(width, height) if self.idle.figure.round else min(width, height)
        return Response(replace(self, catch=catch, opened=extent > pointer.radius / 3))

    def release(self, context: ToolContext, pointer: Pointer) -> Response:
        if not self.opened:  # a shaky click is no figure
            return Response(self.idle)
        return drawn(context, self.side, self._ring(context), self.idle, self.idle.figure.step)

    def key(self, context: ToolContext, key: Key) -> Response:
        return Response(self.cancel() if key.name in ("backspace", "delete") else self)

    def cancel(self) -> Tool:
        return self.idle

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        if side != self.side or not self.opened:
            return Overlay()
        return Overlay(figure=self._ring(context), catch=self.catch, readout=(self.catch.at, self._readout()))

    def _ring(self, context: ToolContext) -> Floats:
        return self.idle.figure.ring(context.settings, self.start, self.catch.at)

    def _caught(self, context: ToolContext, pointer: Pointer) -> Catch:
        targets = targets_for_drawing(context.document, self.side)
        if self.idle.figure.round:
            return caught(pointer, context.settings.snapping, replace(targets, origins=(self.start,)))
        catch = caught(replace(pointer, shift=False), context.settings.snapping, targets)
        return Catch(_squared(self.start, catch.at)) if pointer.shift else catch

    def _readout(self) -> str:
        x, y = self.catch.at[0] - self.start[0], self.catch.at[1] - self.start[1]
        if self.idle.figure.round:
            return f"{distance(self.start, self.catch.at):.4g}   {degrees(atan2(y, x)):.0f}°"
        return f"{abs(x):.4g} × {abs(y):.4g}"


def _squared(start: Point, end: Point) -> Point:
    """Give the corner of the square that is as wide as the box, or as high, whichever is more."""
    x, y = end[0] - start[0], end[1] - start[1]
    side = max(abs(x), abs(y))
    return start[0] + (side if x >= 0 else -side), start[1] + (side if y >= 0 else -side)
