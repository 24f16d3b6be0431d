"""The bar above the canvases: the strip of key shapes, its buttons, and how long the step shown takes."""

from PySide6.QtCore import QRectF, QSize, Qt, Slot
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QScrollArea,
    QToolButton,
    QWidget,
)

from app.model.sequence import SHORTEST_DURATION
from app.playback import Playback
from app.session import Session
from app.view.commands.actions import Actions
from app.view.sequence.key_strip import KeyStrip
from app.view.sequence.sequencing import Sequencing
from app.view.timeline.player import Player
from app.view.wording import words
from app.view.wording.decimal_field import DecimalField
from app.view.wording.plain import Label

LONGEST_DURATION = 600.0
"""Seconds that a step takes at most."""


class SequenceBar(QWidget):
    """The strip of key shapes with its buttons; hidden while there are but two shapes."""

    def __init__(self, session: Session, player: Player, sequencing: Sequencing, actions: Actions) -> None:
        super().__init__()
        self._session = session
        self._sequencing = sequencing
        self.strip = KeyStrip(session, player, sequencing, actions)
        self._scroll = QScrollArea()
        self._scroll.setWidget(self.strip)
        self._scroll.setWidgetResizable(True)
        self._scroll.setFrameShape(QFrame.Shape.NoFrame)
        self._scroll.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._scroll.setFixedHeight(self.strip.sizeHint().height() + 6)
        self.strip.shown.connect(self._reveal)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 2, 10, 0)
        layout.setSpacing(8)
        layout.addWidget(self._scroll, 1)
        layout.addLayout(self._buttons(actions))
        session.document_changed.connect(self._follow)
        self._follow()

    def _buttons(self, actions: Actions) -> QGridLayout:
        grid = QGridLayout()
        grid.setSpacing(4)
        for column, name in enumerate(("shape-duplicate", "shape-delete", "shape-earlier", "shape-later")):
            button = QToolButton()
            button.setDefaultAction(actions[name])
            button.setIconSize(QSize(18, 18))
            button.setAutoRaise(True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
            button.setAccessibleName(actions[name].text().replace("&", ""))
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            grid.addWidget(button, 0, column)
        self._letters = Label()
        grid.addWidget(self._letters, 1, 0, 1, 2)
        grid.addWidget(self._duration_field(), 1, 2, 1, 2)
        alone = QToolButton()
        alone.setDefaultAction(actions["alone"])
        alone.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        alone.setAccessibleName(actions["alone"].text().replace("&", ""))
        alone.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        grid.addWidget(alone, 2, 0, 1, 4)
        return grid

    def _duration_field(self) -> DecimalField:
        self.duration = DecimalField()
        self.duration.setObjectName("duration")
        self.duration.setAccessibleName(self.tr("Duration of the step"))
        self.duration.setToolTip(self.tr("How long the step on the canvases takes, at speed 1"))
        self.duration.setSuffix(self.tr(" s"))
        self.duration.setDecimals(2)
        self.duration.setRange(SHORTEST_DURATION * Playback.duration, LONGEST_DURATION)
        self.duration.setSingleStep(0.5)
        self.duration.setKeyboardTracking(False)
        self.duration.valueChanged.connect(self._set_duration)
        return self.duration

    @Slot(float)
    def _set_duration(self, seconds: float) -> None:
        self._sequencing.set_duration(max(seconds / Playback.duration, SHORTEST_DURATION))

    @Slot(QRectF)
    def _reveal(self, place: QRectF) -> None:
        centre = place.center().toPoint()
        self._scroll.ensureVisible(centre.x(), centre.y(), round(place.width() / 2) + 30, 0)

    @Slot()
    def _follow(self) -> None:
        document = self._session.document
        self.setVisible(len(document.sequence.steps) > 1)
        self._letters.setText(words.step_letters(document.step))
        self.duration.follow(document.way.duration * Playback.duration)
