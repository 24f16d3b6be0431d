"""What menus and keys do to the sequence of key shapes."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, Slot

from app.model import arranging
from app.model.marks import Side
from app.model.texts import QT_TRANSLATE_NOOP
from app.playback import Pace
from app.session import Session
from app.view.commands.actions import Actions
from app.view.timeline.player import Player


class Sequencing(QObject):
    """The commands of the sequence menu."""

    def __init__(self, parent: QObject, session: Session, player: Player) -> None:
        super().__init__(parent)
        self._session = session
        self._player = player
        session.document_changed.connect(self._follow)
        player.step_changed.connect(self._come_into)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """Give for each command what it does."""
        return {
            "shape-add": self._add,
            "shape-duplicate": self._duplicate,
            "shape-delete": self._delete,
            "shape-earlier": self._move_earlier,
            "shape-later": self._move_later,
            "step-before": self._show_before,
            "step-after": self._show_after,
            "alone": self._play_alone,
        }

    def show(self, actions: Actions) -> None:
        """Enable what is possible now."""
        document = self._session.document
        shape, steps = document.shape_on(self._session.selection.side), len(document.sequence.steps)
        for name, possible in (
            ("shape-delete", steps > 1),
            ("shape-earlier", shape > 0),
            ("shape-later", shape < steps),
            ("step-before", document.step > 0),
            ("step-after", document.step < steps - 1),
            ("alone", steps > 1),
            ("play", document.sequence.complete),
        ):
            actions[name].setEnabled(possible)
        actions["alone"].setChecked(self._player.alone)

    @property
    def _shape(self) -> int:
        """The shape last worked on."""
        return self._session.document.shape_on(self._session.selection.side)

    @Slot()
    def _follow(self) -> None:
        document = self._session.document
        steps = document.sequence.steps
        self._player.follow(tuple(Pace(step.duration, step.easing) for step in steps), document.step)
        if self._player.playing and not document.sequence.complete:
            self._player.stop_at(0.0)

    @Slot(int)
    def _come_into(self, step: int) -> None:
        """Show the step that playing has come into; a gesture under way keeps it where it is."""
        if self._session.tool.busy:
            self._follow()
        else:
            self._session.show_step(step)

    def add(self, after: int) -> None:
        """Put an empty shape behind another, and take the drawing tool in hand."""
        self._session.choose_tool("draw")
        added = partial(arranging.add_shape, after=after)
        self._session.arrange(added, QT_TRANSLATE_NOOP("Step", "Add key shape"), "target")

    def move(self, shape: int, to: int) -> None:
        """Move a shape to another number; it stays the one worked on."""
        moved = partial(arranging.move_shape, shape=shape, to=to)
        side: Side = "source" if moved(self._session.document).shape_on("source") == to else "target"
        self._session.arrange(moved, QT_TRANSLATE_NOOP("Step", "Move key shape"), side)

    def set_duration(self, duration: float) -> None:
        """Let the step on the canvases take so long."""
        document = self._session.document
        timed = arranging.set_duration(document, document.step, duration)
        name = QT_TRANSLATE_NOOP("Step", "Set duration")
        self._session.store(timed, name, ("duration", document.step))

    @Slot()
    def _add(self) -> None:
        self.add(self._session.document.shape_on("target"))

    @Slot()
    def _duplicate(self) -> None:
        copied = partial(arranging.duplicate_shape, shape=self._shape)
        self._session.arrange(copied, QT_TRANSLATE_NOOP("Step", "Duplicate key shape"), "target")

    @Slot()
    def _delete(self) -> None:
        rest = partial(arranging.delete_shape, shape=self._shape)
        self._session.arrange(rest, QT_TRANSLATE_NOOP("Step", "Delete key shape"), "source")

    @Slot()
    def _move_earlier(self) -> None:
        self.move(self._shape, self._shape - 1)

    @Slot()
    def _move_later(self) -> None:
        self.move(self._shape, self._shape + 1)

    @Slot()
    def _show_before(self) -> None:
        self._session.show_step(self._session.document.step - 1)

    @Slot()
    def _show_after(self) -> None:
        self._session.show_step(self._session.document.step + 1)

    @Slot()
    def _play_alone(self) -> None:
        self._player.set_alone(not self._player.alone)
