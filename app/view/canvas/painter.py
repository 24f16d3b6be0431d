"""What a canvas shows: the shape, its vertices and pins, the gesture under way, and what was refused."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPalette

from app.model.clipping import chosen_parts
from app.model.document import Point
from app.model.marks import Side, end, mark_at
from app.model.parts import stacked
from app.session import Session
from app.tools.tool import Overlay, as_point
from app.view.canvas.backdrop import paint_backdrop
from app.view.canvas.gesture import GesturePainter, square
from app.view.canvas.notes import (
    Shown,
    how_to_draw,
    paint_caption,
    paint_invitation,
    paint_line,
    paint_news,
    paint_notice,
)
from app.view.painting.camera import Camera
from app.view.painting.display import Layers
from app.view.painting.drawing import faded, lines_of, pen, point_of, polygon_of
from app.view.painting.frame_layers import paint_numbers, paint_way
from app.view.painting.parts import looks_of, paint_region, regions
from app.view.painting.pins import Pin, cross_at, outward, paint_pins
from app.view.painting.structure import StructurePainter
from app.view.painting.theme import theme_of
from app.view.wording import words
from app.view.wording.counts import COUNTS
from starskel.files.key_shape import Part
from starskel.predicates import Floats

CROWDED = 7.0
"""Vertices nearer to each other than so many pixels, on average, are not shown one by one."""

DIAMOND = (QPointF(0, -8), QPointF(8, 0), QPointF(0, 8), QPointF(-8, 0))


MANY = 30
"""Selected vertices are drawn smaller from so many on."""

CLOSEST = 8.0
"""Lines of the grid are no nearer to each other than so many pixels."""


class CanvasPainter:
    """Paints one canvas once."""

    def __init__(  # noqa: PLR0913 -- all that a canvas consists of
        self,
        painter: QPainter,
        palette: QPalette,
        camera: Camera,
        *,
        session: Session,
        side: Side,
        layers: Layers,
    ) -> None:
        self._painter = painter
        self._theme = theme_of(palette)
        self._camera = camera
        self._session = session
        self._layers = layers
        self._side: Side = side
        self._overlay: Overlay = session.overlay(side)
        part = session.document.part(side)
        own = "" if part is None else session.document.shape(side).parts[part].colour
        self._colour = QColor(own or self._theme.side(side))
        stored = session.document.vertices(side)
        self._ring: Floats = stored if self._overlay.ring is None else self._overlay.ring
        self._screen = camera.to_screen(self._ring)

    def paint(self) -> None:
        """Paint everything, from the ground up."""
        self._painter.fillRect(self._frame(), QColor(self._theme.base))
        self._paint_backdrop()
        self._paint_grid()
        self._painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_shape()
        self._paint_structure()
        self._paint_vertices()
        self._paint_numbers()
        labels = self._paint_pins()
        self._paint_growth()
        self._paint_trace()
        self._paint_selection()
        GesturePainter(self._painter, self._theme, self._camera, self._colour).paint(self._overlay)
        self._paint_words()
        self._paint_refusal(labels)
        if self._session.lost and self._side == self._session.selection.side:
            text = COUNTS.lost_marks(self._session.lost)
            shape = [point_of(place) for place in self._screen[:: len(self._screen) // MANY + 1]]
            paint_news(self._painter, self._theme, self._frame(), text, shape)

    def _frame(self) -> QRectF:
        return QRectF(0, 0, self._camera.width, self._camera.height)

    def _paint_backdrop(self) -> None:
        picture = self._overlay.picture or self._session.document.picture(self._side)
        if picture is None:
            return
        rings = [
            self._camera.to_screen(ring.vertices) for ring in self._session.document.shape(self._side).rings
        ]
        if (part := self._session.document.part(self._side)) is not None:
            rings[part] = self._screen
        paint_backdrop(self._painter, self._camera, picture, rings, faintly=self._overlay.handles)

    def _paint_grid(self) -> None:
        """Show the grid where it catches the pointer; where its lines would run together, every fifth."""
        snapping = self._session.settings.snapping
        if not snapping.grid:
            return
        spacing = snapping.spacing
        while spacing * self._camera.scale < CLOSEST:
            spacing *= 5
        left, top = self._camera.to_document(0, 0)
        right, low = self._camera.to_document(self._camera.width, self._camera.height)
        across, upwards = (
            np.arange(np.ceil(a / spacing), b / spacing) * spacing for a, b in ((left, right), (low, top))
        )
        lines = [((x, low), (x, top)) for x in across] + [((left, y), (right, y)) for y in upwards]
        ends = self._camera.to_screen(np.array(lines).reshape(-1, 2, 2))
        self._painter.setPen(pen(faded(self._theme.edge, 0.6)))
        self._painter.drawLines(lines_of(ends[:, 0], ends[:, 1]))

    # the document

    def _paint_shape(self) -> None:
        document, worked_on = self._session.document, self._session.document.part(self._side)
        parts = document.shape(self._side).parts
        alone = len(parts) == (worked_on is not None)
        if not alone:
            self._paint_parts(parts, worked_on)
        if len(self._screen):
            replaced = self._is_replaced()
            width = 1.0 if self._crowded() else 1.5  # wider, 2,000 smooth edges take a hundred times as long
            self._painter.setPen(pen(faded(self._colour, 0.35 if replaced else 1.0), width))
            self._painter.setBrush(faded(self._colour, (0.07 if replaced else 0.22) if alone else 0.0))
            self._painter.drawPolygon(polygon_of(self._screen), Qt.FillRule.WindingFill)

    def _paint_parts(self, parts: Sequence[Part], worked_on: int | None) -> None:
        """Paint all parts that are shown, and the outlines of those that are not worked on."""
        shape = self._session.document.shape(self._side).shape
        rings = [self._camera.to_screen(part.ring.vertices) for part in parts]
        shown = [part.visible or number == worked_on for number, part in enumerate(parts)]
        if worked_on is not None:
            rings[worked_on] = self._screen
        order = stacked(self._session.document, self._side)
        for outline, holes in sorted(regions(shape.outer, shown), key=lambda region: order.index(region[0])):
            colour = QColor(parts[outline].colour or self._theme.side(self._side))
            self._painter.setPen(Qt.PenStyle.NoPen)
            self._painter.setBrush(faded(colour, 0.22 if worked_on in (outline, *holes) else 0.13))
            paint_region(self._painter, rings[outline], [rings[hole] for hole in holes])
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        selection = self._session.selection
        several = selection.side == self._side and bool(selection.links)
        chosen = chosen_parts(self._session.document, selection) if several else ()
        for number, ring in enumerate(rings):
            if shown[number] and number != worked_on:
                colour = QColor(parts[number].colour or self._theme.side(self._side))
                self._painter.setPen(pen(faded(colour, 0.7), 1.0))
                if number in chosen:
                    self._painter.setPen(pen(self._theme.accent, 2.5))
                self._painter.drawPolygon(polygon_of(ring))

    def _paint_structure(self) -> None:
        """Show how the shape is cut, where that is known of the shape as it is now."""
        if self._overlay.ring is None and not self._is_replaced():
            structure = StructurePainter(self._painter, self._theme, self._camera, self._layers)
            shown = [look.visible for look in looks_of(self._session.document)]
            structure.paint_cut(self._session.fresh_results, self._side, shown)

    def _paint_numbers(self) -> None:
        if self._layers.numbers:
            numbers = [str(number) for number in range(len(self._screen))]
            paint_numbers(self._painter, self._theme, self._screen, numbers)

    def _paint_vertices(self) -> None:
        if not len(self._screen) or self._is_replaced() or self._crowded():
            return
        self._painter.setPen(pen(self._colour, 1.5))
        self._painter.setBrush(QColor(self._theme.base))
        low, high = (-3.0, -3.0), (self._camera.width + 3, self._camera.height + 3)
        shown = ((self._screen >= low) & (self._screen <= high)).all(axis=1)
        for place in self._screen[shown]:
            self._painter.drawRect(square(place, 2.5))
        self._painter.setBrush(self._colour)  # filled: where the vertices begin to count
        self._painter.drawRect(square(self._screen[0], 2.5))

    def _is_replaced(self) -> bool:
        """Tell whether the gesture would put another shape in the place of this one."""
        return bool(self._overlay.path) or self._overlay.figure is not None

    def _crowded(self) -> bool:
        if len(self._screen) < 40:
            return False
        ways = np.diff(self._screen, axis=0, append=self._screen[:1])
        return float(np.hypot(*ways.T).mean()) < CROWDED

    def _paint_selection(self) -> None:
        """Show what is selected, and what a press would take; above the pins, which may stand there too."""
        selected = () if self._is_replaced() else self._session.selection.on(self._side)
        self._painter.setPen(pen(self._theme.base, 1.0))
        self._painter.setBrush(QColor(self._theme.accent))
        half = 4.5 if len(selected) < MANY else 3.0
        for vertex in selected:
            self._painter.drawRect(square(self._screen[vertex], half))
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._painter.setPen(pen(self._theme.accent, 2.0))
        if self._overlay.vertex is not None:
            self._painter.drawEllipse(point_of(self._screen[self._overlay.vertex]), 7.5, 7.5)
        if self._overlay.insertion is not None:
            place = point_of(self._camera.to_screen(np.array(self._overlay.insertion)))
            self._painter.drawLine(place - QPointF(4, 0), place + QPointF(4, 0))
            self._painter.drawLine(place - QPointF(0, 4), place + QPointF(0, 4))

    def _paint_pins(self) -> list[QRectF]:
        ends = {index: end(mark, self._side) for index, mark in enumerate(self._session.document.marks)}
        if self._overlay.pin is not None:
            vertex, index = self._overlay.pin
            ends[index] = vertex
        return paint_pins(self._painter, [self._pin(vertex, index) for index, vertex in ends.items()])

    def _pin(self, vertex: int, index: int) -> Pin:
        colour = self._theme.pins[index % len(self._theme.pins)]
        return Pin(self._screen[vertex], self._away(vertex), words.mark(index), colour)

    def _away(self, vertex: int) -> Floats:
        """Give the direction out of the shape on the screen, where y runs down."""
        direction: Floats = outward(self._ring, vertex) * (1, -1)
        return direction

    def _paint_growth(self) -> None:
        """Show where the part worked on grows from or shrinks to, if it has no partner here."""
        document, results = self._session.document, self._session.fresh_results
        if document.pair.ends == (None, None) or document.part(self._side) is not None:
            return
        place = document.pair.place
        if place is None and results:
            rings = results[0].rings_at(0.0 if self._side == "source" else 1.0)
            place = as_point(rings[document.link].mean(axis=0))
        if place is not None:
            middle = self._on_screen(place)
            self._painter.setPen(pen(self._theme.accent, 2.0))
            self._painter.setBrush(QColor(self._theme.base))
            self._painter.drawPolygon([middle + step for step in DIAMOND])
            self._painter.drawPoint(middle)
            self._painter.setPen(QColor(self._theme.text))
            self._painter.drawText(middle + QPointF(14, 4), words.growth(self._side))

    def _paint_trace(self) -> None:
        """Show the partner of the vertex pointed at, and the way from the one to the other."""
        trace, pointed = self._session.trace, self._session.pointed
        if trace is None or pointed is None:
            return
        way = self._session.fresh_results[0].samples[self._session.document.link][:, trace.row]
        paint_way(self._painter, self._theme, self._camera.to_screen(way))
        self._painter.setPen(pen(self._theme.accent, 2.5))
        self._painter.setBrush(QColor(self._theme.base))
        place = point_of(self._camera.to_screen(np.array(trace.place(self._side))))
        if trace.vertex(self._side) is None:  # it has no vertex here: the correspondence inserts one
            self._painter.drawPolygon([place + step for step in DIAMOND])
        else:
            self._painter.drawEllipse(place, 7.5, 7.5)

    # what was refused

    def _paint_refusal(self, labels: list[QRectF]) -> None:
        refusal = self._session.refusal
        if refusal is None:
            return
        ends = {end(mark, self._side) for mark in refusal.marks}
        vertices = sorted(vertex for vertex in ends if vertex < len(self._screen))
        for vertex in vertices:
            self._paint_refused_pin(vertex)
        if refusal.side != self._side and not refusal.marks:
            return
        red = QColor(self._theme.refused)
        self._painter.setPen(pen(red, 3.0))
        places = [self._on_screen(point) for segment in refusal.segments for point in segment]
        for start, stop in zip(places[::2], places[1::2], strict=True):
            self._painter.drawLine(start, stop)
        if refusal.place is not None:
            places.append(self._on_screen(refusal.place))
            cross_at(self._painter, places[-1], red)
        places += [point_of(self._screen[vertex]) for vertex in vertices]
        reason = words.reason(refusal.error, self._session.document)
        shown = Shown(places, labels, self._screen)
        paint_notice(self._painter, self._theme, self._frame(), reason, shown)

    def _on_screen(self, point: Point) -> QPointF:
        return point_of(self._camera.to_screen(np.array(point)))

    def _paint_refused_pin(self, vertex: int) -> None:
        """Ring the vertex in red; where the new mark has no pin yet, give it one without a number."""
        place = self._screen[vertex]
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._painter.setPen(pen(self._theme.refused, 3.0))
        self._painter.drawEllipse(point_of(place), 11.0, 11.0)
        begun = self._overlay.pin is not None and self._overlay.pin[0] == vertex
        if not begun and mark_at(self._session.document.marks, self._side, vertex) is None:
            paint_pins(self._painter, [Pin(place, self._away(vertex), "✕", self._theme.refused)])

    # words

    def _paint_words(self) -> None:
        document = self._session.document
        name = words.canvas(document, self._side)
        part, shape = document.part(self._side), document.shape(self._side)
        if len(shape) > 1 and part is not None:
            name = f"{name} \N{MIDDLE DOT} {words.part(shape.parts[part], part)}"
        paint_caption(self._painter, self._theme, self._side, name, len(self._ring))
        begun = self._is_replaced() or self._overlay.trail is not None
        if shape.parts and document.pair.ends == (None, None) and not begun:
            paint_line(self._painter, self._theme, self._frame(), words.new_part(self._side))
        elif not shape.parts and not begun:
            how = how_to_draw(self._session.tool)
            heading = words.invitation(document, self._side)
            paint_invitation(self._painter, self._theme, self._frame(), heading, how)
