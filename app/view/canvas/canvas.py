"""Canvas: one of the two shapes, to be looked at and edited."""

from dataclasses import replace
from time import monotonic

import numpy as np
from PySide6.QtCore import QPointF, Qt, Signal, Slot
from PySide6.QtGui import (
    QDragEnterEvent,
    QDropEvent,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPaintEvent,
    QPalette,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.model.marks import Side
from app.model.placing import corners_of
from app.session import Session
from app.tools.tool import PICK, Key, Pointer
from app.view.canvas.painters.paint_context import PaintContext
from app.view.canvas.painters.painter import paint_canvas
from app.view.painting.camera import Camera
from app.view.painting.display import Display
from app.view.painting.drawing import painting
from app.view.wording import words

MARGIN = 52.0
"""Pixels left free around a fitted shape: room for pins and caption."""

TINY = 0.2
"""A shape that comes from elsewhere and takes less of the view than this, either way, is shown larger."""

LARGEST_MARGIN = 0.2
"""No more of a small canvas than this share is left free at each side."""

NOTCH = 1.25
"""Zoom factor of one notch of the wheel."""

TAP = 0.3
"""Seconds for which Space is held at most where that is a tap; longer, it is held to pan."""

KEYS = {
    Qt.Key.Key_Return: "enter",
    Qt.Key.Key_Enter: "enter",
    Qt.Key.Key_Backspace: "backspace",
    Qt.Key.Key_Left: "left",
    Qt.Key.Key_Right: "right",
    Qt.Key.Key_Up: "up",
    Qt.Key.Key_Down: "down",
}


class Canvas(QWidget):
    """Shows one side of the session's document and feeds the tool with what the user does here."""

    dropped = Signal(str, object)
    """The side, and the QMimeData that was dropped on it."""

    tapped = Signal()
    """Space was tapped."""

    def __init__(self, session: Session, side: Side, display: Display) -> None:
        super().__init__()
        self.side = side
        self.camera = Camera()
        self._session = session
        self._display = display
        self._fits = True
        self._panning_from: QPointF | None = None
        self._panning_with = Qt.MouseButton.NoButton
        self._space, self._space_since = False, 0.0
        self.setObjectName(f"{side}-canvas")
        self.setAccessibleName(words.side(side))
        self.setMouseTracking(True)
        self.setAcceptDrops(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAutoFillBackground(False)
        self.setMinimumSize(160, 120)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        for signal in (session.changed, session.pointed_changed, display.changed):
            signal.connect(self.update)
        session.blends.changed.connect(self._follow_results)
        session.opened.connect(self.fit)
        session.step_changed.connect(self.fit)
        session.tool_changed.connect(self._show_cursor)
        self._show_cursor()

    # what is shown

    @Slot()
    def _follow_results(self) -> None:
        """Paint anew where blends are shown here, too: all of them come one after another with every edit."""
        layers = self._display.layers
        if layers.pieces or layers.skeleton or self._session.pointed is not None:
            self.update()

    @Slot()
    def fit(self) -> None:
        """Show the whole shape and its picture; keep them fitted until the user zooms or pans."""
        self._fits = True
        self._aim()

    def reveal(self) -> None:
        """Show the whole shape where a part of it is out of sight, or where it would be too small to see."""
        screen = self.camera.to_screen(self._session.document.extent(self.side))
        inside = ((screen >= 0) & (screen <= (self.width(), self.height()))).all()
        if not inside or (np.ptp(screen, axis=0) < np.array([self.width(), self.height()]) * TINY).all():
            self.fit()

    def zoom(self, factor: float) -> None:
        """Zoom at the middle of the view."""
        self._look(self.camera.zoomed(factor, self.width() / 2, self.height() / 2))

    def paintEvent(self, event: QPaintEvent) -> None:
        with painting(self) as painter:
            context = PaintContext.of(painter, self.palette(), self.camera, self._session, self.side)
            paint_canvas(context, self._display.layers)
            if self.hasFocus():
                painter.setPen(self.palette().color(QPalette.ColorRole.Highlight))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.drawRect(self.rect().adjusted(0, 0, -1, -1))

    def resizeEvent(self, event: QResizeEvent) -> None:
        self.camera = self.camera.resized(self.width(), self.height())
        if self._fits and not self._session.tool.busy:
            self._aim()

    def _aim(self) -> None:
        document = self._session.document
        extent = document.extent(self.side)
        if (picture := document.picture(self.side)) is not None:
            extent = np.concatenate([extent, corners_of(picture)])
        margin = min(MARGIN, LARGEST_MARGIN * min(self.width(), self.height()))
        self.camera = self.camera.fitting(extent, margin)
        self.update()

    def _look(self, camera: Camera) -> None:
        self._fits = False
        self.camera = camera
        self.update()

    # pictures dropped here

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if event.mimeData().hasImage() or event.mimeData().hasUrls():
            _accept_copy(event)

    def dropEvent(self, event: QDropEvent) -> None:
        _accept_copy(event)
        self.dropped.emit(self.side, event.mimeData())

    # pointer and keys

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        if event.button() == Qt.MouseButton.MiddleButton or (self._space and self._is_left(event)):
            self._panning_from, self._panning_with = event.position(), event.button()
            self._space_since = -TAP  # it was held down to pan
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
        elif self._is_left(event):
            self._session.press(self._pointer(event))

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if self._is_left(event) and not self._space:
            self._session.double_press(self._pointer(event))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._panning_from is not None:
            way = event.position() - self._panning_from
            self._panning_from = event.position()
            self._look(self.camera.panned(way.x(), way.y()))
        else:
            self._session.move(self._pointer(event))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._panning_from is not None and event.button() == self._panning_with:
            self._panning_from = None
            self._show_cursor()
        elif self._is_left(event):
            self._session.release(self._pointer(event))

    def wheelEvent(self, event: QWheelEvent) -> None:
        place = event.position()
        factor = NOTCH ** (event.angleDelta().y() / 120)
        self._look(self.camera.zoomed(factor, place.x(), place.y()))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        name = KEYS.get(Qt.Key(event.key()))
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._space, self._space_since = True, monotonic()
            self._show_cursor()
        elif name is not None:
            far = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            alt = bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
            self._session.key(Key(name, (10 if far else 1) / self.camera.scale, far, alt))
        else:
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            tapped = self._space and monotonic() - self._space_since < TAP
            self._space = False
            self._show_cursor()
            if tapped:
                self.tapped.emit()
        else:
            super().keyReleaseEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._space = False
        self._show_cursor()
        self.update()

    def focusInEvent(self, event: QFocusEvent) -> None:
        self.update()

    @staticmethod
    def _is_left(event: QMouseEvent) -> bool:
        return event.button() == Qt.MouseButton.LeftButton

    def pointer_at(self, place: QPointF) -> Pointer:
        """Give a pixel of this canvas as the tools know it."""
        at = self.camera.to_document(place.x(), place.y())
        return Pointer(self.side, at, PICK / self.camera.scale, view=self.camera.seen)

    def _pointer(self, event: QMouseEvent) -> Pointer:
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        free = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        pointer = self.pointer_at(event.position())
        return replace(pointer, shift=shift, free=free, across=self._across(event.position()))

    def _across(self, place: QPointF) -> Pointer | None:
        """Give where a drag that has left this canvas is on the other one."""
        if self.rect().contains(place.toPoint()):
            return None
        window = self.window()
        under = window.childAt(self.mapTo(window, place.toPoint()))
        if not isinstance(under, Canvas) or under is self:
            return None
        return under.pointer_at(under.mapFrom(window, self.mapTo(window, place)))

    @Slot()
    def _show_cursor(self) -> None:
        if self._space:
            self.setCursor(Qt.CursorShape.OpenHandCursor)
        elif self._session.tool.name not in ("select", "mark", "picture"):
            self.setCursor(Qt.CursorShape.CrossCursor)
        else:
            self.setCursor(Qt.CursorShape.ArrowCursor)


def _accept_copy(event: QDropEvent) -> None:
    """Take what is dragged; after a move its original would be taken away."""
    event.setDropAction(Qt.DropAction.CopyAction)
    event.accept()
