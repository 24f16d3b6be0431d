"""One frame of a blend as a panel shows it."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter

from app.compute import Result
from app.view.painting.camera import Camera
from app.view.painting.display import Layers
from app.view.painting.drawing import faded, pen, point_of, ring_of
from app.view.painting.frame_layers import paint_numbers, paint_way
from app.view.painting.parts import colour_of, paint_region, regions
from app.view.painting.pins import cross_at
from app.view.painting.structure import StructurePainter, shown_structures
from app.view.painting.theme import Theme
from app.view.wording import verdicts
from starskel import Correspondence
from starskel.arrays import Floats
from starskel.crossings import crossing_places
from starskel.sheet.style import USUAL_PART, PartLook

STALE = 0.55
"""Opacity of a frame whose shapes have changed since."""


class FramePainter:
    """Paints the frame of a blend at one t."""

    def __init__(self, painter: QPainter, theme: Theme, camera: Camera, layers: Layers) -> None:
        self._painter = painter
        self._theme = theme
        self._camera = camera
        self._layers = layers

    def paint(
        self, result: Result, t: float, looks: Sequence[PartLook], *, stale: bool, pictured: bool = False
    ) -> None:
        """Paint fill or star pieces, outline, skeleton, and the places where the frame crosses itself.

        Where there are pictures inside, neither fill nor outline is painted over them.
        """
        crossing = verdicts.crossing_rings(result.report, t)
        self._painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._painter.setOpacity(STALE if stale else 1.0)
        rings = result.rings_at(t)
        looks = [*looks, *[USUAL_PART] * (len(rings) - len(looks))]  # a blend out of date may have more parts
        shown = [look.visible for look in looks[: len(rings)]]
        cut = StructurePainter(self._painter, self._theme, self._camera, self._layers)
        wanted = self._layers.pieces or self._layers.skeleton
        structures = shown_structures(result, t, shown) if wanted else ()
        in_pieces = {each.number for each in structures} if self._layers.pieces else set()
        if not pictured:
            self._fill(result, rings, t, looks, [see and k not in in_pieces for k, see in enumerate(shown)])
        cut.paint_pieces(structures)
        for number, ring in enumerate(rings):
            if shown[number] and (number in crossing or not pictured):
                usual = colour_of(looks[number], self._theme, t)
                self._outline(ring, QColor(self._theme.refused) if number in crossing else usual)
        cut.paint_skeletons(result, structures, t)
        for number, ring in enumerate(rings):
            if self._layers.numbers and shown[number]:
                self._paint_numbers(result.pairs[number], ring)
            if number in crossing:
                self._paint_crossings(ring)
        self._painter.setOpacity(1.0)

    def paint_ground(self, result: Result, t: float, looks: Sequence[PartLook]) -> None:
        """Paint the outlines that lie under pictures inside: they are seen where a picture does not reach."""
        self._painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for ring, look in zip(result.rings_at(t), looks, strict=False):  # looks may be those of newer parts
            if look.visible:
                self._outline(ring, colour_of(look, self._theme, t))

    def paint_trace(self, result: Result, t: float, link: int, row: int) -> None:
        """Paint one vertex of a link and its way through time."""
        paint_way(self._painter, self._theme, self._camera.to_screen(result.samples[link][:, row]))
        self._painter.setPen(pen(self._theme.base, 1.5))
        self._painter.setBrush(QColor(self._theme.accent))
        place = self._camera.to_screen(result.rings_at(t)[link][row])
        self._painter.drawEllipse(point_of(place), 5.5, 5.5)

    def _paint_numbers(self, pair: Correspondence, frame: Floats) -> None:
        """Give the vertices the numbers of the source's; those that were inserted there have none."""
        numbers = [str(number) if number >= 0 else "" for number in pair.source_vertices.tolist()]
        paint_numbers(self._painter, self._theme, self._camera.to_screen(frame), numbers)

    def _fill(
        self, result: Result, rings: list[Floats], t: float, looks: Sequence[PartLook], shown: Sequence[bool]
    ) -> None:
        self._painter.setPen(Qt.PenStyle.NoPen)
        for outline, holes in regions(result.outer, shown):
            self._painter.setBrush(faded(colour_of(looks[outline], self._theme, t), 0.35))
            around, *inside = (self._camera.to_screen(rings[k]) for k in (outline, *holes))
            paint_region(self._painter, around, inside)

    def _outline(self, ring: Floats, colour: QColor) -> None:
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        # one pixel wide; wider, a smooth line takes ten times as long, each frame
        self._painter.setPen(pen(colour, 0.0))
        self._painter.drawPolygon(ring_of(self._camera.to_screen(ring)))

    def _paint_crossings(self, ring: Floats) -> None:
        """Mark where a ring crosses itself, once for places that would fall on each other."""
        marked: list[QPointF] = []
        for row in self._camera.to_screen(crossing_places(ring)):
            place = point_of(row)
            if all((place - other).manhattanLength() > 14 for other in marked):
                marked.append(place)
                cross_at(self._painter, place, QColor(self._theme.refused), 4.5)
