"""One frame of a blend as a panel shows it."""

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter

from app.compute import STEERED, Result
from app.view import verdicts
from app.view.camera import Camera
from app.view.display import Layers
from app.view.drawing import faded, pen, point_of, polygon_of
from app.view.frame_layers import paint_numbers, paint_way
from app.view.pins import cross_at
from app.view.structure import paint_pieces, paint_skeleton
from app.view.theme import Theme
from starskel.blending.frames import Blend
from starskel.blending.pieces import PieceBlend
from starskel.predicates import Floats
from starskel.sheet.keyframe import Keyframe

STALE = 0.55
"""Opacity of a frame whose shapes have changed since."""


class FramePainter:
    """Paints the frame of a blend at one t."""

    def __init__(self, painter: QPainter, theme: Theme, camera: Camera, layers: Layers) -> None:
        self._painter = painter
        self._theme = theme
        self._camera = camera
        self._layers = layers

    def paint(self, result: Result, t: float, *, stale: bool) -> None:
        """Paint fill or star pieces, outline, skeleton, and the places where the frame crosses itself."""
        blend, crosses = result.blend, verdicts.crosses_at(result.report, t)
        self._painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._painter.setOpacity(STALE if stale else 1.0)
        points = blend.points_at(t) if isinstance(blend, PieceBlend) else blend.at(t)
        frame = points[: len(blend.pair)]
        if isinstance(blend, PieceBlend) and self._layers.pieces:
            paint_pieces(self._painter, self._theme, blend.decomposition, self._camera.to_screen(points))
        else:
            self._fill(frame, t)
        self._outline(frame, t, crosses)
        if isinstance(blend, PieceBlend) and self._layers.skeleton:
            places = self._camera.to_screen(blend.skeleton_at(t))
            paint_skeleton(self._painter, self._theme, blend.skeleton, places, root=result.method == STEERED)
        if self._layers.numbers:
            self._paint_numbers(blend, frame)
        if crosses:
            self._paint_crossings(Keyframe(t, frame))
        self._painter.setOpacity(1.0)

    def paint_trace(self, result: Result, t: float, row: int) -> None:
        """Paint one vertex and its way through time."""
        paint_way(self._painter, self._theme, self._camera.to_screen(result.samples[:, row]))
        self._painter.setPen(pen(self._theme.base, 1.5))
        self._painter.setBrush(QColor(self._theme.accent))
        place = self._camera.to_screen(result.blend.at(t)[row])
        self._painter.drawEllipse(point_of(place), 5.5, 5.5)

    def _paint_numbers(self, blend: Blend, frame: Floats) -> None:
        """Give the vertices the numbers of the source's; those that were inserted there have none."""
        numbers = [str(number) if number >= 0 else "" for number in blend.pair.source_vertices.tolist()]
        paint_numbers(self._painter, self._theme, self._camera.to_screen(frame), numbers)

    def _fill(self, frame: Floats, t: float) -> None:
        self._painter.setPen(Qt.PenStyle.NoPen)
        self._painter.setBrush(faded(self._theme.between(t), 0.35))
        self._painter.drawPolygon(polygon_of(self._camera.to_screen(frame)), Qt.FillRule.WindingFill)

    def _outline(self, frame: Floats, t: float, crosses: bool) -> None:
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        colour = self._theme.refused if crosses else self._theme.between(t)
        # one pixel wide; wider, a smooth line takes ten times as long, each frame
        self._painter.setPen(pen(colour, 0.0))
        self._painter.drawPolygon(polygon_of(self._camera.to_screen(frame)))

    def _paint_crossings(self, frame: Keyframe) -> None:
        """Mark where the frame crosses itself, once for places that would fall on each other."""
        marked: list[QPointF] = []
        for row in self._camera.to_screen(frame.crossings):
            place = point_of(row)
            if all((place - other).manhattanLength() > 14 for other in marked):
                marked.append(place)
                cross_at(self._painter, place, QColor(self._theme.refused), 4.5)
