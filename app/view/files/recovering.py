"""Unsaved work is kept while the window is open, and offered again when that ended unexpectedly."""

from PySide6.QtCore import QObject, Slot
from PySide6.QtWidgets import QMainWindow

from app.recovery.keeper import Keeper
from app.recovery.places import Kept, any_records, kept_records
from app.recovery.record import Record
from app.session import Session
from app.view.asking import asked
from app.view.files.dialogs import complain
from app.view.files.files import Files
from app.view.files.recovery_dialog import RecoveryDialog
from app.view.files.waiting import Waiting
from app.view.wording import words
from starskel.errors import StarskelError

NOTICE = 12_000
"""Milliseconds that something is said."""


class Recovering(QObject):
    """Keeps the document of a window, and offers what others have left."""

    def __init__(self, window: QMainWindow, session: Session, files: Files) -> None:
        super().__init__(window)
        self._window = window
        self._session = session
        self._files = files
        self.keeper = Keeper(session, self)
        self.keeper.failed.connect(self._tell)

    @Slot()
    def offer(self) -> None:
        """Offer what there is; say so where there is nothing."""
        if not self.offer_kept():
            self._say(self.tr("There are no recovered documents."))

    def offer_kept(self) -> bool:
        """Offer the documents that were left behind; False where there are none."""
        kept = self._found()
        if not kept:
            return False
        dialog = RecoveryDialog(kept, self._window)
        asked(dialog)
        chosen = dialog.chosen
        if chosen is not None and not (self._files.may_go() and self._open(chosen)):
            chosen = None
        for each in kept:
            if each is not chosen:
                each.place.release()
        return True

    def _found(self) -> tuple[Kept, ...]:
        """Read the records there are, beside the window."""
        if not any_records():
            return ()
        waiting = Waiting(self.tr("Looking for unsaved documents…"), self._window, stoppable=False)
        found: tuple[Kept, ...] = waiting.awaited(lambda _: kept_records())
        return found

    def close(self) -> None:
        """End keeping; to be called when the document is saved or given up."""
        self.keeper.close()

    def _open(self, kept: Kept) -> bool:
        """Edit a record as the unsaved document that it was."""
        record = kept.record
        assert isinstance(record, Record)
        try:
            self._session.show_project(record.project, record.file, saved=False)
        except StarskelError as error:
            name = kept.place.path.name
            complain(self._window, self.tr("{name} cannot be opened").format(name=name), error)
            return False
        self.keeper.adopt(kept.place)
        return True

    @Slot(object)
    def _tell(self, error: StarskelError | None) -> None:
        if error is None:
            self._say(self.tr("Unsaved changes are kept safe again."))
        else:
            why = words.sentences(error, " ")
            self._say(self.tr("Unsaved changes are not kept safe, so save often: {why}").format(why=why))

    def _say(self, text: str) -> None:
        self._window.statusBar().showMessage(text, NOTICE)
