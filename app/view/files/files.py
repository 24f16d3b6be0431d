"""Files from the user's side: new, open, save, export, and no change lost on the way."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtWidgets import QMainWindow

from app.compute.errands import Work
from app.model.document import Document
from app.model.filing import Filed, stored
from app.session import Session
from app.view.asking import accepted
from app.view.files.dialogs import (
    PROJECT_ENDING,
    Answer,
    PairDialog,
    ask_about_changes,
    ask_about_overtaking,
    ask_for_another_place,
    complain,
    folder_with_room,
    path_to_open,
    path_to_save,
)
from app.view.files.file_reader import Take
from app.view.files.importing import Aim, Importing
from app.view.files.remembered import remember_file
from app.view.files.waiting import Waiting
from app.view.painting.display import Display
from app.view.timeline.player import Player
from app.view.wording import words
from starskel.errors import StarskelError
from starskel.files import multi_pairs, pairs
from starskel.files.documents import format_of
from starskel.files.file_name import file_name_of
from starskel.files.multi_pairs import MultiPair, read_multi_pairs
from starskel.files.pair_file import IMAGE_PAIRS, PairFile
from starskel.files.pairs import ShapePair, read_pairs
from starskel.files.projects.examples import example
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import read_project
from starskel.reading.readers import ENDINGS
from starskel.task import Task

if TYPE_CHECKING:  # loaded when it is wanted, so that the window opens sooner
    from app.view.files.export.exporting import Exporting
    from starskel.files.image_pairs import ImagePair

AnyFile: TypeAlias = "PairFile[ShapePair] | PairFile[MultiPair] | PairFile[ImagePair]"


def _read_image_pairs(path: Path) -> "PairFile[ImagePair]":
    read: Callable[[Path], PairFile[ImagePair]]
    read = import_module("starskel.files.image_pairs").read_image_pairs
    return read(path)


PAIRS: dict[str, Callable[[Path], AnyFile]] = {
    pairs.FORMAT: read_pairs,
    multi_pairs.FORMAT: read_multi_pairs,
    IMAGE_PAIRS: _read_image_pairs,
}
"""What reads a file of pairs, by its format."""


@dataclass(frozen=True)
class Stored:
    """A project and its file, as it was when it was read."""

    project: Project
    file: Filed


def _read_document(path: Path, task: Task) -> "Stored | AnyFile":
    """Read a project or a file of pairs."""
    if (read := PAIRS.get(format_of(path))) is not None:
        return read(path)
    file = Filed.now(path)
    return Stored(read_project(path, task), file)


def _read_pair(file: AnyFile, chosen: str, _: Task) -> Project:
    pair = file.pair(chosen)
    return Project.of(pair) if isinstance(pair, ShapePair | MultiPair) else pair.project


def _stored(document: Document, path: Path, known: Filed | None, _: Task) -> Filed | None:
    """Write a project file, unless another program has changed what was known of it."""
    return None if known is not None and known.overtaken else stored(document, path)


class Files(QObject):
    """The commands of the file menu."""

    exported = Signal(object)

    def __init__(
        self,
        window: QMainWindow,
        session: Session,
        player: Player,
        display: Display,
        importing: Importing,
    ) -> None:
        super().__init__(window)
        self._importing = importing
        importing.begun.connect(self._begin)
        self._window = window
        self._session = session
        self._player = player
        self._display = display
        self._exporting: Exporting | None = None
        self._left: Document | None = None  # what was open when a file was asked for, and may make way for it

    @property
    def name(self) -> str:
        """What the window's title calls the document."""
        if self._session.path is not None:
            return self._session.path.stem
        return self._session.document.name or self.tr("Untitled")

    def may_go(self) -> bool:
        """Ask about unsaved changes, a drawing begun among them; False where the user would rather stay."""
        finished = self._session.finish()
        if finished and not self._session.unsaved:
            return True
        answer = ask_about_changes(self._window, self.name)
        return self.save() if answer is Answer.SAVE else answer is Answer.DISCARD

    @Slot()
    def new(self) -> None:
        """Start with empty canvases, at t = 0."""
        if self.may_go():
            self._player.stop_at(0.0)
            self._session.new()

    @Slot()
    def choose(self) -> None:
        """Ask for a file and open it."""
        if self.may_go() and (path := path_to_open(self._window)) is not None:
            self.open(path)

    def open(self, path: Path) -> None:
        """Open a project, a pair of a file of pairs, or a drawing, once it is read.

        Until then, and where that fails or is given up, what is open stays.
        """
        self._left = self._session.document
        if path.suffix.lower() in ENDINGS:
            self._importing.read(Aim(path, anew=True))
        else:
            self._read(path, partial(_read_document, path), partial(self._take, path))

    @Slot(object)
    def open_example(self, name: str) -> None:
        if self.may_go():
            project = example(name)
            self._session.show_project(replace(project, name=words.example(project.name)))

    @Slot(object)
    def open_recent(self, path: Path) -> None:
        if self.may_go():
            self.open(path)

    @Slot()
    def save(self) -> bool:
        """Save to the project's file; True where that was done."""
        if self._session.path is None:
            return self.save_as()
        return self._save(self._session.path)

    @Slot()
    def save_as(self) -> bool:
        """Ask for a file and save; True where that was done."""
        return self._save_at_place(file_name_of(self.name))

    def _save_at_place(self, name: str, folder: Path | None = None) -> bool:
        path = path_to_save(self._window, self.tr("Save project"), name, [PROJECT_ENDING], folder)
        return path is not None and self._save(path)

    @Slot()
    def export(self) -> None:
        """Ask what to export and where, and write it."""
        if self._exporting is None:  # not loaded before, so that the window opens sooner
            made = import_module("app.view.files.export.exporting").Exporting
            self._exporting = made(self._window, self._session, self._player, self._display)
        if (path := self._exporting.export(file_name_of(self.name))) is not None:
            self.exported.emit(path)

    def _read(self, path: Path, work: Work, take: Take) -> None:
        self._importing.reader.read(path.name, work, take, partial(self._refuse, path))

    def _refuse(self, path: Path, error: StarskelError) -> None:
        complain(self._window, self.tr("{name} cannot be opened").format(name=path.name), error)

    def _take(self, path: Path, document: "Stored | AnyFile") -> None:
        """Edit a project; of a file of pairs, one, which is checked beside the window, too."""
        if isinstance(document, Stored):
            self._show(path, document.project, document.file)
        elif (chosen := self._chosen(document.ids)) is not None:
            self._read(path, partial(_read_pair, document, chosen), partial(self._begin, path=path))

    def _chosen(self, ids: tuple[str, ...]) -> str | None:
        if len(ids) == 1:
            return ids[0]
        dialog = PairDialog(ids, self._window)
        return dialog.chosen if accepted(dialog) else None

    @Slot(object, object)
    def _begin(self, project: Project, path: Path) -> None:
        """Edit what was read of a file that it is not saved to."""
        self._show(path, project)

    def _show(self, path: Path, project: Project, file: Filed | None = None) -> None:
        """Edit a project; what was done while it was read is lost only if that is wished."""
        left = self._session.document is self._left and not self._session.tool.busy
        if not (left or self.may_go()):
            return
        try:
            self._session.show_project(project, file)
        except StarskelError as error:
            self._refuse(path, error)
        else:
            remember_file(path)

    def _save(self, path: Path, *, overwrites: bool = False) -> bool:
        """Save beside the window; what another program has written meanwhile is overwritten only if asked."""
        file, document = self._session.file, self._session.document
        known = file if file is not None and path == file.path and not overwrites else None
        waiting = Waiting(self.tr("Saving {name}…").format(name=path.name), self._window, stoppable=False)
        try:
            written = waiting.awaited(partial(_stored, document, path, known))
        except StarskelError as error:
            elsewhere = ask_for_another_place(self._window, path, error)
            return elsewhere and self._save_at_place(path.stem, folder_with_room(path.parent))
        if written is None:
            answer = ask_about_overtaking(self._window, path)
            if answer is Answer.SAVE:
                return self._save(path, overwrites=True)
            return answer is Answer.ELSEWHERE and self.save_as()
        self._session.note_saved(document, written)
        remember_file(path)
        return True
