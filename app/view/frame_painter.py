"""One frame of a blend as a panel shows it."""

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter

from app.view.camera import Camera
from app.view.display import Display
from app.view.drawing import faded, lines_of, pen, point_of, polygon_of
from app.view.pins import cross_at
from app.view.theme import Theme
from starskel.blending.frames import Blend
from starskel.blending.pieces import PieceBlend
from starskel.sheet.keyframe import Keyframe

STALE = 0.4
"""Opacity of a frame whose shapes have changed since."""


class FramePainter:
    """Paints the frame of a blend at one t."""

    def __init__(self, painter: QPainter, theme: Theme, camera: Camera, display: Display) -> None:
        self._painter = painter
        self._theme = theme
        self._camera = camera
        self._display = display

    def paint(self, blend: Blend, t: float, *, crosses: bool, stale: bool) -> None:
        """Paint fill or star pieces, outline, skeleton, and the places where the frame crosses itself."""
        self._painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._painter.setOpacity(STALE if stale else 1.0)
        frame = blend.at(t)
        if self._display.pieces and isinstance(blend, PieceBlend):
            self._paint_pieces(blend, t)
        else:
            self._fill(frame, t)
        self._outline(frame, t, crosses)
        if self._display.skeleton and isinstance(blend, PieceBlend):
            self._paint_skeleton(blend, t)
        if crosses:
            self._paint_crossings(Keyframe(t, frame))
        self._painter.setOpacity(1.0)

    def _fill(self, frame: np.ndarray, t: float) -> None:
        self._painter.setPen(Qt.PenStyle.NoPen)
        self._painter.setBrush(faded(self._theme.between(t), 0.35))
        self._painter.drawPolygon(polygon_of(self._camera.to_screen(frame)), Qt.FillRule.WindingFill)

    def _outline(self, frame: np.ndarray, t: float, crosses: bool) -> None:
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        colour = self._theme.refused if crosses else self._theme.between(t)
        hairline = pen(
            colour, 0.0
        )  # one pixel wide; wider, a smooth line takes ten times as long, each frame
        self._painter.setPen(hairline)
        self._painter.drawPolygon(polygon_of(self._camera.to_screen(frame)))

    def _paint_pieces(self, blend: PieceBlend, t: float) -> None:
        points = self._camera.to_screen(blend.points_at(t))
        self._painter.setPen(pen(faded(self._theme.text, 0.45), 1.0))
        for number, piece in enumerate(blend.decomposition.pieces):
            self._painter.setBrush(QColor(self._theme.pieces[number % len(self._theme.pieces)]))
            self._painter.drawPolygon(polygon_of(points[list(piece)]), Qt.FillRule.WindingFill)

    def _paint_skeleton(self, blend: PieceBlend, t: float) -> None:
        """Paint arcs; origins as discs, mid-points as small squares, the root with a ring round it."""
        skeleton = blend.skeleton
        points = self._camera.to_screen(blend.skeleton_at(t))
        colour = QColor(self._theme.text)
        starts, ends = np.array(skeleton.arcs, dtype=np.intp).reshape(-1, 2).T
        self._painter.setPen(pen(colour, 2.0))
        self._painter.drawLines(lines_of(points[starts], points[ends]))
        origins, middles = np.split(points, [len(skeleton.parents)])
        self._paint_dots(origins, colour, 6.4, Qt.PenCapStyle.RoundCap)
        self._paint_dots(middles, colour, 5.6, Qt.PenCapStyle.SquareCap)
        self._paint_dots(middles, QColor(self._theme.base), 3.2, Qt.PenCapStyle.SquareCap)
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._painter.setPen(pen(self._theme.accent, 2.2))
        self._painter.drawEllipse(point_of(points[skeleton.root]), 7.0, 7.0)

    def _paint_dots(self, places: np.ndarray, colour: QColor, size: float, cap: Qt.PenCapStyle) -> None:
        """Paint dots in the shape of a pen's end, all at once: there may be hundreds in each frame."""
        dots = pen(colour, size)
        dots.setCapStyle(cap)
        self._painter.setPen(dots)
        self._painter.drawPoints(polygon_of(places))

    def _paint_crossings(self, frame: Keyframe) -> None:
        """Mark where the frame crosses itself, once for places that would fall on each other."""
        marked: list[QPointF] = []
        for row in self._camera.to_screen(frame.crossings):
            place = point_of(row)
            if all((place - other).manhattanLength() > 14 for other in marked):
                marked.append(place)
                cross_at(self._painter, place, QColor(self._theme.refused), 4.5)
