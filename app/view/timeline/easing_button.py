"""A button that shows the easing and opens what changes it: presets, and the curve."""

from collections.abc import Hashable

from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QRectF, QSignalBlocker, QSize, Qt, Slot
from PySide6.QtGui import QIcon, QPainter
from PySide6.QtWidgets import QComboBox, QFrame, QPushButton, QToolButton, QVBoxLayout, QWidget

from app.model import arranging
from app.model.document import Document
from app.model.easing import PRESETS
from app.model.texts import QT_TRANSLATE_NOOP
from app.session import Session
from app.view.painting.drawing import layer_of, painting
from app.view.painting.theme import theme_of
from app.view.timeline.easing_curve import EasingCurve, paint_curve
from app.view.timeline.player import Player
from starskel.easing import Easing


class EasingPopup(QFrame):
    """The presets by name, and the curve below them, of the step on the canvases."""

    def __init__(self, session: Session, player: Player, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self._session = session
        self.setObjectName("easing-popup")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.presets = QComboBox()
        self.presets.setObjectName("easing")
        self.presets.setAccessibleName(self.tr("Easing"))
        for name, easing in PRESETS:
            self.presets.addItem(QCoreApplication.translate("Easing", name), easing)
        self.presets.addItem(self.tr("As drawn"), None)
        self.curve = EasingCurve(player)
        self.alike = QPushButton(self.tr("For all steps"))
        self.alike.setObjectName("easing-alike")
        self.alike.setToolTip(self.tr("Let t run over all steps as over this one"))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 4)
        layout.addWidget(self.presets)
        layout.addWidget(self.curve)
        layout.addWidget(self.alike)
        self.presets.currentIndexChanged.connect(self._choose)
        self.curve.edited.connect(self._take)
        self.alike.clicked.connect(self._spread)
        session.document_changed.connect(self._follow)
        self._follow()

    @Slot(int)
    def _choose(self, index: int) -> None:
        easing = self.presets.itemData(index)
        if easing is not None:
            self._store(self._session.document.steer(easing=easing))

    @Slot(object, int)
    def _take(self, easing: Easing, gesture: int) -> None:
        document = self._session.document
        self._store(document.steer(easing=easing), ("easing", document.step, gesture))

    @Slot()
    def _spread(self) -> None:
        self._store(arranging.ease_alike(self._session.document))

    def _store(self, document: Document, joins: Hashable = None) -> None:
        self._session.store(document, QT_TRANSLATE_NOOP("Step", "Set easing"), joins)

    @Slot()
    def _follow(self) -> None:
        """Show the preset that the easing is, if it is one."""
        document = self._session.document
        eases = [easing for _, easing in PRESETS]
        easing = document.way.easing
        with QSignalBlocker(self.presets):
            self.presets.setCurrentIndex(eases.index(easing) if easing in eases else len(eases))
        self.alike.setVisible(len(document.sequence.steps) > 1)
        self.alike.setEnabled(arranging.ease_alike(document) != document)
        self.curve.update()


class EasingButton(QToolButton):
    """Shows the curve in small."""

    def __init__(self, session: Session, player: Player) -> None:
        super().__init__()
        self._player = player
        self._drawn: Easing | None = None
        self.popup = EasingPopup(session, player, self)
        self.setObjectName("easing-button")
        self.setAccessibleName(self.tr("Easing"))
        self.setToolTip(self.tr("Easing: how t runs over the time"))
        self.setAutoRaise(True)
        self.setIconSize(QSize(18, 18))
        self.clicked.connect(self._open)
        player.t_changed.connect(self._follow)
        self._follow()

    @Slot()
    def _open(self) -> None:
        """Open above the button, since it stands near the window's lower edge."""
        self.popup.adjustSize()
        self.popup.move(self.mapToGlobal(QPoint(0, -self.popup.height() - 4)))
        self.popup.show()
        self.popup.curve.setFocus()

    @Slot()
    def _follow(self) -> None:
        if self._drawn != self._player.easing:
            self._draw()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._draw()

    def _draw(self) -> None:
        self._drawn = self._player.easing
        layer = layer_of(self.iconSize(), 2.0)
        with painting(layer) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            paint_curve(painter, theme_of(self.palette()), QRectF(2, 2, 14, 14), self._drawn, 1.8)
        self.setIcon(QIcon(layer))
