"""The pictures in the shape of one panel: asked for, taken in, and painted."""

import numpy as np
from PySide6.QtCore import QObject, QRectF, QSize, Signal, Slot
from PySide6.QtGui import QImage, QPainter

from app.compute.morphs import Carried, MorphRequest, PaintedMorph, finer
from app.compute.request import Result
from app.model import parts
from app.session import Session
from app.view.painting.camera import Camera
from app.view.timeline.player import Player
from starskel.blending.pieces import PieceBlend
from starskel.decomposition.pieces import Decomposition


class CarriedPictures(QObject):
    """Keeps what a panel shows of pictures in step with its blend, its view and the clock.

    While time runs frames come as fast as they can be painted, each with its own t; what stands still is
    painted once more, with care.
    """

    changed = Signal()

    def __init__(self, session: Session, player: Player, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self._player = player
        self._carried: Carried | None = None
        self._painted: PaintedMorph | None = None
        self._image: QImage | None = None
        session.morphs.painted.connect(self._take)
        player.playing_changed.connect(self._settle)

    def ask(self, result: Result | None, camera: Camera, size: QSize, ratio: float) -> None:
        """Want the pictures of a blend as a camera sees them now; nothing where there are none."""
        carried = self._carry(result)
        if carried is None or result is None or size.isEmpty():
            self._carried = self._painted = self._image = None
            return
        if self._carried is not None and self._carried.blend.pair is not carried.blend.pair:
            self._painted = self._image = None  # what is left of an improved blend may stay for a moment
        self._carried = carried
        pixels = round(size.width() * ratio), round(size.height() * ratio)
        looks = enumerate(parts.looks(self._session.document))
        hidden = tuple(number for number, look in looks if not look.visible)
        view = (*camera.seen.low, *camera.seen.high)
        request = MorphRequest(result.method, carried, self._player.t, pixels, view, hidden)
        self._session.morphs.paint(request)

    @property
    def t(self) -> float | None:
        """The moment of the pictures that there are to show, None where there are none."""
        return None if self._image is None or self._painted is None else self._painted.request.t

    def paint(self, painter: QPainter, camera: Camera) -> None:
        """Paint them where a camera sees them, which may have moved since."""
        if self._image is None or self._painted is None:
            return
        left, bottom, right, top = self._painted.request.view
        (x, y), scale = camera.to_screen(np.array([left, top])).tolist(), camera.scale
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(QRectF(x, y, (right - left) * scale, (top - bottom) * scale), self._image)

    def _carry(self, result: Result | None) -> Carried | None:
        document = self._session.document
        source, target = document.picture("source"), document.picture("target")
        if result is None or (source is None and target is None):
            return None
        known = self._carried
        carried = Carried(result.blend, source, target, self._decomposition(result))
        return known if known is not None and known.same(carried) else carried

    def _decomposition(self, result: Result) -> Decomposition | None:
        """Give the star pieces that another method has found for the same pair."""
        for other in self._session.blends.fresh:
            if other.blend.pair is result.blend.pair and isinstance(other.blend, PieceBlend):
                return other.blend.decomposition
        return None

    @Slot(object)
    def _take(self, painted: PaintedMorph) -> None:
        if self._carried is None or not painted.request.carried.same(self._carried):
            return
        self._painted = painted
        self._image = None
        if painted.pixels is not None:
            height, width = painted.pixels.shape[:2]
            kind = QImage.Format.Format_RGBA8888_Premultiplied
            self._image = QImage(painted.pixels.data, width, height, 4 * width, kind)
        self.changed.emit()
        self._settle()

    @Slot()
    def _settle(self) -> None:
        """Have what stands still painted with care."""
        painted = self._painted
        still = not self._player.playing and painted is not None and not painted.request.careful
        if still and painted is not None and painted.request.t == self._player.t:
            self._session.morphs.paint(finer(painted.request))
