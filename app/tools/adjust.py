"""An edit that was just made and still follows its settings, until the user goes on to something else."""

from collections.abc import Hashable
from dataclasses import dataclass, replace
from typing import ClassVar, Protocol

import numpy as np

from app.model.density import kept_vertices
from app.model.document import Document
from app.model.marks import Side
from app.model.point import Point
from app.model.strokes import closed
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.outcome import drawn
from app.tools.tool import Key, Overlay, Pointer, Response, Tool, ToolContext


class Edit(Hashable, Protocol):
    """What can be done again with other settings."""

    @property
    def side(self) -> Side: ...

    @property
    def options(self) -> str:
        """Which options it follows."""
        ...

    @property
    def trail(self) -> tuple[Point, ...]:
        """The line it was made from, to be shown beside it."""
        ...

    def on(self, context: ToolContext) -> Response:
        """Do it to a document."""
        ...


BACK = 10.0
"""Pixels from its start within which a line drawn by hand is back there."""


@dataclass(frozen=True)
class Sketch:
    """A shape drawn by hand.

    Attributes
    ----------
    side : {"source", "target"}
        The canvas.
    trail : tuple of points
        The line as it was drawn.
    pixel : float
        The size of a pixel when it was drawn, in document units.
    idle : Tool
        The tool that it was drawn with.
    """

    side: Side
    trail: tuple[Point, ...]
    pixel: float
    idle: Tool

    options: ClassVar[str] = "freehand"

    def on(self, context: ToolContext) -> Response:
        ring = closed(np.array(self.trail), BACK * self.pixel)
        ring = ring[kept_vertices(ring, context.settings.tolerance * self.pixel)]
        return drawn(context, self.side, ring, self.idle, QT_TRANSLATE_NOOP("Step", "Draw freehand"))


@dataclass(frozen=True)
class Adjustable(Tool):
    """An edit that was just made.

    Attributes
    ----------
    edit : Edit
        What was done.
    before, made : Document
        The document that it was done to, and what it gave.
    then : Tool
        What answers every event but changed settings.
    """

    edit: Edit
    before: Document
    made: Document
    then: Tool

    hint: ClassVar[str] = QT_TRANSLATE_NOOP("Hint", "Adjust the last step in the options above, or go on.")

    @property
    def name(self) -> str:  # type: ignore[override] # a constant of other states
        return self.then.name

    @property
    def options(self) -> str:  # type: ignore[override] # a constant of other states
        return self.edit.options

    def press(self, context: ToolContext, pointer: Pointer) -> Response:
        return self.then.press(context, pointer)

    def double_press(self, context: ToolContext, pointer: Pointer) -> Response:
        return self.then.double_press(context, pointer)

    def key(self, context: ToolContext, key: Key) -> Response:
        return self.then.key(context, key)

    def move(self, context: ToolContext, pointer: Pointer) -> Response:
        """Stay: the pointer is on its way to the options."""
        response = self.then.move(context, pointer)
        if context.document != self.made:
            return response
        return replace(response, tool=replace(self, then=response.tool))

    def adjust(self, context: ToolContext) -> Response:
        if context.document != self.made:
            return Response(self.then)
        return done(self.edit, replace(context, document=self.before), self)

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        overlay = self.then.overlay(context, side)
        if side != self.edit.side or context.document != self.made or not self.edit.trail:
            return overlay
        return replace(overlay, trail=np.array(self.edit.trail))


def done(edit: Edit, context: ToolContext, otherwise: Tool) -> Response:
    """Make an edit, to be adjusted afterwards; where it is refused the other state stays."""
    response = edit.on(context)
    if response.commit is None:
        return replace(response, tool=otherwise)
    commit = replace(response.commit, joins=edit)
    return replace(
        response, tool=Adjustable(edit, context.document, commit.document, response.tool), commit=commit
    )
