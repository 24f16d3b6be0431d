"""Icons drawn as strokes in the colour of the writing: they follow the theme and stay sharp."""

from math import cos, pi, sin

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPainterPath, QPalette, QPen, QPixmap, QPolygonF

SIZE = 24
"""The drawings below are made in a box of so many units, y down."""

_LINES: dict[str, tuple[tuple[tuple[float, float], ...], ...]] = {
    "new": (((6, 3), (14, 3), (19, 8), (19, 21), (6, 21), (6, 3)), ((14, 3), (14, 8), (19, 8))),
    "open": (
        ((3, 19), (3, 5), (9, 5), (11, 8), (20, 8), (20, 11)),
        ((3, 19), (7, 11), (22, 11), (18, 19), (3, 19)),
    ),
    "save": (
        ((4, 4), (17, 4), (20, 7), (20, 20), (4, 20), (4, 4)),
        ((8, 4), (8, 9), (15, 9), (15, 4)),
        ((7, 20), (7, 13), (17, 13), (17, 20)),
    ),
    "shape-add": (((3, 7), (13, 7), (13, 17), (3, 17), (3, 7)), ((19, 8), (19, 16)), ((15, 12), (23, 12))),
    "shape-duplicate": (
        ((4, 8), (14, 8), (14, 20), (4, 20), (4, 8)),
        ((9, 8), (9, 4), (20, 4), (20, 15), (14, 15)),
    ),
    "shape-delete": (
        ((4, 6), (20, 6)),
        ((9, 6), (10, 3), (14, 3), (15, 6)),
        ((6, 6), (7, 21), (17, 21), (18, 6)),
    ),
    "shape-earlier": (
        ((12, 7), (21, 7), (21, 17), (12, 17), (12, 7)),
        ((9, 12), (2, 12)),
        ((5, 9), (2, 12), (5, 15)),
    ),
    "shape-later": (
        ((3, 7), (12, 7), (12, 17), (3, 17), (3, 7)),
        ((15, 12), (22, 12)),
        ((19, 9), (22, 12), (19, 15)),
    ),
    "part-add": (
        tuple((9 + 6 * cos(k * pi / 12), 9 + 6 * sin(k * pi / 12)) for k in range(25)),
        ((18, 13), (18, 21)),
        ((14, 17), (22, 17)),
    ),
    "part-remove": (
        tuple((9 + 6 * cos(k * pi / 12), 9 + 6 * sin(k * pi / 12)) for k in range(25)),
        ((14, 17), (22, 17)),
    ),
    "part-forward": (((5, 14), (5, 20), (19, 20), (19, 14)), ((12, 16), (12, 4)), ((8, 8), (12, 4), (16, 8))),
    "part-backward": (
        ((5, 10), (5, 4), (19, 4), (19, 10)),
        ((12, 8), (12, 20)),
        ((8, 16), (12, 20), (16, 16)),
    ),
    "part-colour": (
        ((12, 3), (17, 10), (18, 14), (16.5, 18), (12, 20), (7.5, 18), (6, 14), (7, 10), (12, 3)),
        ((9, 14), (10, 16.2), (12, 17)),
    ),
    "suggest-pairing": (
        tuple((6 + 3.5 * cos(k * pi / 8), 17 + 3.5 * sin(k * pi / 8)) for k in range(17)),
        tuple((18 + 3.5 * cos(k * pi / 8), 17 + 3.5 * sin(k * pi / 8)) for k in range(17)),
        ((9.5, 17), (14.5, 17)),
        ((12, 2), (12, 10)),
        ((8, 6), (16, 6)),
    ),
    "parts": (
        ((4, 4), (20, 4), (20, 20), (4, 20), (4, 4)),
        ((11, 8), (17, 8)),
        ((11, 12), (17, 12)),
        ((11, 16), (17, 16)),
    ),
    "undo": (
        ((8, 4), (3, 9), (8, 14)),
        ((3, 9), (14, 9), (18, 10.5), (20, 14), (18, 17.5), (14, 19), (9, 19)),
    ),
    "redo": (
        ((16, 4), (21, 9), (16, 14)),
        ((21, 9), (10, 9), (6, 10.5), (4, 14), (6, 17.5), (10, 19), (15, 19)),
    ),
    "select": (((6, 3), (6, 18), (10, 14.2), (13, 21), (15.6, 19.8), (12.7, 13.2), (18, 13), (6, 3)),),
    "draw": (((4, 17), (8, 5), (19, 8), (16, 19), (4, 17)),),
    "freehand": (
        (
            *((4, 14), (4.6, 9), (7, 5.5), (10, 4.6), (13, 6), (15.5, 8.4), (18.5, 9), (20.4, 11.5)),
            *((19.6, 15.6), (16, 18.4), (11.5, 19.4), (7, 18.4), (4, 14)),
        ),
    ),
    "rectangle": (((4, 6), (20, 6), (20, 18), (4, 18), (4, 6)),),
    "ellipse": (tuple((12 + 9 * cos(k * pi / 16), 12 + 6.5 * sin(k * pi / 16)) for k in range(33)),),
    "regular-polygon": (tuple((12 + 9 * sin(k * pi / 3), 12 - 9 * cos(k * pi / 3)) for k in range(7)),),
    "star": (
        tuple(
            (12 + (4.2 if k % 2 else 9.5) * sin(k * pi / 5), 12.6 - (4.2 if k % 2 else 9.5) * cos(k * pi / 5))
            for k in range(11)
        ),
    ),
    "text": (((5, 7), (5, 4), (19, 4), (19, 7)), ((12, 4), (12, 20)), ((9, 20), (15, 20))),
    "picture": (
        ((3, 5), (21, 5), (21, 19), (3, 19), (3, 5)),
        ((3, 16), (9, 10), (14, 15), (17, 12.5), (21, 16)),
    ),
    "picture-open": (
        ((3, 19), (3, 5), (9, 5), (11, 8), (20, 8), (20, 11)),
        ((3, 19), (7, 11), (22, 11), (18, 19), (3, 19)),
    ),
    "picture-lock": (
        ((5, 11), (19, 11), (19, 21), (5, 21), (5, 11)),
        ((8, 11), (8, 7), (9.2, 4.2), (12, 3), (14.8, 4.2), (16, 7), (16, 11)),
    ),
    "picture-trace": (
        ((4, 18), (3, 11), (7, 5), (13, 4), (19, 8)),
        ((20, 11), (21, 14), (17, 20), (9, 21), (6, 19.5)),
        ((10, 10), (14, 14)),
        ((14, 10), (10, 14)),
    ),
    "picture-crop": (
        ((7, 2), (7, 17), (22, 17)),
        ((2, 7), (17, 7), (17, 22)),
    ),
    "picture-remove": (
        ((5, 7), (19, 7)),
        ((9, 7), (9, 4), (15, 4), (15, 7)),
        ((7, 7), (8, 21), (16, 21), (17, 7)),
    ),
    "snap-vertices": (
        ((4, 20), (12, 8), (20, 20)),
        ((8.5, 4.5), (15.5, 4.5), (15.5, 11.5), (8.5, 11.5), (8.5, 4.5)),
    ),
    "snap-edges": (((3, 19), (21, 7)), ((10, 5), (10, 11)), ((7.5, 8.6), (10, 11.4), (12.5, 8.6))),
    "snap-angles": (
        ((4, 19), (20, 19)),
        ((4, 19), (17, 6)),
        tuple((4 + 11 * cos(k * pi / 24), 19 - 11 * sin(k * pi / 24)) for k in range(7)),
    ),
    "snap-grid": tuple(line for k in (4, 9.33, 14.67, 20) for line in (((k, 4), (k, 20)), ((4, k), (20, k)))),
    "mark": (
        ((7, 20), (7, 12)),
        ((17, 20), (17, 12)),
        ((4, 5), (10, 5), (10, 11), (7, 13), (4, 11), (4, 5)),
        ((14, 5), (20, 5), (20, 11), (17, 13), (14, 11), (14, 5)),
    ),
    "suggest": (
        ((7, 21), (7, 14)),
        ((4, 8), (10, 8), (10, 13), (7, 15), (4, 13), (4, 8)),
        ((17, 3), (17, 11)),
        ((13, 7), (21, 7)),
        ((14.5, 4.5), (19.5, 9.5)),
        ((19.5, 4.5), (14.5, 9.5)),
    ),
    "marks": (
        ((4, 5), (20, 5), (20, 19), (4, 19), (4, 5)),
        ((4, 10), (20, 10)),
        ((4, 14.5), (20, 14.5)),
        ((10, 5), (10, 19)),
    ),
    "fit": (
        ((4, 9), (4, 4), (9, 4)),
        ((15, 4), (20, 4), (20, 9)),
        ((20, 15), (20, 20), (15, 20)),
        ((9, 20), (4, 20), (4, 15)),
        ((9, 9), (15, 9), (15, 15), (9, 15), (9, 9)),
    ),
    "pieces": (
        ((3, 8), (12, 3), (21, 9), (18, 20), (6, 20), (3, 8)),
        ((12, 3), (10, 20)),
        ((11, 11), (21, 9)),
    ),
    "skeleton": (((4, 19), (9, 12), (15, 12), (20, 5)), ((9, 12), (6, 5)), ((15, 12), (19, 19))),
    "export": (
        ((12, 3), (12, 15)),
        ((7.5, 7.5), (12, 3), (16.5, 7.5)),
        ((4, 13), (4, 20), (20, 20), (20, 13)),
    ),
}

_DOTS: dict[str, tuple[tuple[float, float], ...]] = {
    "parts": ((7.5, 8), (7.5, 12), (7.5, 16)),
    "draw": ((4, 17), (8, 5), (19, 8), (16, 19)),
    "picture": ((16.5, 9),),
    "skeleton": ((4, 19), (9, 12), (15, 12), (20, 5), (6, 5), (19, 19)),
}

_SOLID: dict[str, tuple[tuple[tuple[float, float], ...], ...]] = {
    "play": (((6, 3.5), (20, 12), (6, 20.5)),),
    "pause": (((6, 4), (10, 4), (10, 20), (6, 20)), ((14, 4), (18, 4), (18, 20), (14, 20))),
    "to-start": (((4, 4), (7, 4), (7, 20), (4, 20)), ((20, 4), (20, 20), (8.5, 12))),
    "step-back": (((17, 4), (17, 20), (7, 12)), ((5, 4), (7, 4), (7, 20), (5, 20))),
    "step-forward": (((7, 4), (7, 20), (17, 12)), ((17, 4), (19, 4), (19, 20), (17, 20))),
    "to-end": (((17, 4), (20, 4), (20, 20), (17, 20)), ((4, 4), (4, 20), (15.5, 12))),
}


def icon(name: str, palette: QPalette) -> QIcon:
    """Give an icon in the palette's colours, an empty one where none is drawn for the name."""
    result = QIcon()
    if name not in _LINES and name not in _SOLID:
        return result
    for mode, group in (
        (QIcon.Mode.Normal, QPalette.ColorGroup.Active),
        (QIcon.Mode.Disabled, QPalette.ColorGroup.Disabled),
    ):
        colour = palette.color(group, QPalette.ColorRole.ButtonText)
        for ratio in (1.0, 2.0):
            result.addPixmap(_pixmap(name, colour, ratio), mode)
    return result


def swatch(colour: QColor, size: QSize) -> QIcon:
    """Give an icon of nothing but a colour."""
    pixmap = QPixmap(size)
    pixmap.fill(colour)
    return QIcon(pixmap)


def _pixmap(name: str, colour: QColor, ratio: float) -> QPixmap:
    pixmap = QPixmap(round(SIZE * ratio), round(SIZE * ratio))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    _paint(painter, name, colour)
    painter.end()
    return pixmap


def _paint(painter: QPainter, name: str, colour: QColor) -> None:
    painter.setPen(
        QPen(colour, 1.6, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin)
    )
    for line in _LINES.get(name, ()):
        painter.drawPolyline(QPolygonF([QPointF(x, y) for x, y in line]))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour)
    for x, y in _DOTS.get(name, ()):
        painter.drawEllipse(QRectF(x - 2.2, y - 2.2, 4.4, 4.4))
    for ring in _SOLID.get(name, ()):
        path = QPainterPath()
        path.addPolygon(QPolygonF([QPointF(x, y) for x, y in ring]))
        painter.drawPath(path)
