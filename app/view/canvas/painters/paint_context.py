"""What all painters of a canvas know: where they paint, the shape as it is shown, and what is done to it."""

from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter, QPalette

from app.model.document import Document
from app.model.marks import Side
from app.model.point import Point
from app.session import Session
from app.tools.tool import Overlay
from app.view.painting.camera import Camera
from app.view.painting.drawing import point_of
from app.view.painting.theme import Theme, theme_of
from starskel.arrays import Floats

CROWDED = 7.0
"""Vertices nearer to each other than so many pixels, on average, are not shown one by one."""


@dataclass(frozen=True, eq=False)
class PaintContext:
    """One canvas while it is painted once.

    Attributes
    ----------
    painter : QPainter
    theme : Theme
    camera : Camera
    session : Session
    side : {"source", "target"}
    overlay : Overlay
        The gesture under way.
    colour : QColor
        The colour of the part worked on.
    ring : (n, 2) array
        The part worked on, as the gesture under way would leave it.
    screen : (n, 2) array
        The same in pixels.
    """

    painter: QPainter
    theme: Theme
    camera: Camera
    session: Session
    side: Side
    overlay: Overlay
    colour: QColor
    ring: Floats
    screen: Floats

    @classmethod
    def of(
        cls, painter: QPainter, palette: QPalette, camera: Camera, session: Session, side: Side
    ) -> "PaintContext":
        """Take from the session what is on one side of it."""
        theme, overlay, document = theme_of(palette), session.overlay(side), session.document
        part = document.part(side)
        own = "" if part is None else document.shape(side).parts[part].colour
        ring = document.vertices(side) if overlay.ring is None else overlay.ring
        colour = QColor(own or theme.side(side))
        return cls(painter, theme, camera, session, side, overlay, colour, ring, camera.to_screen(ring))

    @property
    def document(self) -> Document:
        """What is edited."""
        return self.session.document

    @property
    def frame(self) -> QRectF:
        """The whole canvas."""
        return QRectF(0, 0, self.camera.width, self.camera.height)

    @property
    def replaced(self) -> bool:
        """Whether the gesture would put another shape in the place of this one."""
        return bool(self.overlay.path) or self.overlay.figure is not None

    @property
    def crowded(self) -> bool:
        """Whether the vertices are too near to each other to be shown one by one."""
        if len(self.screen) < 40:
            return False
        ways = np.diff(self.screen, axis=0, append=self.screen[:1])
        return float(np.hypot(*ways.T).mean()) < CROWDED

    def on_screen(self, point: Point) -> QPointF:
        """Give the place of a point of the document on the canvas."""
        return point_of(self.camera.to_screen(np.array(point)))
