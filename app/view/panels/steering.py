"""What steers the star-skeleton, beside its name: whole turns, and the way back to the usual roots."""

from PySide6.QtCore import QSignalBlocker, Slot
from PySide6.QtWidgets import QHBoxLayout, QSpinBox, QToolButton, QWidget

from app.model import parts
from app.model.texts import QT_TRANSLATE_NOOP
from app.session import Session

MOST = 9
"""Whole turns either way; more could not be followed by the eye."""

HEIGHT = 20


class Steering(QWidget):
    """Stands in the star-skeleton's panel, as no other method has anything to be steered by."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self.turns = QSpinBox()
        self.turns.setObjectName("turns")
        self.turns.setAccessibleName(self.tr("Whole turns"))
        self.turns.setToolTip(self.tr("Whole turns of the star-skeleton on its way, counter-clockwise"))
        self.turns.setPrefix(self.tr("turns") + " ")
        self.turns.setRange(-MOST, MOST)
        self.turns.setFrame(False)
        self.turns.setMaximumHeight(HEIGHT)
        self.root = QToolButton()
        self.root.setObjectName("usual-root")
        self.root.setText(self.tr("Usual root"))
        self.root.setToolTip(self.tr("Let the method choose the root again"))
        self.root.setMaximumHeight(HEIGHT)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        layout.addWidget(self.root)
        layout.addWidget(self.turns)
        self.turns.valueChanged.connect(self._turn)
        self.root.clicked.connect(self._forget)
        session.document_changed.connect(self._follow)
        self._follow()

    @Slot(int)
    def _turn(self, turns: int) -> None:
        document = self._session.document.steer(turns=turns)
        self._session.store(document, QT_TRANSLATE_NOOP("Step", "Set whole turns"), ("turns", document.step))

    @Slot()
    def _forget(self) -> None:
        document = parts.usual_roots(self._session.document)
        self._session.store(document, QT_TRANSLATE_NOOP("Step", "Take the usual root"))

    @Slot()
    def _follow(self) -> None:
        self.root.setVisible(bool(self._session.document.way.roots))
        with QSignalBlocker(self.turns):
            self.turns.setValue(self._session.document.way.turns)
