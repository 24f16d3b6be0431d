"""What menus, keys and the list of parts do to the parts of shapes."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QColorDialog, QWidget

from app.model import parts
from app.model.document import Document
from app.model.selection import Selection
from app.model.texts import QT_TRANSLATE_NOOP
from app.session import Session
from app.tools.tool import Commit, Response, ToolContext
from app.view.asking import accepted
from app.view.commands.actions import Actions
from app.view.painting.theme import theme_of
from starskel import suggest_pairing


class Partnering(QObject):
    """The commands of the menu of parts."""

    wanted = Signal()
    """There is more than one part: their list is of use."""

    def __init__(self, parent: QWidget, session: Session) -> None:
        super().__init__(parent)
        self._window = parent
        self._session = session
        session.opened.connect(self._offer)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """Give for each command what it does; the one that shows the list belongs to the window."""
        return {
            "part-add": self._add,
            "part-remove": self._remove,
            "part-before": self._work_on_before,
            "part-after": self._work_on_after,
            "part-forward": self._bring_forward,
            "part-backward": self._send_backward,
            "part-shown": self._switch,
            "part-colour": self._choose_colour,
            "part-usual-colour": self._take_usual_colour,
            "part-apart": self._part_ways,
            "place": self._choose_place,
            "usual-place": self._take_usual_place,
            "suggest-pairing": self._suggest,
            "joined": self._join,
        }

    def show(self, actions: Actions) -> None:
        """Enable what is possible now."""
        document = self._document
        count, link = len(document.way.links), document.link
        there, whole = link < count, all(len(document.shape(side)) for side in ("source", "target"))
        for name, possible in (
            ("part-add", count > 0),
            ("part-remove", there),
            ("part-before", link > 0),
            ("part-after", link < count - 1),
            ("part-forward", link < count - 1),
            ("part-backward", there and link > 0),
            ("part-shown", there),
            ("part-colour", there),
            ("part-usual-colour", there and parts.colours(document, link) != ("", "")),
            ("part-apart", there and not document.pair.alone and count > 1),
            ("place", there and whole and document.pair.alone),
            ("usual-place", document.pair.place is not None),
            ("suggest-pairing", whole and count > 1),
            ("joined", count > 1),
        ):
            actions[name].setEnabled(possible)
        actions["part-shown"].setChecked(there and parts.shown(document, link))
        actions["joined"].setChecked(document.way.joined)

    @property
    def _document(self) -> Document:
        return self._session.document

    # what the list does

    def rename(self, link: int, name: str) -> None:
        """Give the part of a link, and its partner, a name."""
        self._do(
            lambda document: parts.style(document, link, name=name), QT_TRANSLATE_NOOP("Step", "Rename part")
        )

    def set_shown(self, link: int, *, shown: bool) -> None:
        """Show the part of a link or hide it."""
        name = QT_TRANSLATE_NOOP("Step", "Show part") if shown else QT_TRANSLATE_NOOP("Step", "Hide part")
        self._do(lambda document: parts.style(document, link, visible=shown), name)

    def pair(self, source: int, target: int, *, besides: bool = False) -> None:
        """Let a part become another one, or become it besides."""
        if besides:
            name = QT_TRANSLATE_NOOP("Step", "Split part")
            self._do(partial(parts.split, source=source, target=target), name)
        else:
            name = QT_TRANSLATE_NOOP("Step", "Pair parts")
            self._do(partial(parts.pair, source=source, target=target), name)

    def leave_alone(self, link: int) -> None:
        """Let both parts of a link go their own way."""
        self._do(
            lambda document: parts.part_ways(document.showing(document.step, link)),
            QT_TRANSLATE_NOOP("Step", "Leave without partner"),
        )

    def reorder(self, link: int, to: int) -> None:
        """Paint the part of a link as that of another number."""
        self._do(
            lambda document: parts.reorder(document.showing(document.step, link), to),
            QT_TRANSLATE_NOOP("Step", "Reorder parts"),
        )

    # what commands do

    @Slot()
    def _add(self) -> None:
        """Draw new parts, one on each canvas."""
        self._session.show_link(len(self._document.way.links))
        self._session.choose_tool("draw")
        self.wanted.emit()

    @Slot()
    def _remove(self) -> None:
        self._do(parts.remove, QT_TRANSLATE_NOOP("Step", "Remove part"))

    @Slot()
    def _work_on_before(self) -> None:
        self._session.show_link(self._document.link - 1)

    @Slot()
    def _work_on_after(self) -> None:
        self._session.show_link(self._document.link + 1)

    @Slot()
    def _bring_forward(self) -> None:
        self.reorder(self._document.link, self._document.link + 1)

    @Slot()
    def _send_backward(self) -> None:
        self.reorder(self._document.link, self._document.link - 1)

    @Slot()
    def _switch(self) -> None:
        self.set_shown(self._document.link, shown=not parts.shown(self._document, self._document.link))

    @Slot()
    def _choose_colour(self) -> None:
        given, _ = parts.colours(self._document, self._document.link)
        usual = theme_of(QPalette()).side(self._session.selection.side)
        dialog = QColorDialog(QColor(given or usual), self._window)
        dialog.setOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
        dialog.setWindowTitle(self.tr("Colour of the part"))
        if accepted(dialog):
            self._paint(dialog.currentColor().name())

    @Slot()
    def _take_usual_colour(self) -> None:
        self._paint("")

    def _paint(self, colour: str) -> None:
        link = self._document.link
        self._do(
            lambda document: parts.style(document, link, colour=colour),
            QT_TRANSLATE_NOOP("Step", "Colour part"),
        )

    @Slot()
    def _part_ways(self) -> None:
        self.leave_alone(self._document.link)

    @Slot()
    def _choose_place(self) -> None:
        self._session.choose_tool("place")

    @Slot()
    def _take_usual_place(self) -> None:
        self._do(partial(parts.place, at=None), QT_TRANSLATE_NOOP("Step", "Take the usual place of growth"))

    @Slot()
    def _suggest(self) -> None:
        source, target = self._document.shape("source"), self._document.shape("target")
        pairing = suggest_pairing(source.shape, target.shape)
        self._do(partial(parts.pair_anew, ends=pairing), QT_TRANSLATE_NOOP("Step", "Suggest pairing"))

    @Slot()
    def _join(self) -> None:
        document = self._document.steer(joined=not self._document.way.joined)
        name = (
            QT_TRANSLATE_NOOP("Step", "Move together")
            if document.way.joined
            else QT_TRANSLATE_NOOP("Step", "Move separately")
        )
        self._session.store(document, name)

    @Slot()
    def _offer(self) -> None:
        if any(len(shape) > 1 for shape in self._document.sequence.shapes):
            self.wanted.emit()

    def _do(self, verb: Callable[[Document], Document], name: str) -> None:
        """Store what a verb makes of the document; vertices that were selected may be of another part now."""

        def done(context: ToolContext) -> Response:
            document = verb(context.document)
            side = context.selection.side
            kept = document.polygon(side) == context.document.polygon(side)
            selection = context.selection if kept else Selection(side)
            return Response(self._session.tool, Commit(document, name), selection)

        self._session.edit(done)
