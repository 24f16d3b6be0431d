"""Strip chart: how far each method's area and lengths stray over t, and where its frames cross themselves."""

from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Slot
from PySide6.QtGui import QColor, QHelpEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPixmap, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from app.session import Session
from app.view.painting.drawing import faded, layer_for, painting, pen, polygon_of
from app.view.painting.theme import Theme, theme_of
from app.view.timeline.chart_layout import LANE, ChartLayout
from app.view.timeline.player import Player
from app.view.wording import words
from app.view.wording.verdicts import AnyReport, Span, crossing_spans
from starskel.arrays import Floats
from starskel.blending import METHODS
from starskel.sheet.words import percent

LEAST_RANGE = 0.05
"""The plots never magnify more than to this deviation, so that small ones look small."""

NEAR = 6.0
"""Pixels within which a click goes to a crossing instead of beside it."""

STALE = 0.35
"""Opacity of curves of shapes that have changed since."""

DASHES: tuple[tuple[float, ...], ...] = ((), (6, 3), (2, 2.5), (8, 3, 2, 3), (4, 2, 1, 2, 1, 2), (1, 3))
"""Dash patterns, a second sign of the method beside its colour."""


def method_pen(theme: Theme, method: str) -> QPen:
    """Give the line that stands for a method in charts and legends, whatever others are shown."""
    number = METHODS.index(method)
    made = pen(theme.methods[number % len(theme.methods)], 2.0)
    dashes = DASHES[number % len(DASHES)]
    if dashes:
        made.setDashPattern(dashes)
    return made


@dataclass(frozen=True, eq=False)
class Curve:
    """What is charted of a method."""

    number: int
    method: str
    report: AnyReport
    stale: bool


class StripChart(QWidget):
    """A click goes to the moment under it; one on a crossing stops there."""

    def __init__(self, session: Session, player: Player, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._player = player
        self._curves_image: QPixmap | None = None
        self.inset = 8.0
        self.setObjectName("strip-chart")
        self.setAccessibleName(self.tr("Area, lengths and crossings over time"))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setMouseTracking(True)
        session.blends.changed.connect(self._follow)
        session.document_changed.connect(self.updateGeometry)
        player.t_changed.connect(self.update)

    def sizeHint(self) -> QSize:
        return QSize(400, ChartLayout.least_height(len(self._session.document.methods)))

    def minimumSizeHint(self) -> QSize:
        return QSize(160, self.sizeHint().height())

    @property
    def places(self) -> ChartLayout:
        """Where everything lies."""
        return ChartLayout(self.width(), self.height(), self.inset, len(self._session.document.methods))

    @property
    def range(self) -> float:
        """The deviation at the upper edge of the plot of areas."""
        return _range([curve.report.area_deviations for curve in self._curves()])

    @property
    def length_range(self) -> float:
        """The deviation at the upper edge of the plot of lengths."""
        return _range([curve.report.length_deviations for curve in self._curves()])

    @Slot()
    def _follow(self) -> None:
        self._curves_image = None
        self.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._curves_image = None

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        self._curves_image = None

    def _curves(self) -> list[Curve]:
        results = self._session.blends.results
        return [
            Curve(number, method, shown.result.report, shown.stale)
            for number, method in enumerate(self._session.document.methods)
            if (shown := results.get(method)) is not None and shown.result is not None
        ]

    # pointer

    def mousePressEvent(self, event: QMouseEvent) -> None:
        crossing = self._crossing_at(event.position())
        if crossing is None:
            self._player.seek(self.places.t(event.position().x()))
        else:
            _, span = crossing
            self._player.stop_at(min(max(self.places.t(event.position().x()), span.start), span.stop))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._player.seek(self.places.t(event.position().x()))
        on_crossing = self._crossing_at(event.position()) is not None
        self.setCursor(Qt.CursorShape.PointingHandCursor if on_crossing else Qt.CursorShape.ArrowCursor)

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            QToolTip.showText(event.globalPos(), self._tip(QPointF(event.pos())), self)
            return True
        return super().event(event)

    def _crossing_at(self, place: QPointF) -> tuple[Curve, Span] | None:
        """Give the crossing under a pixel, and whose it is."""
        lane = self.places.lane_at(place.y())
        for curve in self._curves():
            for span in crossing_spans(curve.report) if curve.number == lane else ():
                if self.places.x(span.start) - NEAR <= place.x() <= self.places.x(span.stop) + NEAR:
                    return curve, span
        return None

    def _tip(self, place: QPointF) -> str:
        crossing = self._crossing_at(place)
        if crossing is None:
            return self.tr(
                "Drift of area and lengths. Solid bars: frames cross themselves; hollow bars: they lie over "
                "themselves, as a coil does. Click to go there."
            )
        curve, span = crossing
        text = (
            self.tr("{method}: lies over itself, naturally, from t = {start} to {stop}")
            if span.natural
            else self.tr("{method}: crosses itself from t = {start} to {stop}")
        )
        start, stop = (words.figure(f"{t:.2f}") for t in (span.start, span.stop))
        return text.format(method=words.method(curve.method), start=start, stop=stop)

    # painting

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the curves from an image that is made once a result, and the cursor over it."""
        if self._curves_image is None:
            self._curves_image = layer_for(self)
            with painting(self._curves_image) as painter:
                self._paint(painter, theme_of(self.palette()))
        x = self.places.x(self._player.t)
        with painting(self) as painter:
            painter.drawPixmap(0, 0, self._curves_image)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(pen(theme_of(self.palette()).text, 1.5))
            painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))

    def _paint(self, painter: QPainter, theme: Theme) -> None:
        places, curves = self.places, self._curves()
        for plot in (places.area, places.lengths):
            painter.fillRect(plot, QColor(theme.base))
            painter.setPen(pen(theme.edge, 1.0))
            painter.drawRect(plot)
        zero = places.area.center().y()
        painter.drawLine(QPointF(places.area.left(), zero), QPointF(places.area.right(), zero))
        self._paint_scales(painter, theme, places)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        half, whole = places.area.height() / 2 - 2, places.lengths.height() - 3
        for curve in curves:
            report = curve.report
            painter.setOpacity(STALE if curve.stale else 1.0)
            painter.setPen(method_pen(theme, curve.method))
            xs = places.inset + report.times * places.span
            _paint_line(painter, xs, zero - report.area_deviations / self.range * half)
            floor = places.lengths.bottom() - 1
            _paint_line(painter, xs, floor - report.length_deviations / self.length_range * whole)
            self._paint_lane(painter, theme, places, curve)

    def _paint_scales(self, painter: QPainter, theme: Theme, places: ChartLayout) -> None:
        font = painter.font()
        font.setPointSizeF(8.0)
        painter.setFont(font)
        painter.setPen(QColor(theme.muted))
        left, top = Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignTop
        area = places.area.adjusted(5, 2, -5, -2)
        painter.drawText(area, left | top, "+" + words.figure(percent(self.range)))
        low = "\N{MINUS SIGN}" + words.figure(percent(self.range))
        painter.drawText(area, left | Qt.AlignmentFlag.AlignBottom, low)
        painter.drawText(
            places.lengths.adjusted(5, 2, -5, -2), left | top, words.figure(percent(self.length_range))
        )

    def _paint_lane(self, painter: QPainter, theme: Theme, places: ChartLayout, curve: Curve) -> None:
        """Paint a lane; stretches of harmful crossings are solid, those of natural ones hollow."""
        lane = places.lane(curve.number)
        middle = lane.center().y()
        painter.setPen(pen(faded(theme.muted, 0.4), 1.0))
        painter.drawLine(QPointF(lane.left(), middle), QPointF(lane.right(), middle))
        for span in crossing_spans(curve.report):
            left = places.x(span.start)
            width = max(places.x(span.stop) - left, 3.0)
            painter.setPen(pen(theme.refused, 1.0))
            painter.setBrush(QColor(theme.base if span.natural else theme.refused))
            painter.drawRoundedRect(QRectF(left, lane.top() + 2, width, LANE - 5), 2, 2)


def _range(deviations: list[Floats]) -> float:
    return max([LEAST_RANGE, *(float(np.abs(each).max()) for each in deviations)])


def _paint_line(painter: QPainter, xs: Floats, ys: Floats) -> None:
    painter.drawPolyline(polygon_of(np.stack([xs, ys], axis=1)))
