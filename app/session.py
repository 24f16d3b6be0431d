"""Session: the one object that owns what is edited, the tool in hand and the blends."""

from collections.abc import Callable, Hashable
from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot

from app.compute import (
    USUAL_METHODS,
    Blends,
    MarkWish,
    MatchedVertex,
    Morphs,
    Proposal,
    matched_vertex,
    subjects_of,
)
from app.model.document import Document
from app.model.filing import Filed, document_of
from app.model.history import History
from app.model.marks import Marks, Side
from app.model.news import NONE, News, news_of
from app.model.selection import Selection
from app.tools.hand import Hand, Pointed
from app.tools.refusal import Refusal
from app.tools.settings import ToolSettings
from app.tools.tool import Commit, Key, Overlay, Pointer, Response, Tool, ToolContext
from app.tools.verbs.marks import replace_marks
from starskel.files.projects.project import Project


class Session(QObject):
    """What one window edits. Canvases send events in; whatever shows something listens to the signals.

    Attributes
    ----------
    hand : Hand
        The tool in hand, what is selected, and what was said last.
    history : History
        What undo and redo go through.
    file : Filed or None
        The project file, None before it has one.
    blends : Blends
        What there is to show of the methods.
    morphs : Morphs
        What paints pictures inside the blends.
    pointed : (side, int) or None
        The vertex that is pointed at, on a canvas or in the table of marks.
    """

    changed = Signal()
    """The canvases look different."""
    document_changed = Signal()
    """The document, its file or its unsaved state is another."""
    opened = Signal()
    """Another document is edited from now on."""
    step_changed = Signal()
    """Other shapes are on the canvases."""
    tool_changed = Signal()
    pointed_changed = Signal()
    """Another vertex is pointed at, or its partner has moved."""
    settings_changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.history = History.of(Document(methods=USUAL_METHODS))
        self.blends = Blends(self)
        self.blends.suggested.connect(self._take_marks)
        self.blends.restarted.connect(self._give_up_wish)
        self.morphs = Morphs(self)
        self.hand = Hand()
        self.file: Filed | None = None
        self.pointed: Pointed | None = None
        self._wish: MarkWish | None = None

    @property
    def document(self) -> Document:
        """The document as it is now."""
        return self.history.document

    @property
    def tool(self) -> Tool:
        """The state of the tool in hand."""
        return self.hand.tool

    @property
    def selection(self) -> Selection:
        """The selected vertices."""
        return self.hand.selection

    @property
    def settings(self) -> ToolSettings:
        """What the user has set for the tools."""
        return self.hand.settings

    @property
    def refusal(self) -> Refusal | None:
        """The last edit that was not possible, until the next one is tried."""
        return self.hand.refusal

    @property
    def news(self) -> News:
        """How many marks the last edit of a shape took along, until the next one is begun."""
        return self.hand.news

    @property
    def path(self) -> Path | None:
        """Where the project file lies."""
        return None if self.file is None else self.file.path

    @property
    def unsaved(self) -> bool:
        """Whether the document differs from its file."""
        return self.history.unsaved

    @property
    def undoes(self) -> str | None:
        """The name of the edit that undo takes back."""
        return self.history.undoes

    @property
    def redoes(self) -> str | None:
        """The name of the edit that redo brings again."""
        return self.history.redoes

    @property
    def matched_vertex(self) -> MatchedVertex | None:
        """What is known of the vertex pointed at: its partner, and its row in all blends."""
        results = self.blends.fresh
        if self.pointed is None or not results:
            return None
        link = self.document.link
        return matched_vertex(results[0].pairs[link], *self.pointed) if link < len(results[0].pairs) else None

    def overlay(self, side: Side) -> Overlay:
        """Give what the tool shows on a canvas."""
        return self.hand.overlay(self.document, side)

    # events from the canvases

    def press(self, pointer: Pointer) -> None:
        """Press; first of all the part under the pointer is the one worked on."""
        if (part := self.hand.reach(self.document, pointer)) is not None:
            self.show_link(self.document.working_on(pointer.side, part).link)
        self._take(*self.hand.press(self.document, pointer))

    def double_press(self, pointer: Pointer) -> None:
        self._take(*self.hand.double_press(self.document, pointer))

    def release(self, pointer: Pointer) -> None:
        self._take(*self.hand.release(self.document, pointer))

    def move(self, pointer: Pointer) -> None:
        """Follow the pointer; in a gesture the blends show what releasing here would give."""
        self._take(*self.hand.move(self.document, pointer))
        if (document := self.hand.preview(self.document, pointer)) is not None:
            self._blend(document, live=True)

    def key(self, key: Key) -> None:
        self._take(*self.hand.key(self.document, key))

    # commands

    def choose_tool(self, name: str) -> None:
        """Take a tool in hand; the gesture under way is finished first, and goes on where it cannot be."""
        if self.tool.busy and self.tool.name == name:
            return
        if self.finish():
            self._take(self.hand.take(name))
        else:
            self.tool_changed.emit()  # the tool chosen is not the one in hand

    def set(self, settings: ToolSettings) -> None:
        """Change settings of the tools; what was just made follows them."""
        if settings == self.settings:
            return
        taken = self.hand.adjust(self.document, settings)
        self.hand = replace(self.hand, settings=settings)
        self.settings_changed.emit()
        self._take(*taken)
        self.changed.emit()

    def edit(self, verb: Callable[[ToolContext], Response]) -> None:
        """Do what a verb answers, after the gesture under way is finished."""
        if self.finish():
            self._take(*self.hand.do(self.document, verb))

    def store(self, document: Document, name: str, joins: Hashable = None) -> None:
        """Store what no gesture changes, as one step of the history; a gesture under way goes on."""
        self._commit(Commit(document, name, joins))

    def finish(self) -> bool:
        """End the gesture under way, so that what was drawn is kept; False where that is not possible."""
        self._take(*self.hand.finish(self.document))
        return not self.tool.busy

    def cancel(self) -> None:
        """Give up the nearest thing that can be given up: gesture, notice, computation, selection."""
        if self.blends.busy and not self.hand.occupied:
            self._give_up_wish()
            self.blends.cancel()
        else:
            self._take(self.hand.cancel())

    def select_all(self, side: Side) -> None:
        if self.finish():
            self._take(self.hand.select_all(self.document, side))

    def undo(self) -> None:
        """Take back the last edit, or the last vertex of a path that is being drawn."""
        if self.tool.busy:
            self.key(Key("backspace"))
        else:
            self._travel(self.history.undo())

    def redo(self) -> None:
        self._travel(self.history.redo())

    def go_to(self, position: int) -> None:
        """Go to any step of the history."""
        if self.finish() and position != self.history.position:
            self._travel(self.history.at(position))

    def point(self, side: Side, vertex: int | None) -> None:
        """Point at a vertex, or at none."""
        pointed = None if vertex is None else (side, vertex)
        if pointed != self.pointed:
            self.pointed = pointed
            self.pointed_changed.emit()

    def suggest_marks(self, count: int) -> None:
        """Replace all marks by so many that suggest themselves, as soon as they are found.

        Where the shapes change before that, the marks are those of the shapes as they are then.
        """
        if self.finish():
            self._wish = MarkWish(self.document.step, self.document.link, count)
            self._suggest()

    def show_step(self, step: int) -> None:
        """Put another step of the sequence on the canvases, after the gesture under way is finished."""
        if step != self.document.step and self.finish():
            self.history = self.history.showing(step)
            self._look(Selection(self.selection.side))

    def show_link(self, link: int) -> None:
        """Work on another link of the step: a part and its partner, or beyond the last on new ones."""
        if link != self.document.link and self.finish():
            self.history = self.history.showing(self.document.step, link)
            self.hand = self.hand.select(Selection(self.selection.side))
            self.point("source", None)
            self._refresh()

    def arrange(self, verb: Callable[[Document], Document], name: str, side: Side) -> None:
        """Change the sequence of key shapes; the shape on this side is the one worked on next."""
        if self.finish() and (document := verb(self.document)) != self.document:
            news = news_of(self.document, document)
            self.history = self.history.push(document, name)
            self._look(Selection(side), news)

    def choose(self, selection: Selection) -> None:
        """Select something; its side is the one worked on."""
        if selection != self.selection and self.finish():
            self._take(self.hand.select(selection))

    def _look(self, selection: Selection, news: News = NONE) -> None:
        """Show the step that the document is at now."""
        self.hand = replace(self.hand.select(selection), news=news)
        self.tool_changed.emit()
        self.point("source", None)
        self.step_changed.emit()
        self._refresh()

    def close(self) -> None:
        """End the worker; to be called before the program ends."""
        self.blends.close()
        self.morphs.close()

    # files

    def new(self) -> None:
        self._start(Document(methods=USUAL_METHODS))

    def show_project(self, project: Project, file: Filed | None = None, *, saved: bool = True) -> None:
        """Edit a project, which may have no file yet, or differ from its file where it is not saved.

        Raises
        ------
        InvalidMarks
            If its marks cross.
        """
        self._start(document_of(project, USUAL_METHODS), file, saved=saved)

    def note_saved(self, document: Document, file: Filed) -> None:
        """Note that a document, as it was a moment ago, is in a file."""
        self.file, self.history = file, self.history.saving(document)
        self.document_changed.emit()

    # how answers and documents come in

    @Slot(object, object)
    def _take_marks(self, proposal: Proposal, marks: Marks) -> None:
        """Take in suggested marks; those that come in a gesture are asked for again when it ends."""
        there = self.document.source, self.document.target
        if there == (proposal.source, proposal.target) and not self.tool.busy:
            self._give_up_wish()
            self.edit(partial(replace_marks, marks=marks))

    @Slot()
    def _give_up_wish(self) -> None:
        self._wish = None

    def _suggest(self) -> None:
        """Ask for the marks that are wished, while the part is worked on that they were wished for."""
        document, wish = self.document, self._wish
        source, target = document.source, document.target
        if wish is None or source is None or target is None:
            return
        if (document.step, document.link) == (wish.step, wish.link):
            self.blends.suggest(source, target, wish.count)
        else:
            self._give_up_wish()

    def _take(self, hand: Hand, commit: Commit | None = None) -> None:
        """Take in what came of an event."""
        former, self.hand = self.hand, hand
        if commit is not None:
            self._commit(commit)
        elif former.busy and not hand.busy:
            self._blend(self.document)  # the gesture was given up
        if type(former.tool) is not type(hand.tool):
            self.tool_changed.emit()
        if former.tool != hand.tool:
            self.point(*(hand.pointed(self.document) or ("source", None)))
        if self.hand != former:  # most moves of the pointer change nothing
            self.changed.emit()

    def _commit(self, commit: Commit) -> None:
        if commit.document == self.document:
            self._blend(self.document)  # the gesture ended where it began
            return
        self.hand = replace(self.hand, news=news_of(self.document, commit.document))
        self.history = self.history.push(commit.document, commit.name, commit.joins)
        self._refresh()

    def _travel(self, history: History) -> None:
        former, self.history = self.document, history
        now = self.document
        self.hand = self.hand.select(self.selection.after(former, now))
        self.tool_changed.emit()  # what was just made can no longer be adjusted
        if (former.step, len(former.sequence.steps)) != (now.step, len(now.sequence.steps)):
            self.step_changed.emit()
        self._refresh()

    def _start(self, document: Document, file: Filed | None = None, *, saved: bool = True) -> None:
        self.history = History.of(document)
        if not saved:
            self.history = replace(self.history, saved=Document())
        self.file = file
        self._give_up_wish()
        self.hand = self.hand.for_document(document)
        self.blends.forget()
        self.tool_changed.emit()
        self.opened.emit()
        self._refresh()

    def _refresh(self) -> None:
        self.document_changed.emit()
        self.changed.emit()
        self._blend(self.document)

    def _blend(self, document: Document, *, live: bool = False) -> None:
        self.blends.show(subjects_of(document.sequence), document.step, document.methods, live=live)
        if not live:
            self._suggest()
