"""Hand: the tool in hand, what is selected, and what was said last. Events go in, what follows comes out."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from app.model.clipping import everything_of
from app.model.document import Document
from app.model.marks import SIDES, Side
from app.model.news import NONE, News
from app.model.selection import Selection, everything
from app.tools.draw import DrawTool
from app.tools.refusal import Refusal
from app.tools.select import SelectTool
from app.tools.settings import ToolSettings
from app.tools.tool import Commit, Key, Overlay, Pointer, Response, Tool, ToolContext
from app.tools.toolbox import TOOLS

Pointed = tuple[Side, int]
Taken = tuple["Hand", Commit | None]
"""The hand after an event, and the edit that came of it."""


@dataclass(frozen=True)
class Hand:
    """What the user has in hand.

    Attributes
    ----------
    tool : Tool
        The state of the tool.
    selection : Selection
        The selected vertices.
    settings : ToolSettings
        What the user has set for the tools.
    refusal : Refusal or None
        The last edit that was not possible, until the next one is tried.
    news : News
        What the last edit brought with it, until the next one is begun.
    """

    tool: Tool = field(default_factory=SelectTool)
    selection: Selection = field(default_factory=Selection)
    settings: ToolSettings = field(default_factory=ToolSettings)
    refusal: Refusal | None = None
    news: News = NONE

    @property
    def busy(self) -> bool:
        """Whether a gesture is under way."""
        return self.tool.busy

    @property
    def occupied(self) -> bool:
        """Whether there is a gesture to give up, or something said to put away."""
        return self.busy or self.refusal is not None or bool(self.news)

    def context(self, document: Document) -> ToolContext:
        """Give what the tool sees."""
        return ToolContext(document, self.selection, self.settings)

    def overlay(self, document: Document, side: Side) -> Overlay:
        """Give what the tool shows on a canvas."""
        return self.tool.overlay(self.context(document), side)

    def pointed(self, document: Document) -> Pointed | None:
        """Give the vertex that a press would take, None in a gesture."""
        for side in () if self.busy else SIDES:
            if (vertex := self.overlay(document, side).vertex) is not None:
                return side, vertex
        return None

    def preview(self, document: Document, pointer: Pointer) -> Document | None:
        """Give what ending the gesture here would lead to, None where it would change nothing."""
        return self.tool.preview(self.context(document), pointer) if self.busy else None

    def reach(self, document: Document, pointer: Pointer) -> int | None:
        """Give the part, other than the one worked on, that a press here would be about."""
        return None if self.busy else self.tool.reach(self.context(document), pointer)

    # pointer and keys

    def press(self, document: Document, pointer: Pointer) -> Taken:
        """Press; what is worked on is where the user is at work."""
        there = self.selection.side == pointer.side
        hand = self if there else replace(self, selection=Selection(pointer.side))
        return hand.after(self.tool.press(hand.context(document), pointer))

    def double_press(self, document: Document, pointer: Pointer) -> Taken:
        return self.after(self.tool.double_press(self.context(document), pointer))

    def move(self, document: Document, pointer: Pointer) -> Taken:
        """Move; a gesture shows at once what it may not do, and else the last refusal stays."""
        response = self.tool.move(self.context(document), pointer)
        return self.after(response if self.busy else replace(response, refusal=self.refusal))

    def release(self, document: Document, pointer: Pointer) -> Taken:
        response = self.tool.release(self.context(document), pointer)
        return self.after(replace(response, refusal=response.refusal or self.refusal))

    def key(self, document: Document, key: Key) -> Taken:
        return self.after(self.tool.key(self.context(document), key))

    # commands

    def take(self, name: str) -> "Hand":
        """Take up a tool."""
        return self.after(Response(TOOLS[name]))[0]

    def adjust(self, document: Document, settings: ToolSettings) -> Taken:
        """Change settings; what was just made follows them."""
        hand = replace(self, settings=settings)
        return hand.after(hand.tool.adjust(hand.context(document)))

    def do(self, document: Document, verb: Callable[[ToolContext], Response]) -> Taken:
        """Do what a verb answers."""
        return self.after(verb(self.context(document)))

    def finish(self, document: Document) -> Taken:
        """End the gesture so that what was drawn is kept; where that is not possible it goes on."""
        return self.after(self.tool.finish(self.context(document))) if self.busy else (self, None)

    def cancel(self) -> "Hand":
        """Give up the gesture, or what was said, or the selection."""
        if self.busy or self.refusal is not None:
            return self.after(Response(self.tool.cancel()))[0]
        if self.news:
            return replace(self, news=NONE)
        return replace(self, selection=Selection(self.selection.side))

    def select_all(self, document: Document, side: Side) -> "Hand":
        """Select the part worked on, and where that is selected already, all parts of its shape."""
        chosen, parts = everything(document, side), len(document.shape(side))
        if chosen == self.selection and parts > 1:
            chosen = everything_of(document, side, parts)
        return self.after(Response(SelectTool(), selection=chosen))[0]

    def select(self, selection: Selection) -> "Hand":
        """Select something else, with the tool in hand put down and taken up again."""
        return replace(self, tool=TOOLS[self.tool.name], selection=selection, refusal=None, news=NONE)

    def for_document(self, document: Document) -> "Hand":
        """Give the hand that begins on a document: it draws on empty canvases."""
        drawn = document.source is not None or document.target is not None
        return Hand(SelectTool() if drawn else DrawTool(), settings=self.settings)

    def after(self, response: Response) -> Taken:
        """Take in an answer."""
        selection = self.selection if response.selection is None else response.selection
        news = NONE if response.refusal is not None or response.tool.busy else self.news
        hand = replace(self, tool=response.tool, selection=selection, refusal=response.refusal, news=news)
        return hand, response.commit
