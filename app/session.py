"""Session: the one object that owns what is edited, the tool in hand and the blends."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot

from app.compute import UNHURRIED, Blends, MethodState, Motion, Result, Trace, subjects_of, trace_of
from app.model.document import Document, lost_marks
from app.model.filing import document_of, project_of
from app.model.history import History
from app.model.marks import SIDES, Marks, Side
from app.model.selection import Selection, everything
from app.model.texts import QT_TRANSLATE_NOOP
from app.tools.draw import DrawTool
from app.tools.marking import replace_marks
from app.tools.select import SelectTool
from app.tools.settings import Settings
from app.tools.tool import Commit, Key, Overlay, Pointer, Refusal, Response, Scene, Tool
from app.tools.toolbox import TOOLS
from starskel.blending import COMPARED
from starskel.files.project import Project, read_project, write_project

Pointed = tuple[Side, int]

USUAL_METHODS = tuple(method for method in COMPARED if method not in UNHURRIED)
"""What is compared until the user chooses: every method that is quick."""


class Session(QObject):
    """What one window edits. Canvases send events in; whatever shows something listens to the signals.

    Attributes
    ----------
    selection : Selection
        The selected vertices.
    tool : Tool
        The state of the tool in hand.
    settings : Settings
        What the user has set for the tools.
    refusal : Refusal or None
        The last edit that was not possible, until the next one is tried.
    lost : int
        How many marks the last edit of a shape took along, until the next one is begun.
    path : Path or None
        The project file, None before it has one.
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
    results_changed = Signal()
    progressed = Signal(str, float)
    busy_changed = Signal(bool)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._history = History.of(Document(methods=USUAL_METHODS))
        self._saved = self.document
        self._blends = Blends(self)
        self._blends.changed.connect(self.results_changed)
        self._blends.suggested.connect(self._take_marks)
        self._blends.progressed.connect(self.progressed)
        self._blends.busy_changed.connect(self.busy_changed)
        self.selection = Selection()
        self.tool: Tool = SelectTool()
        self.settings = Settings()
        self.refusal: Refusal | None = None
        self.lost = 0
        self.path: Path | None = None
        self.pointed: Pointed | None = None
        self._motions: dict[int, Motion] = {}

    @property
    def document(self) -> Document:
        """The document as it is now."""
        return self._history.document

    @property
    def unsaved(self) -> bool:
        """Whether the document differs from its file."""
        return self.document.showing(0) != self._saved.showing(0)

    @property
    def busy(self) -> bool:
        """Whether the worker is computing."""
        return self._blends.busy

    @property
    def results(self) -> dict[str, MethodState]:
        """For each method of the document what there is to show of the step on the canvases."""
        return self._blends.results

    def results_of(self, step: int) -> dict[str, MethodState]:
        """Give for each method of the document what there is to show of any step."""
        steps = self._blends.steps
        return steps[step] if step < len(steps) else {}

    @property
    def fresh_results(self) -> tuple[Result, ...]:
        """The blends of the step on the canvases as it is now, in the order in which they are shown."""
        return self._blends.fresh

    @property
    def motion(self) -> Motion:
        """What the user has chosen about the star-skeleton of the step on the canvases."""
        return self._motions.get(self.document.step, Motion())

    @property
    def undoes(self) -> str | None:
        """The name of the edit that undo takes back."""
        return self._history.undoes

    @property
    def redoes(self) -> str | None:
        """The name of the edit that redo brings again."""
        return self._history.redoes

    @property
    def trace(self) -> Trace | None:
        """What is known of the vertex pointed at: its partner, and its row in all blends."""
        results = self.fresh_results
        if self.pointed is None or not results:
            return None
        return trace_of(results[0].blend.pair, *self.pointed)

    def overlay(self, side: Side) -> Overlay:
        """Give what the tool shows on a canvas."""
        return self.tool.overlay(self._scene(), side)

    # events from the canvases

    def press(self, pointer: Pointer) -> None:
        if self.selection.side != pointer.side:
            self.selection = Selection(pointer.side)  # what is worked on is where the user is at work
        self._answer(self.tool.press(self._scene(), pointer))

    def double_press(self, pointer: Pointer) -> None:
        self._answer(self.tool.double_press(self._scene(), pointer))

    def release(self, pointer: Pointer) -> None:
        response = self.tool.release(self._scene(), pointer)
        self._answer(replace(response, refusal=response.refusal or self.refusal))

    def move(self, pointer: Pointer) -> None:
        """Follow the pointer; a gesture shows at once what it may not do, and else the last refusal stays.

        The blends follow the gesture: they show what releasing here would give.
        """
        busy = self.tool.busy
        response = self.tool.move(self._scene(), pointer)
        self._answer(response if busy else replace(response, refusal=self.refusal))
        if self.tool.busy and (document := self.tool.preview(self._scene(), pointer)) is not None:
            self._blend(document, live=True)

    def key(self, key: Key) -> None:
        self._answer(self.tool.key(self._scene(), key))

    # commands

    def choose_tool(self, name: str) -> None:
        """Take a tool in hand; the gesture under way is finished first, and goes on where it cannot be."""
        if self.tool.busy and self.tool.name == name:
            return
        if self.finish():
            self._answer(Response(TOOLS[name]()))
        else:
            self.tool_changed.emit()  # the tool chosen is not the one in hand

    def set(self, settings: Settings) -> None:
        """Change settings of the tools; what was just made follows them."""
        if settings == self.settings:
            return
        self.settings = settings
        self.settings_changed.emit()
        self._answer(self.tool.adjust(self._scene()))
        self.changed.emit()

    def edit(self, verb: Callable[[Scene], Response]) -> None:
        """Do what a verb answers, after the gesture under way is finished."""
        if self.finish():
            self._answer(verb(self._scene()))

    def finish(self) -> bool:
        """End the gesture under way, so that what was drawn is kept; False where that is not possible."""
        if self.tool.busy:
            self._answer(self.tool.finish(self._scene()))
        return not self.tool.busy

    def cancel(self) -> None:
        """Give up the nearest thing that can be given up: gesture, notice, computation, selection."""
        if self.tool.busy or self.refusal is not None:
            self._answer(Response(self.tool.cancel()))
        elif self.lost:
            self.lost = 0
            self.changed.emit()
        elif self.busy:
            self._blends.cancel()
        else:
            self._answer(Response(self.tool, selection=Selection(self.selection.side)))

    def select_all(self, side: Side) -> None:
        if self.finish():
            self._answer(Response(SelectTool(), selection=everything(self.document, side)))

    def undo(self) -> None:
        """Take back the last edit, or the last vertex of a path that is being drawn."""
        if self.tool.busy:
            self.key(Key("backspace"))
        else:
            self._travel(self._history.undo())

    def redo(self) -> None:
        self._travel(self._history.redo())

    def point(self, side: Side, vertex: int | None) -> None:
        """Point at a vertex, or at none."""
        pointed = None if vertex is None else (side, vertex)
        if pointed != self.pointed:
            self.pointed = pointed
            self.pointed_changed.emit()

    def suggest_marks(self, count: int) -> None:
        """Replace all marks by so many that suggest themselves, as soon as they are found."""
        if self.finish():
            self._blends.suggest(count)

    def compare(self, methods: tuple[str, ...]) -> None:
        """Choose the methods shown side by side."""
        self._commit(Commit(self.document.compare(methods), QT_TRANSLATE_NOOP("Step", "Choose methods")))

    def steer(self, motion: Motion) -> None:
        """Choose the star-skeleton's root and whole turns."""
        self._motions[self.document.step] = motion
        self._blend(self.document)

    def show_step(self, step: int) -> None:
        """Put another step of the sequence on the canvases, after the gesture under way is finished."""
        if step != self.document.step and self.finish():
            self.lost = 0
            self._history = self._history.showing(step)
            self._look(Selection(self.selection.side))

    def arrange(self, verb: Callable[[], Document], name: str, side: Side) -> None:
        """Change the sequence of key shapes; the shape on this side is the one worked on next."""
        if self.finish() and (document := verb()) != self.document:
            self._motions = {}
            self.lost = lost_marks(self.document, document)
            self._history = self._history.push(document, name)
            self._look(Selection(side))

    def work_on(self, side: Side) -> None:
        """Let the shape on this side be the one worked on."""
        if self.finish():
            self._answer(Response(self.tool, selection=Selection(side)))

    def _look(self, selection: Selection) -> None:
        """Show the step that the document is at now."""
        self.tool, self.selection, self.refusal = TOOLS[self.tool.name](), selection, None
        self.point("source", None)
        self.step_changed.emit()
        self._refresh()

    def recompute(self) -> None:
        """Compute all blends anew."""
        self._blends.recompute()

    def close(self) -> None:
        """End the worker; to be called before the program ends."""
        self._blends.close()

    # files

    def new(self) -> None:
        self._start(Document(methods=USUAL_METHODS), None)

    def open(self, path: Path) -> None:
        """Open a project file.

        Raises
        ------
        StarskelError
            If it cannot be read; what was open stays open.
        """
        self.show_project(read_project(path), path)

    def show_project(self, project: Project, path: Path | None = None) -> None:
        """Edit a project, which may have no file yet.

        Raises
        ------
        InvalidMarks
            If its marks cross.
        """
        self._start(document_of(project, USUAL_METHODS), path)

    def save(self, path: Path) -> None:
        """Write the project file, whole or not at all.

        Raises
        ------
        InvalidFile
            If it cannot be written.
        """
        write_project(path, project_of(self.document, path.stem))
        self.path, self._saved = path, self.document
        self.document_changed.emit()

    # how answers and documents come in

    @Slot(object)
    def _take_marks(self, marks: Marks) -> None:
        self.edit(partial(replace_marks, marks=marks))

    def _scene(self) -> Scene:
        return Scene(self.document, self.selection, self.settings)

    def _answer(self, response: Response) -> None:
        former = self.tool, self.refusal, self.selection, self.lost
        self.tool, self.refusal = response.tool, response.refusal
        if self.refusal is not None or self.tool.busy:
            self.lost = 0
        if response.selection is not None:
            self.selection = response.selection
        if response.commit is not None:
            self._commit(response.commit)
        elif former[0].busy and not self.tool.busy:
            self._blend(self.document)  # the gesture was given up
        if type(former[0]) is not type(self.tool):
            self.tool_changed.emit()
        if self.tool != former[0]:
            self._point_by_tool()
        now = self.tool, self.refusal, self.selection, self.lost
        if now != former:  # most moves of the pointer change nothing
            self.changed.emit()

    def _point_by_tool(self) -> None:
        for side in () if self.tool.busy else SIDES:
            if (vertex := self.overlay(side).vertex) is not None:
                return self.point(side, vertex)
        return self.point("source", None)

    def _commit(self, commit: Commit) -> None:
        if commit.document == self.document:
            self._blend(self.document)  # the gesture ended where it began
            return
        self.lost = lost_marks(self.document, commit.document)
        self._history = self._history.push(commit.document, commit.name, commit.joins)
        self._refresh()

    def _travel(self, history: History) -> None:
        former = self.document
        self._history = history
        self.selection = self.selection.after(former, self.document)
        self.lost = 0
        self.tool = TOOLS[self.tool.name]()
        self.refusal = None
        now = self.document
        if (former.step, former.sequence.steps) != (now.step, now.sequence.steps):
            self.step_changed.emit()
        self._refresh()

    def _start(self, document: Document, path: Path | None) -> None:
        self._history = History.of(document)
        self._saved, self.path = document, path
        self.selection, self.refusal, self.lost = Selection(), None, 0
        self.tool = SelectTool() if document.source or document.target else DrawTool()
        self._motions = {}
        self._blends.forget()
        self.tool_changed.emit()
        self.opened.emit()
        self._refresh()

    def _refresh(self) -> None:
        self.document_changed.emit()
        self.changed.emit()
        self._blend(self.document)

    def _blend(self, document: Document, *, live: bool = False) -> None:
        self._blends.show(
            subjects_of(document.sequence, self._motions), document.step, document.methods, live=live
        )
