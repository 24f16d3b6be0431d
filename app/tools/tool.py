"""The protocol between a canvas and its tools: events in, the next state and its effects out."""

from collections.abc import Hashable
from dataclasses import dataclass, field
from typing import ClassVar

from app.model.document import Document
from app.model.marks import Side
from app.model.point import Point
from app.model.selection import Selection
from app.model.transforms import Box
from app.tools.refusal import Refusal, Segment
from app.tools.settings import ToolSettings
from starskel.arrays import Floats
from starskel.files.projects.picture import Picture

PICK = 9.0
"""Pixels within which a vertex or an edge counts as under the pointer."""


@dataclass(frozen=True)
class Pointer:
    """A place on one of the two canvases, in document units.

    Attributes
    ----------
    side : {"source", "target"}
        The canvas.
    at : (float, float)
        The place.
    radius : float
        How near counts as on it, in document units.
    shift : bool
        Whether the shift key is held: it constrains a gesture.
    free : bool
        Whether the control key is held: it suspends snapping.
    across : Pointer or None
        Where it is on the other canvas, if it was dragged there from this one.
    view : Box or None
        What is seen of the canvas, where that is known.
    """

    side: Side
    at: Point
    radius: float
    shift: bool = False
    free: bool = False
    across: "Pointer | None" = None
    view: Box | None = None

    @property
    def pixel(self) -> float:
        """The size of a pixel, in document units."""
        return self.radius / PICK


@dataclass(frozen=True)
class Key:
    """A key: "enter", "backspace", "delete", "left", "right", "up" or "down".

    `step` is how far an arrow key goes, in document units; `far` tells whether Shift makes it go further, and
    `alt` whether the Alt key is held, which makes arrow keys turn and scale.
    """

    name: str
    step: float = 1.0
    far: bool = False
    alt: bool = False


@dataclass(frozen=True)
class ToolContext:
    """What a tool sees."""

    document: Document
    selection: Selection
    settings: ToolSettings = field(default_factory=ToolSettings)


@dataclass(frozen=True)
class Catch:
    """Where the pointer is caught.

    Attributes
    ----------
    at : (float, float)
        The place.
    kind : str
        What by: "vertex", "aligned" (with a vertex), "edge", "angle", "grid", or "" where nothing did.
    guides : tuple of segments
        Lines that show why, from what catches to the place.
    """

    at: Point
    kind: str = ""
    guides: tuple[Segment, ...] = ()


@dataclass(frozen=True)
class Commit:
    """An edit to be stored as one step of the history."""

    document: Document
    name: str
    joins: Hashable = None


@dataclass(frozen=True, eq=False)
class Overlay:
    """What a tool shows on one canvas, above the document.

    Attributes
    ----------
    ring : (n, 2) array or None
        The shape as the gesture would leave it, shown instead of the stored one.
    path : tuple of points
        A path being drawn; the last point is where the pointer is.
    closes : bool
        Whether a click would close the path.
    box : two points, or None
        A rubber band.
    vertex : int or None
        The vertex that a press would take.
    insertion : (float, float) or None
        Where a double click would insert a vertex.
    pin : (int, int) or None
        A vertex and the number of the mark that would be set there.
    line : (float, float) or None
        Where the line ends that leads from the pin to the pointer, if the pointer is on this canvas.
    figure : (n, 2) array or None
        A shape that would replace the stored one.
    trail : (k, 2) array or None
        A line as the hand drew it.
    beside : tuple of (n, 2) arrays
        Outlines that belong to the figure but are left out of it.
    frame : Box or None
        A frame with handles around what is selected.
    picture : Picture or None
        The picture as the gesture would leave it, shown instead of the stored one.
    handles : bool
        Whether the picture has a frame with handles.
    handle : str
        The handle that a press would take.
    catch : Catch or None
        What the pointer is caught by.
    readout : (place, str) or None
        Figures to be shown at a place.
    """

    ring: Floats | None = None
    path: tuple[Point, ...] = ()
    closes: bool = False
    box: Segment | None = None
    vertex: int | None = None
    insertion: Point | None = None
    pin: tuple[int, int] | None = None
    line: Point | None = None
    figure: Floats | None = None
    trail: Floats | None = None
    beside: tuple[Floats, ...] = ()
    frame: Box | None = None
    picture: Picture | None = None
    handles: bool = False
    handle: str = ""
    catch: Catch | None = None
    readout: tuple[Point, str] | None = None


class Tool:
    """A state of a tool; by default it ignores every event."""

    name: ClassVar[str]
    """The tool that the state belongs to."""

    hint: ClassVar[str]
    """What the user can do now, in one line."""

    busy: ClassVar[bool] = False
    """Whether a gesture is under way that `cancel` would end."""

    options: ClassVar[str] = ""
    """Which options apply now, where they are not those of the tool."""

    def reach(self, context: ToolContext, pointer: Pointer) -> int | None:
        """Give the part, other than the one worked on, that a press here would be about."""
        return None

    def press(self, context: ToolContext, pointer: Pointer) -> "Response":
        return Response(self)

    def move(self, context: ToolContext, pointer: Pointer) -> "Response":
        return Response(self)

    def release(self, context: ToolContext, pointer: Pointer) -> "Response":
        return Response(self)

    def preview(self, context: ToolContext, pointer: Pointer) -> Document | None:
        """Give the document that releasing here would lead to, None where it would change nothing."""
        commit = self.release(context, pointer).commit
        return commit.document if commit is not None else None

    def double_press(self, context: ToolContext, pointer: Pointer) -> "Response":
        return self.press(context, pointer)

    def key(self, context: ToolContext, key: Key) -> "Response":
        return Response(self)

    def adjust(self, context: ToolContext) -> "Response":
        """Follow settings that were changed."""
        return Response(self)

    def cancel(self) -> "Tool":
        """Give the state after the gesture was given up."""
        return self

    def finish(self, context: ToolContext) -> "Response":
        """End the gesture because the user goes on to something else; by default it is given up."""
        return Response(self.cancel())

    def overlay(self, context: ToolContext, side: Side) -> Overlay:
        return Overlay()


@dataclass(frozen=True)
class Response:
    """The answer to an event: the next state, and what changes."""

    tool: Tool
    commit: Commit | None = None
    selection: Selection | None = None
    refusal: Refusal | None = None
