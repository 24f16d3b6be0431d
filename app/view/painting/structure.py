"""Star pieces and skeletons, on the canvases and in the frames."""

from collections.abc import Sequence
from itertools import cycle

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter

from app.compute import STEERED, Result
from app.model.marks import Side
from app.view.painting.camera import Camera
from app.view.painting.display import Layers
from app.view.painting.drawing import faded, lines_of, pen, point_of, polygon_of
from app.view.painting.theme import Theme
from starskel.arrays import Floats
from starskel.shapes.structure import Structure, structures_at, tree_at
from starskel.skeleton import Skeleton


class StructurePainter:
    """Paints how shapes are cut, as far as the layers ask for it."""

    def __init__(self, painter: QPainter, theme: Theme, camera: Camera, layers: Layers) -> None:
        self._painter = painter
        self._theme = theme
        self._camera = camera
        self._layers = layers

    def paint_cut(self, results: Sequence[Result], side: Side, shown: Sequence[bool]) -> None:
        """Paint star pieces and skeletons on a shape; these are the star-skeleton's, where that is shown.

        `shown` tells for each link whether its part is to be seen.
        """
        if not (self._layers.pieces or self._layers.skeleton):
            return
        t = 0.0 if side == "source" else 1.0
        for result in sorted(results, key=lambda result: result.method != STEERED):
            if structures := shown_structures(result, t, shown):
                self.paint_pieces(structures)
                self.paint_skeletons(result, structures, t)
                return

    def paint_pieces(self, structures: Sequence[Structure]) -> None:
        """Paint the star pieces of all parts, each in its colour."""
        if not self._layers.pieces:
            return
        self._painter.setPen(pen(faded(self._theme.text, 0.45), 1.0))
        colours = cycle(self._theme.pieces)
        for structure in structures:
            points = self._camera.to_screen(structure.points)
            for piece in structure.blend.decomposition.pieces:
                self._painter.setBrush(QColor(next(colours)))
                self._painter.drawPolygon(polygon_of(points[list(piece)]), Qt.FillRule.WindingFill)

    def paint_skeletons(self, result: Result, structures: Sequence[Structure], t: float) -> None:
        """Paint the skeletons of all parts, and under them the meta-skeleton that joins them."""
        if not self._layers.skeleton:
            return
        if len(tree := tree_at(result.blend, t)):
            self._paint_tree(tree)
        for structure in structures:
            places = self._camera.to_screen(structure.skeleton)
            self._paint_skeleton(structure.blend.skeleton, places, root=result.method == STEERED)

    def _paint_skeleton(self, skeleton: Skeleton, points: Floats, *, root: bool) -> None:
        """Paint arcs; origins as discs, mid-points as squares; a ring round the root, where it matters."""
        colour, ground = QColor(self._theme.text), QColor(self._theme.base)
        starts, ends = skeleton.arcs.T
        self._painter.setPen(pen(colour, 2.0))
        self._painter.drawLines(lines_of(points[starts], points[ends]))
        origins, middles = np.split(points, [len(skeleton.parents)])
        self._paint_dots(origins, colour, 6.4, Qt.PenCapStyle.RoundCap)
        self._paint_dots(middles, colour, 5.6, Qt.PenCapStyle.SquareCap)
        self._paint_dots(middles, ground, 3.2, Qt.PenCapStyle.SquareCap)
        if root:
            self._painter.setBrush(Qt.BrushStyle.NoBrush)
            self._painter.setPen(pen(self._theme.accent, 2.2))
            self._painter.drawEllipse(point_of(points[skeleton.root]), 7.0, 7.0)

    def _paint_tree(self, links: Floats) -> None:
        """Paint a meta-skeleton, dashed: links between the roots of parts, (k, 2, 2)."""
        places, colour = self._camera.to_screen(links), QColor(self._theme.text)
        self._painter.setPen(pen(colour, 2.0, Qt.PenStyle.DashLine))
        self._painter.drawLines(lines_of(places[:, 0], places[:, 1]))
        self._paint_dots(places.reshape(-1, 2), colour, 6.4, Qt.PenCapStyle.RoundCap)

    def _paint_dots(self, places: Floats, colour: QColor, size: float, cap: Qt.PenCapStyle) -> None:
        """Paint dots in the shape of a pen's end, all at once: there may be hundreds in each frame."""
        dots = pen(colour, size)
        dots.setCapStyle(cap)
        self._painter.setPen(dots)
        self._painter.drawPoints(polygon_of(places))


def shown_structures(result: Result, t: float, shown: Sequence[bool]) -> tuple[Structure, ...]:
    """Give the star pieces and skeletons at t of the parts that are to be seen."""
    return tuple(each for each in structures_at(result.blend, t) if shown[each.number])
