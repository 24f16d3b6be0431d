"""Timeline: the clock's controls, and below them the chart over the same stretch of t."""

from PySide6.QtCore import QPointF, QSize, Qt, Slot
from PySide6.QtGui import QAction, QColor, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import (
    QComboBox,
    QGridLayout,
    QHBoxLayout,
    QToolButton,
    QWidget,
)

from app.playback import Repeat
from app.session import Session
from app.view.commands.actions import Actions
from app.view.painting.drawing import painting
from app.view.painting.theme import theme_of
from app.view.timeline.chart_layout import ChartLayout
from app.view.timeline.easing_button import EasingButton
from app.view.timeline.player import Player
from app.view.timeline.strip_chart import StripChart, method_pen
from app.view.timeline.time_slider import TimeSlider
from app.view.wording import words
from app.view.wording.decimal_field import DecimalField
from starskel.blending import METHODS

ROOMY = 900
"""Pixels of width from which buttons say in words what they do."""

SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0)


class Timeline(QWidget):
    """Start, play, repeat, speed, slider and t; legend and chart."""

    def __init__(self, session: Session, player: Player, actions: Actions) -> None:
        super().__init__()
        self._session, self._player = session, player
        self.slider = TimeSlider(session.blends, player)
        self.chart = StripChart(session, player)
        self.chart.inset = self.slider.inset
        self._t = self._t_field()
        layout = QGridLayout(self)
        layout.setContentsMargins(10, 6, 10, 4)
        layout.setHorizontalSpacing(10)
        layout.setVerticalSpacing(2)
        layout.addLayout(self._controls(actions), 0, 0)
        layout.addWidget(self.slider, 0, 1)
        layout.addWidget(self._t, 0, 2)
        layout.addWidget(Legend(session), 1, 0)
        layout.addWidget(self.chart, 1, 1, 1, 1)
        self.add = _button(actions["shape-add"])
        layout.addWidget(self.add, 1, 2, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop)
        layout.setColumnStretch(1, 1)
        player.t_changed.connect(self._follow)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Leave out what the button says where the slider needs the room."""
        icon, text = Qt.ToolButtonStyle.ToolButtonIconOnly, Qt.ToolButtonStyle.ToolButtonTextBesideIcon
        self.add.setToolButtonStyle(text if event.size().width() >= ROOMY else icon)

    def _controls(self, actions: Actions) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(4)
        for name in ("to-start", "step-back", "play", "step-forward"):
            row.addWidget(_button(actions[name]))
        row.addSpacing(6)
        row.addWidget(self._repeat_field())
        row.addWidget(self._speed_field())
        self.easing = EasingButton(self._session, self._player)
        row.addWidget(self.easing)
        return row

    def _repeat_field(self) -> QComboBox:
        self._repeat = QComboBox()
        self._repeat.setObjectName("repeat")
        self._repeat.setAccessibleName(self.tr("At the end"))
        self._repeat.setToolTip(self.tr("What happens when the end is reached"))
        for text, repeat in (
            (self.tr("Back and forth"), Repeat.PING_PONG),
            (self.tr("Loop"), Repeat.LOOP),
            (self.tr("Once"), Repeat.ONCE),
        ):
            self._repeat.addItem(text, repeat)
        self._repeat.currentIndexChanged.connect(self._choose_repeat)
        return self._repeat

    def _speed_field(self) -> QComboBox:
        self._speed = QComboBox()
        self._speed.setObjectName("speed")
        self._speed.setAccessibleName(self.tr("Speed"))
        self._speed.setToolTip(self.tr("Speed of playing"))
        for speed in SPEEDS:
            self._speed.addItem(f"{speed:g}\N{MULTIPLICATION SIGN}", speed)
        self._speed.setCurrentIndex(SPEEDS.index(1.0))
        self._speed.currentIndexChanged.connect(self._choose_speed)
        return self._speed

    def _t_field(self) -> DecimalField:
        field = DecimalField()
        field.setObjectName("t")
        field.setAccessibleName(self.tr("Time t"))
        field.setToolTip(self.tr("The moment shown, from 0 (source) to 1 (target)"))
        field.setPrefix("t = ")
        field.setRange(0.0, 1.0)
        field.setDecimals(2)
        field.setSingleStep(0.01)
        field.setKeyboardTracking(False)
        field.valueChanged.connect(self._seek)
        return field

    @Slot(float)
    def _follow(self, t: float) -> None:
        self._t.follow(t)

    @Slot(float)
    def _seek(self, t: float) -> None:
        self._player.seek(t)

    @Slot(int)
    def _choose_repeat(self, index: int) -> None:
        self._player.set_repeat(self._repeat.itemData(index))

    @Slot(int)
    def _choose_speed(self, index: int) -> None:
        self._player.set_speed(self._speed.itemData(index))


class Legend(QWidget):
    """The methods' names beside their lanes in the chart, with the lines that stand for them."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        session.document_changed.connect(self.update)

    def sizeHint(self) -> QSize:
        names = [self.tr("Area drift"), self.tr("Length drift"), *(words.method(name) for name in METHODS)]
        return QSize(max(self.fontMetrics().horizontalAdvance(name) for name in names) + 60, 40)

    def paintEvent(self, event: QPaintEvent) -> None:
        with painting(self) as painter:
            self._paint(painter)

    def _paint(self, painter: QPainter) -> None:
        theme = theme_of(self.palette())
        methods = self._session.document.methods
        places = ChartLayout(self.width(), self.height(), 0.0, len(methods))
        font = painter.font()
        font.setPointSizeF(8.0)
        painter.setFont(font)
        painter.setPen(QColor(theme.muted))
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for plot, text in ((places.area, self.tr("Area drift")), (places.lengths, self.tr("Length drift"))):
            painter.drawText(plot.adjusted(0, 0, -4, 0), right, text)
        for number, method in enumerate(methods):
            lane = places.lane(number)
            painter.setPen(method_pen(theme, method))
            middle = lane.center().y()
            painter.drawLine(QPointF(lane.right() - 34, middle), QPointF(lane.right() - 4, middle))
            painter.setPen(QColor(theme.muted))
            painter.drawText(lane.adjusted(0, 0, -40, 0), right, words.method(method))


def _button(action: QAction) -> QToolButton:
    button = QToolButton()
    button.setDefaultAction(action)
    button.setIconSize(QSize(18, 18))
    button.setAutoRaise(True)
    button.setAccessibleName(action.text().replace("&", ""))
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button
