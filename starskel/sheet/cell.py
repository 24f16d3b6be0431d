"""One keyframe on paper."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats
from starskel.sheet import style
from starskel.sheet.drawing import Area, Disc, Image, Item, Label, Line, Painter, Place, Stroke
from starskel.sheet.keyframe import Keyframe, PlacedSkeleton
from starskel.sheet.style import USUAL, Look


@dataclass(frozen=True, eq=False)
class Placement:
    """Where the user's plane lies on the paper.

    Attributes
    ----------
    scale : float
        Points for one of the user's units.
    centre : (2,) array
        A point of the user's plane.
    place : (2,) array
        Where this point lies on the paper.
    """

    scale: float
    centre: Floats
    place: Floats

    def __call__(self, points: Floats) -> Floats:
        """Give points of the user's plane, in (k, 2) rows, on the paper."""
        return (points - self.centre) * self.scale + self.place

    def back(self, points: Floats) -> Floats:
        """Give (..., 2) points on the paper in the user's plane."""
        return (points - self.place) / self.scale + self.centre


def cell(frame: Keyframe, on_paper: Placement, look: Look = USUAL) -> Iterator[Item]:
    """Give what is drawn of a keyframe: fill or star pieces, outline, skeleton, crossings, vertices, pins."""
    if frame.picture is not None and np.ptp(frame.box, axis=0).all():
        yield _picture(frame.picture, on_paper, frame.box)
    yield from _parts(frame, on_paper, look)
    if look.signs:
        yield from _crossings(on_paper(frame.crossings))
    for x, y in on_paper(frame.vertices).tolist():
        yield Disc((x, y), style.VERTEX_SIZE, style.PAPER, style.VERTEX_OUTLINE)
    yield from _pins(on_paper(frame.pins))


def cross_sign(place: Place, radius: float) -> Iterator[Item]:
    """Give the sign of a shape that meets itself: a white cross on a disc."""
    yield Disc(place, radius, style.CROSSING)
    yield from _strokes(place, radius, [[(-0.42, -0.42), (0.42, 0.42)], [(-0.42, 0.42), (0.42, -0.42)]])


def layers_sign(place: Place, radius: float) -> Iterator[Item]:
    """Give the sign of a shape that meets itself, but only lies in layers: two white bars on a disc."""
    yield Disc(place, radius, style.NATURAL)
    yield from _strokes(place, radius, [[(-0.42, 0.22), (0.42, 0.22)], [(-0.42, -0.22), (0.42, -0.22)]])


def tick_sign(place: Place, radius: float) -> Iterator[Item]:
    """Give the sign of a shape that nowhere meets itself: a white tick on a disc."""
    yield Disc(place, radius, style.SIMPLE)
    yield from _strokes(place, radius, [[(-0.5, 0.0), (-0.12, -0.4), (0.5, 0.38)]])


def _strokes(place: Place, radius: float, lines: list[list[Place]]) -> Iterator[Item]:
    for line in lines:
        yield Line(np.array(place) + radius * np.array(line), Stroke(style.PAPER, 0.3 * radius))


def _parts(frame: Keyframe, on_paper: Placement, look: Look) -> Iterator[Item]:
    """Draw each part as one path with its holes, or by its star pieces, then all skeletons.

    Under the skeletons lies the meta-skeleton: roots joined by links.
    """
    filled, count = frame.picture is None, 0
    for part in frame.parts:
        ring, *holes = (on_paper(own) for own in part.rings)
        yield from _pieces([on_paper(piece) for piece in part.pieces], filled=filled, first=count)
        count += len(part.pieces)
        fill = part.own.fill(look, frame.t) if filled and not part.pieces else None
        yield Area(ring, fill, _outline(frame, look), tuple(holes))
    for link in frame.tree:
        yield Line(on_paper(link), style.SKELETON_LINE)
    for x, y in on_paper(frame.tree.reshape(-1, 2)).tolist():
        yield Disc((x, y), 1.5, style.SKELETON)
    for part in frame.parts:
        if part.skeleton is not None:
            yield from _skeleton(part.skeleton, on_paper)


def _outline(frame: Keyframe, look: Look) -> Stroke | None:
    if look.signs and not frame.simple:
        return style.CROSSING_OUTLINE
    return look.outline if frame.picture is None else None


def _picture(paint: Painter, on_paper: Placement, box: Floats) -> Image:
    return Image(on_paper(box), lambda seen, size: paint(on_paper.back(seen), size))


def _pieces(rings: list[Floats], *, filled: bool, first: int = 0) -> Iterator[Item]:
    """Draw star pieces, each in the next of the colours, counted from `first`."""
    for number, ring in enumerate(rings, first):
        fill = style.PIECES[number % len(style.PIECES)] if filled else None
        yield Area(ring, fill, style.PIECE_OUTLINE)


def _skeleton(skeleton: PlacedSkeleton, on_paper: Placement) -> Iterator[Item]:
    """Draw the arcs, the mid-points white and the star origins dark, as in the paper's figure 7."""
    for arc in skeleton.arcs:
        yield Line(on_paper(arc), style.SKELETON_LINE)
    for x, y in on_paper(skeleton.mid_points).tolist():
        yield Disc((x, y), 1.2, style.PAPER, style.JOINT_OUTLINE)
    for x, y in on_paper(skeleton.origins).tolist():
        yield Disc((x, y), 1.5, style.SKELETON)


def _crossings(places: Floats) -> Iterator[Item]:
    """Ring the places where the shape meets itself; one ring for those that lie close together."""
    radius = 4.0
    ringed: list[Place] = []
    for x, y in places.tolist():
        if all(np.hypot(x - a, y - b) > 1.5 * radius for a, b in ringed):
            ringed.append((x, y))
            yield Disc((x, y), radius, stroke=style.CROSSING_OUTLINE)


def _pins(places: Floats) -> Iterator[Item]:
    for number, (x, y) in enumerate(places.tolist(), 1):
        yield Disc((x, y), 0.75 * style.PIN_SIZE, style.INK)
        yield Label(
            str(number), (x, y - 0.35 * style.PIN_SIZE), style.PIN_SIZE, style.PAPER, "middle", bold=True
        )
