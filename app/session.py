"""Session: the one object that owns what is edited, the tool in hand and the blends."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot

from app.compute import Computer, Failure, Request, Result
from app.model.document import Document
from app.model.filing import document_of, project_of
from app.model.history import History
from app.model.marks import Side
from app.model.selection import Selection, everything
from app.model.texts import QT_TRANSLATE_NOOP
from app.results import Results, States
from app.tools.draw import DrawTool
from app.tools.mark import MarkTool
from app.tools.select import SelectTool
from app.tools.tool import Commit, Key, Overlay, Pointer, Refusal, Response, Scene, Tool
from starskel.blending import COMPARED
from starskel.files.project import Project, read_project, write_project

TOOLS: dict[str, type[Tool]] = {tool.name: tool for tool in (SelectTool, DrawTool, MarkTool)}

USUAL_METHODS = COMPARED
"""What is compared until the user chooses: every method."""


class Session(QObject):
    """What one window edits. Canvases send events in; whatever shows something listens to the signals.

    Attributes
    ----------
    selection : Selection
        The selected vertices.
    tool : Tool
        The state of the tool in hand.
    refusal : Refusal or None
        The last edit that was not possible, until the next one is tried.
    all_results : Results
        What there is to show of each step.
    path : Path or None
        The project file, None before it has one.
    """

    changed = Signal()
    """The canvases look different."""
    document_changed = Signal()
    """The document, its file or its unsaved state is another."""
    opened = Signal()
    """Another document is edited from now on."""
    tool_changed = Signal()
    results_changed = Signal()
    progressed = Signal(str, float)
    busy_changed = Signal(bool)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._history = History.of(Document(methods=USUAL_METHODS))
        self._saved = self.document
        self._computer = Computer(self)
        self._computer.delivered.connect(self._take)
        self._computer.progressed.connect(self.progressed)
        self._computer.busy_changed.connect(self.busy_changed)
        self.selection = Selection()
        self.tool: Tool = SelectTool()
        self.refusal: Refusal | None = None
        self.all_results = Results()
        self.path: Path | None = None

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
        return self._computer.busy

    @property
    def results(self) -> States:
        """For each method of the document what there is to show of the step on the canvases."""
        return self.results_of(self.document.step)

    def results_of(self, step: int) -> States:
        """Give for each method of the document what there is to show of a step."""
        return self.all_results.states[step] if self.all_results.states else {}

    @property
    def fresh_results(self) -> tuple[Result, ...]:
        """The blends of the step on the canvases as it is now, in the order in which they are shown."""
        states = self.results.values()
        return tuple(state.result for state in states if state.result is not None and not state.stale)

    @property
    def undoes(self) -> str | None:
        """The name of the edit that undo takes back."""
        return self._history.undoes

    @property
    def redoes(self) -> str | None:
        """The name of the edit that redo brings again."""
        return self._history.redoes

    def overlay(self, side: Side) -> Overlay:
        """Give what the tool shows on a canvas."""
        return self.tool.overlay(self._scene(), side)

    # events from the canvases

    def press(self, pointer: Pointer) -> None:
        self._answer(self.tool.press(self._scene(), pointer))

    def double_press(self, pointer: Pointer) -> None:
        self._answer(self.tool.double_press(self._scene(), pointer))

    def release(self, pointer: Pointer) -> None:
        response = self.tool.release(self._scene(), pointer)
        self._answer(replace(response, refusal=response.refusal or self.refusal))

    def move(self, pointer: Pointer) -> None:
        """Follow the pointer; a gesture shows at once what it may not do, and else the last refusal stays."""
        busy = self.tool.busy
        response = self.tool.move(self._scene(), pointer)
        self._answer(response if busy else replace(response, refusal=self.refusal))

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

    def finish(self) -> bool:
        """End the gesture under way, so that what was drawn is kept; False where that is not possible."""
        if self.tool.busy:
            self._answer(self.tool.finish(self._scene()))
        return not self.tool.busy

    def cancel(self) -> None:
        """Give up the nearest thing that can be given up: gesture, notice, computation, selection."""
        if self.tool.busy:
            self._answer(Response(self.tool.cancel()))
        elif self.refusal is not None:
            self._answer(Response(self.tool))
        elif self.busy:
            self._computer.cancel()
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

    def compare(self, methods: tuple[str, ...]) -> None:
        """Choose the methods shown side by side."""
        self._commit(Commit(self.document.compare(methods), QT_TRANSLATE_NOOP("Step", "Choose methods")))

    def recompute(self) -> None:
        """Compute all blends anew."""
        self.all_results = self.all_results.outdated()
        self._compute()

    def close(self) -> None:
        """End the worker; to be called before the program ends."""
        self._computer.close()

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

    def _scene(self) -> Scene:
        return Scene(self.document, self.selection)

    def _answer(self, response: Response) -> None:
        former = self.tool, self.refusal, self.selection
        self.tool, self.refusal = response.tool, response.refusal
        if response.selection is not None:
            self.selection = response.selection
        if response.commit is not None:
            self._commit(response.commit)
        if type(former[0]) is not type(self.tool):
            self.tool_changed.emit()
        if (self.tool, self.refusal, self.selection) != former:  # most moves of the pointer change nothing
            self.changed.emit()

    def _commit(self, commit: Commit) -> None:
        if commit.document == self.document:
            return
        self._history = self._history.push(commit.document, commit.name, commit.joins)
        self._refresh()

    def _travel(self, history: History) -> None:
        former = self.document
        self._history = history
        self.selection = self.selection.after(former, self.document)
        self.tool = TOOLS[self.tool.name]()
        self.refusal = None
        self._refresh()

    def _start(self, document: Document, path: Path | None) -> None:
        self._history = History.of(document)
        self._saved, self.path = document, path
        self.selection, self.refusal = Selection(), None
        self.tool = SelectTool() if document.source or document.target else DrawTool()
        self.all_results = Results()
        self.tool_changed.emit()
        self.opened.emit()
        self._refresh()

    def _refresh(self) -> None:
        self.document_changed.emit()
        self.changed.emit()
        self._compute()

    # blends

    def _compute(self) -> None:
        """Ask for what is missing or stale; results that still hold are kept."""
        self.all_results = self.all_results.following(self.document)
        wanted = self.all_results.wanted(self.document.step)
        if wanted:
            self._computer.request(*wanted)
        else:
            self._computer.cancel()
        self.results_changed.emit()

    @Slot(object, object)
    def _take(self, request: Request, outcome: Result | Failure) -> None:
        self.all_results = self.all_results.after(request, outcome)
        self.results_changed.emit()
