"""Star pieces and skeletons, on the canvases and in the frames."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter

from app.compute import STEERED, Result
from app.model.marks import Side
from app.view.painting.camera import Camera
from app.view.painting.display import Layers
from app.view.painting.drawing import faded, lines_of, pen, point_of, polygon_of
from app.view.painting.theme import Theme
from starskel.blending.pieces import PieceBlend
from starskel.decomposition.pieces import Decomposition
from starskel.predicates import Floats
from starskel.skeleton import Skeleton


def paint_cut(  # noqa: PLR0913, PLR0917 -- what is painted, and where
    painter: QPainter,
    theme: Theme,
    camera: Camera,
    results: Sequence[Result],
    side: Side,
    layers: Layers,
) -> None:
    """Paint star pieces and skeleton on a shape; the skeleton is the star-skeleton's, where that is shown."""
    in_turn = sorted(results, key=lambda result: result.method != STEERED)
    result = next((each for each in in_turn if isinstance(each.blend, PieceBlend)), None)
    if result is None or not isinstance(result.blend, PieceBlend):
        return
    cut, source = result.blend.decomposition, side == "source"
    rows, origins = (cut.source, cut.source_origins) if source else (cut.target, cut.target_origins)
    if layers.pieces:
        paint_pieces(painter, theme, cut, camera.to_screen(rows))
    if layers.skeleton:
        skeleton = result.blend.skeleton
        places = camera.to_screen(skeleton.points(rows, origins))
        paint_skeleton(painter, theme, skeleton, places, root=result.method == STEERED)


def paint_pieces(painter: QPainter, theme: Theme, cut: Decomposition, points: Floats) -> None:
    """Paint star pieces whose points have these places on the screen, each in its colour."""
    painter.setPen(pen(faded(theme.text, 0.45), 1.0))
    for number, piece in enumerate(cut.pieces):
        painter.setBrush(QColor(theme.pieces[number % len(theme.pieces)]))
        painter.drawPolygon(polygon_of(points[list(piece)]), Qt.FillRule.WindingFill)


def paint_skeleton(
    painter: QPainter, theme: Theme, skeleton: Skeleton, points: Floats, *, root: bool
) -> None:
    """Paint arcs; origins as discs, mid-points as small squares; a ring round the root, where it matters."""
    colour = QColor(theme.text)
    starts, ends = skeleton.arcs.T
    painter.setPen(pen(colour, 2.0))
    painter.drawLines(lines_of(points[starts], points[ends]))
    origins, middles = np.split(points, [len(skeleton.parents)])
    _paint_dots(painter, origins, colour, 6.4, Qt.PenCapStyle.RoundCap)
    _paint_dots(painter, middles, colour, 5.6, Qt.PenCapStyle.SquareCap)
    _paint_dots(painter, middles, QColor(theme.base), 3.2, Qt.PenCapStyle.SquareCap)
    if not root:
        return
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(pen(theme.accent, 2.2))
    painter.drawEllipse(point_of(points[skeleton.root]), 7.0, 7.0)


def paint_tree(painter: QPainter, theme: Theme, links: Floats) -> None:
    """Paint a meta-skeleton: links between the roots of parts, (k, 2, 2), on the screen."""
    colour = QColor(theme.text)
    painter.setPen(pen(colour, 2.0))
    painter.drawLines(lines_of(links[:, 0], links[:, 1]))
    _paint_dots(painter, links.reshape(-1, 2), colour, 6.4, Qt.PenCapStyle.RoundCap)


def _paint_dots(painter: QPainter, places: Floats, colour: QColor, size: float, cap: Qt.PenCapStyle) -> None:
    """Paint dots in the shape of a pen's end, all at once: there may be hundreds in each frame."""
    dots = pen(colour, size)
    dots.setCapStyle(cap)
    painter.setPen(dots)
    painter.drawPoints(polygon_of(places))
