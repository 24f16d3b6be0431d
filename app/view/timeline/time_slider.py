"""Time slider: t from 0 to 1, with the moments marked when a shown blend crosses itself."""

from PySide6.QtCore import QPointF, QRectF, QSignalBlocker, Qt, Slot
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QWidget

from app.compute import Blends
from app.view.painting.drawing import painting
from app.view.painting.theme import theme_of
from app.view.timeline.player import Player
from app.view.wording.verdicts import crossing_spans

STEPS = 1000


class TimeSlider(QSlider):
    """Follows the player and moves it; a click on the groove goes there at once."""

    def __init__(self, blends: Blends, player: Player, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self._blends = blends
        self._player = player
        self.setRange(0, STEPS)
        self.setSingleStep(STEPS // 100)
        self.setPageStep(STEPS // 10)
        self.setObjectName("time")
        self.setAccessibleName(self.tr("Time, from source to target"))
        self.setMinimumHeight(30)
        player.t_changed.connect(self._follow)
        blends.changed.connect(self.update)
        self.valueChanged.connect(self._seek)

    @property
    def inset(self) -> float:
        """Pixels from the slider's edge to the middle of its handle at t = 0."""
        return self.style().pixelMetric(QStyle.PixelMetric.PM_SliderLength, self._option(), self) / 2

    @Slot(float)
    def _follow(self, t: float) -> None:
        with QSignalBlocker(self):
            self.setValue(round(t * STEPS))

    @Slot(int)
    def _seek(self, value: int) -> None:
        self._player.seek(value / STEPS)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            span = self.width() - 2 * self.inset
            self.setValue(round((event.position().x() - self.inset) / span * STEPS))
        super().mousePressEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        with painting(self) as painter:
            self._paint_crossings(painter)

    def _paint_crossings(self, painter: QPainter) -> None:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(theme_of(self.palette()).refused))
        span = self.width() - 2 * self.inset
        for shown in self._blends.results.values():
            for start, stop, _ in crossing_spans(shown.result.report) if shown.result is not None else ():
                place = QPointF(self.inset + start * span, 0)
                painter.drawRect(QRectF(place.x(), 1, max((stop - start) * span, 2.0), 3))

    def _option(self) -> QStyleOptionSlider:
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        return option
