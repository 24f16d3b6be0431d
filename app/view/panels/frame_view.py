"""A view of one blend's frame at the player's t."""

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, Slot
from PySide6.QtGui import (
    QColor,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QResizeEvent,
    QShowEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.compute import STEERED, MethodState
from app.model import parts
from app.model.point import Point, as_point
from app.model.texts import QT_TRANSLATE_NOOP
from app.session import Session
from app.view.painting.camera import Camera
from app.view.painting.display import Display
from app.view.painting.drawing import layer_for, painting
from app.view.painting.frame_layers import paint_ghosts, paint_ways
from app.view.painting.structure import shown_structures
from app.view.painting.theme import theme_of
from app.view.panels.carried import CarriedPictures
from app.view.panels.frame_painter import FramePainter
from app.view.timeline.player import Player
from starskel.arrays import Floats

NOTCH = 1.25
"""Zoom factor of one notch of the wheel."""

NEAR = 10.0
"""Pixels within which a star origin counts as under the pointer."""

MARGIN = 14.0
"""Pixels left free around what is fitted."""


class FrameView(QWidget):
    """Shows a frame; the wheel zooms and a drag moves all views together, a double click shows everything."""

    def __init__(self, session: Session, player: Player, display: Display) -> None:
        super().__init__()
        self._session = session
        self._player = player
        self._display = display
        self._state = MethodState()
        self.message = ""
        self._extent: Floats = np.empty((0, 2))
        self.camera = Camera()
        self._fitted = Camera()
        self._backdrop: QPixmap | None = None
        self._pictures = CarriedPictures(session, player, self)
        self._held: QPointF | None = None
        self._pressed = QPointF()
        self.setMouseTracking(True)
        self.setMinimumSize(120, 90)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        player.t_changed.connect(self._follow)
        session.document_changed.connect(self._follow)
        self._pictures.changed.connect(self.update)
        session.pointed_changed.connect(self.update)
        display.changed.connect(self._renew)
        display.moved.connect(self._aim)

    def show_blend(self, state: MethodState, extent: Floats, message: str) -> None:
        """Show another blend; the extent is what must fit in, the message is for when there is none."""
        same = state is self._state and message == self.message and np.array_equal(extent, self._extent)
        if not same:
            self._state, self._extent, self.message = state, extent, message
            self._aim()

    # the view

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._aim()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        self._renew()

    @Slot()
    def _aim(self) -> None:
        self._fitted = Camera().resized(self.width(), self.height()).fitting(self._extent, MARGIN)
        self.camera = self._display.seen_by(self._fitted)
        self._renew()

    @Slot()
    def _renew(self) -> None:
        self._backdrop = None
        self._follow()

    @Slot()
    def _follow(self) -> None:
        """Show another moment, or the same in another way."""
        wanted = self._display.layers.pictures and not self._state.stale and self.isVisible()
        result = self._state.result if wanted else None
        self._pictures.ask(result, self.camera, self.size(), self.devicePixelRatioF())
        self.update()

    def showEvent(self, event: QShowEvent) -> None:
        self._follow()

    def wheelEvent(self, event: QWheelEvent) -> None:
        place = event.position()
        factor = NOTCH ** (event.angleDelta().y() / 120)
        self._display.look(self._fitted, self.camera.zoomed(factor, place.x(), place.y()))
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() in (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton):
            self._held = self._pressed = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held is not None:
            way = event.position() - self._held
            self._held = event.position()
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
            self._display.look(self._fitted, self.camera.panned(way.x(), way.y()))

        elif self.origin_at(event.position()) is not None:
            self.setCursor(Qt.CursorShape.PointingHandCursor)
        else:
            self.unsetCursor()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End a drag; a click on a star origin makes it the root."""
        clicked = event.button() == Qt.MouseButton.LeftButton and event.position() == self._pressed
        self._held = None
        self.unsetCursor()
        if clicked and (origin := self.origin_at(event.position())) is not None:
            document = parts.root(self._session.document, *origin)
            self._session.store(document, QT_TRANSLATE_NOOP("Step", "Choose root"))

    def origin_at(self, place: QPointF) -> tuple[int, Point] | None:
        """Give the link of the star origin under a pixel and its place in the source, if it can be a root."""
        result = self._state.fresh
        if result is None or result.method != STEERED or not self._display.layers.skeleton:
            return None
        shown = [look.visible for look in parts.looks(self._session.document)]
        near: list[tuple[float, int, Point]] = []
        for structure in shown_structures(result, self._player.t, shown):
            origins = structure.blend.decomposition.source_origins
            points = self.camera.to_screen(structure.skeleton[: len(origins)])
            ways = np.hypot(*(points - (place.x(), place.y())).T)
            nearest = int(ways.argmin())
            near.append((float(ways[nearest]), structure.number, as_point(origins[nearest])))
        way, number, origin = min(near, default=(np.inf, 0, (0.0, 0.0)))
        return (number, origin) if way <= NEAR else None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self._display.fit()

    # painting

    def paintEvent(self, event: QPaintEvent) -> None:
        with painting(self) as painter:
            self._paint(painter)

    def _paint(self, painter: QPainter) -> None:
        theme = theme_of(self.palette())
        painter.fillRect(self.rect(), QColor(theme.base))
        result = self._state.result
        if result is not None:
            self._paint_backdrop(painter)
            pictured = self._pictures.t is not None
            t = self._player.t if self._pictures.t is None else self._pictures.t
            frame = FramePainter(painter, theme, self.camera, self._display.layers)
            looks = parts.looks(self._session.document)
            if pictured:
                frame.paint_ground(result, t, looks)
                self._pictures.paint(painter, self.camera)
            frame.paint(result, t, looks, stale=self._state.stale, pictured=pictured)
            if (matched := self._session.matched_vertex) is not None and not self._state.stale:
                frame.paint_trace(result, t, self._session.document.link, matched.row)
        if self.message:
            painter.setPen(QColor(theme.muted))
            room = QRectF(self.rect()).adjusted(14, 10, -14, -10)
            flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(room, flags, self.message)

    def _paint_backdrop(self, painter: QPainter) -> None:
        """Paint what does not move with t from an image, which is made once a blend."""
        layers, result = self._display.layers, self._state.result
        if result is None or self._state.stale or not (layers.onion or layers.ways):
            return
        if self._backdrop is None:
            self._backdrop = layer_for(self)
            with painting(self._backdrop) as behind:
                behind.setRenderHint(QPainter.RenderHint.Antialiasing)
                for samples in map(self.camera.to_screen, result.samples):
                    if layers.onion:
                        paint_ghosts(behind, theme_of(self.palette()), samples)
                    if layers.ways:
                        paint_ways(behind, theme_of(self.palette()), samples)
        painter.drawPixmap(0, 0, self._backdrop)
