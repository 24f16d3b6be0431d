"""The strip of key shapes, painted."""

from itertools import accumulate

from PySide6.QtCore import QCoreApplication, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPolygonF

from app.model.document import Document
from app.model.marks import SIDES
from app.playback import Playback
from app.view.painting.drawing import faded, pen
from app.view.painting.theme import Theme
from app.view.painting.thumbnail import paint_thumbnail
from app.view.sequence.strip_layout import TIMES, StripLayout
from app.view.wording.words import figure
from starskel.files.projects.project import letter

translate = QCoreApplication.translate

HEAD = 7.0
"""Size of an arrow's head, in pixels."""


def seconds(duration: float) -> str:
    """Give a duration in seconds, at usual speed."""
    return translate("Strip", "{seconds} s").format(
        seconds=figure(f"{duration * Playback.duration:.1f}".removesuffix(".0"))
    )


class StripPainter:
    """Paints the key shapes of a document."""

    def __init__(self, painter: QPainter, theme: Theme, places: StripLayout, document: Document) -> None:
        self._painter = painter
        self._theme = theme
        self._places = places
        self._document = document
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)

    def paint(self, part: QRectF, working: int, t: float) -> None:
        """Paint what lies in a part: shapes, one of which is worked on, and steps, one of which is at t."""
        sequence = self._document.sequence
        times = list(accumulate(sequence.durations, initial=0.0))
        for shape, time in enumerate(times):
            if self._places.tile(shape).adjusted(-2, -4, 2, TIMES + 4).intersects(part):
                self._paint_tile(shape, shape == working, seconds(time))
        for step, duration in enumerate(sequence.durations):
            if self._places.step(step).intersects(part):
                self._paint_step(step, seconds(duration))
        if self._places.step(self._document.step).intersects(part):
            self._paint_playhead(t)
        self._paint_addition()

    def paint_slot(self, held: int, slot: int) -> None:
        """Show where a shape would go that is being dragged."""
        x, tile = self._places.slot(slot), self._places.tile(held)
        self._painter.setPen(pen(self._theme.accent, 3.0))
        self._painter.drawLine(QPointF(x, tile.top()), QPointF(x, tile.bottom()))
        self._painter.setPen(Qt.PenStyle.NoPen)
        self._painter.setBrush(faded(self._theme.window, 0.6))
        self._painter.drawRoundedRect(tile.adjusted(-2, -2, 2, 2), 5, 5)

    def _paint_tile(self, shape: int, working: bool, time: str) -> None:
        painter, theme, tile = self._painter, self._theme, self._places.tile(shape)
        colour, shown = self._colour(shape)
        painter.setPen(pen(colour if shown else theme.edge, 2.0 if shown else 1.0))
        painter.setBrush(QColor(theme.base))
        painter.drawRoundedRect(tile, 4, 4)
        drawn = self._document.sequence.shapes[shape]
        if drawn.parts:
            paint_thumbnail(painter, tile.adjusted(18, 2, -2, -2), drawn, colour)
        else:
            painter.setPen(QColor(theme.muted))
            painter.drawText(
                tile.adjusted(18, 0, 0, 0), Qt.AlignmentFlag.AlignCenter, translate("Strip", "empty")
            )
        self._paint_letter(shape, working, colour)
        painter.setPen(QColor(theme.muted))
        below = QRectF(tile.left(), tile.bottom() + 1, tile.width(), TIMES)
        painter.drawText(below, Qt.AlignmentFlag.AlignCenter, time)

    def _paint_letter(self, shape: int, working: bool, colour: QColor) -> None:
        """Write the letter in the upper left corner; on a filled ground where the shape is worked on."""
        painter, text = self._painter, letter(shape)
        font = painter.font()
        painter.save()
        font.setBold(True)
        painter.setFont(font)
        width = max(painter.fontMetrics().horizontalAdvance(text) + 8, 18)
        corner = QRectF(self._places.tile(shape).topLeft() + QPointF(3, 3), QPointF(0, 0))
        corner.setWidth(width)
        corner.setHeight(18)
        if working:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(self._theme.accent))
            painter.drawRoundedRect(corner, 4, 4)
        painter.setPen(QColor(self._theme.on_accent if working else self._theme.text))
        painter.drawText(corner, Qt.AlignmentFlag.AlignCenter, text)
        painter.restore()

    def _paint_step(self, step: int, duration: str) -> None:
        painter, place = self._painter, self._places.step(step)
        shown = step == self._document.step
        colour = QColor(self._theme.accent if shown else self._theme.muted)
        middle, left, right = place.center().y(), place.left() + 6, place.right() - 6
        painter.setPen(pen(colour, 2.0 if shown else 1.2))
        painter.drawLine(QPointF(left, middle), QPointF(right - HEAD, middle))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        wings = (QPointF(right - HEAD, middle - HEAD / 2), QPointF(right - HEAD, middle + HEAD / 2))
        painter.drawPolygon(QPolygonF([QPointF(right, middle), *wings]))
        painter.setPen(QColor(self._theme.text if shown else self._theme.muted))
        above = QRectF(place.left(), place.top(), place.width(), place.height() / 2 - 5)
        painter.drawText(above, Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignBottom, duration)

    def _paint_playhead(self, t: float) -> None:
        place = self._places.step(self._document.step)
        left, right = place.left() + 6, place.right() - 6
        self._painter.setPen(pen(self._theme.base, 1.5))
        self._painter.setBrush(QColor(self._theme.text))
        self._painter.drawEllipse(QPointF(left + t * (right - left), place.center().y()), 5.5, 5.5)

    def _paint_addition(self) -> None:
        box = self._places.addition
        self._painter.setPen(pen(self._theme.muted, 1.2, Qt.PenStyle.DashLine))
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._painter.drawRoundedRect(box, 5, 5)
        self._painter.setPen(pen(self._theme.text, 2.0))
        centre = box.center()
        self._painter.drawLine(centre - QPointF(5, 0), centre + QPointF(5, 0))
        self._painter.drawLine(centre - QPointF(0, 5), centre + QPointF(0, 5))

    def _colour(self, shape: int) -> tuple[QColor, bool]:
        """Give the colour of a shape, that of its canvas where it is on one, and whether it is."""
        for side in SIDES:
            if self._document.shape_on(side) == shape:
                return self._theme.side(side), True
        return QColor(self._theme.muted), False
