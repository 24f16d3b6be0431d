"""Strip chart: how far each method's area strays over t, and where its frames cross themselves."""

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Slot
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPen, QPixmap, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.session import Session
from app.view.drawing import faded, layer_for, painting, pen, polygon_of
from app.view.player import Player
from app.view.theme import Theme, theme_of
from app.view.verdicts import crossing_spans
from starskel.quality import Report
from starskel.sheet.words import percent

LANE = 11
"""Height of a method's lane of crossings, in pixels."""

PLOT = 54
"""Least height of the plot of areas."""

LEAST_RANGE = 0.05
"""The plot never magnifies more than to this deviation, so that small ones look small."""

DASHES: tuple[tuple[float, ...], ...] = ((), (6, 3), (2, 2.5), (8, 3, 2, 3), (4, 2, 1, 2, 1, 2), (1, 3))
"""Dash patterns, a second sign of the method beside its colour."""


def method_pen(theme: Theme, number: int) -> QPen:
    """Give the line that stands for the k-th method in charts and legends."""
    made = pen(theme.methods[number % len(theme.methods)], 2.0)
    dashes = DASHES[number % len(DASHES)]
    if dashes:
        made.setDashPattern(dashes)
    return made


class StripChart(QWidget):
    """Reports above, a lane of crossings for each method below; a click goes to the moment under it."""

    def __init__(self, session: Session, player: Player, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._player = player
        self._curves_image: QPixmap | None = None
        self.inset = 8.0
        self.setObjectName("strip-chart")
        self.setAccessibleName(self.tr("Area and crossings over time"))
        self.setToolTip(
            self.tr("Deviation of the area, and the moments when a frame crosses itself. Click to go there.")
        )
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        session.results_changed.connect(self._follow)
        player.t_changed.connect(self.update)

    def sizeHint(self) -> QSize:
        return QSize(400, PLOT + LANE * max(len(self._session.document.methods), 1) + 4)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, self.sizeHint().height())

    @property
    def range(self) -> float:
        """The deviation at the upper edge of the plot."""
        largest = [float(np.abs(report.area_deviations).max()) for _, report, _ in self._curves()]
        return max([LEAST_RANGE, *largest])

    @Slot()
    def _follow(self) -> None:
        self._curves_image = None
        self.updateGeometry()
        self.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._curves_image = None

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        self._curves_image = None

    def _curves(self) -> list[tuple[int, Report, bool]]:
        results = self._session.results
        return [
            (number, shown.result.report, shown.stale)
            for number, method in enumerate(self._session.document.methods)
            if (shown := results.get(method)) is not None and shown.result is not None
        ]

    # pointer

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._seek(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._seek(event)

    def _seek(self, event: QMouseEvent) -> None:
        width = self.width() - 2 * self.inset
        self._player.seek(min(max((event.position().x() - self.inset) / width, 0.0), 1.0))

    # painting

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the curves from an image that is made once a result, and the cursor over it."""
        if self._curves_image is None:
            self._curves_image = self._paint_curves()
        x = self.inset + self._player.t * (self.width() - 2 * self.inset)
        with painting(self) as painter:
            painter.drawPixmap(0, 0, self._curves_image)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(pen(theme_of(self.palette()).text, 1.5))
            painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))

    def _paint_curves(self) -> QPixmap:
        image = layer_for(self)
        with painting(image) as painter:
            self._paint(painter, theme_of(self.palette()))
        return image

    def _paint(self, painter: QPainter, theme: Theme) -> None:
        lanes = LANE * len(self._session.document.methods)
        plot = QRectF(self.inset, 1, self.width() - 2 * self.inset, self.height() - lanes - 4)
        painter.fillRect(plot, QColor(theme.base))
        self._paint_scale(painter, theme, plot)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for number, report, stale in self._curves():
            painter.setOpacity(0.35 if stale else 1.0)
            self._paint_curve(painter, theme, plot, number, report)
            self._paint_lane(painter, theme, plot, number, report)

    def _paint_scale(self, painter: QPainter, theme: Theme, plot: QRectF) -> None:
        painter.setPen(pen(theme.edge, 1.0))
        painter.drawRect(plot)
        painter.drawLine(QPointF(plot.left(), plot.center().y()), QPointF(plot.right(), plot.center().y()))
        font = painter.font()
        font.setPointSizeF(8.0)
        painter.setFont(font)
        painter.setPen(QColor(theme.muted))
        inner = plot.adjusted(5, 2, -5, -2)
        left = Qt.AlignmentFlag.AlignLeft
        painter.drawText(inner, left | Qt.AlignmentFlag.AlignTop, "+" + percent(self.range))
        painter.drawText(inner, left | Qt.AlignmentFlag.AlignBottom, "\N{MINUS SIGN}" + percent(self.range))

    def _paint_curve(
        self, painter: QPainter, theme: Theme, plot: QRectF, number: int, report: Report
    ) -> None:
        x = plot.left() + report.times * plot.width()
        y = plot.center().y() - report.area_deviations / self.range * (plot.height() / 2 - 2)
        painter.setPen(method_pen(theme, number))
        painter.drawPolyline(polygon_of(np.stack([x, y], axis=1)))

    def _paint_lane(self, painter: QPainter, theme: Theme, plot: QRectF, number: int, report: Report) -> None:
        top = plot.bottom() + 4 + LANE * number
        middle = top + LANE / 2
        painter.setPen(pen(faded(theme.muted, 0.4), 1.0))
        painter.drawLine(QPointF(plot.left(), middle), QPointF(plot.right(), middle))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(theme.refused))
        for start, stop in crossing_spans(report):
            left = plot.left() + start * plot.width()
            width = max((stop - start) * plot.width(), 3.0)
            painter.drawRoundedRect(QRectF(left, top + 2, width, LANE - 4), 2, 2)
