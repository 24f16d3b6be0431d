"""One keyframe on paper."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from starskel.predicates import Floats
from starskel.sheet import style
from starskel.sheet.drawing import Area, Disc, Item, Label, Line, Place, Stroke
from starskel.sheet.keyframe import Keyframe, PlacedSkeleton
from starskel.sheet.shape_keyframe import ShapeKeyframe


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


def cell(frame: Keyframe | ShapeKeyframe, on_paper: Placement) -> Iterator[Item]:
    """Give what is drawn of a keyframe: fill or star pieces, outline, skeleton, crossings, pins."""
    if isinstance(frame, ShapeKeyframe):
        yield from _shape(frame, on_paper)
        return
    ring = on_paper(frame.ring)
    if frame.pieces:
        yield from _pieces([on_paper(piece) for piece in frame.pieces])
        yield Area(ring, stroke=_outline(frame))
    else:
        yield Area(ring, style.fill(frame.t), _outline(frame))
    if frame.skeleton is not None:
        yield from _skeleton(frame.skeleton, on_paper)
    yield from _crossings(on_paper(frame.crossings))
    yield from _pins(ring, frame.marks)


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


def _shape(frame: ShapeKeyframe, on_paper: Placement) -> Iterator[Item]:
    """Draw each part as one path with its holes, then the meta-skeleton: roots joined by links."""
    for outline, *holes in frame.parts:
        rings = tuple(on_paper(hole) for hole in holes)
        yield Area(on_paper(outline), style.fill(frame.t), _outline(frame), rings)
    for link in frame.tree:
        yield Line(on_paper(link), style.SKELETON_LINE)
    for x, y in on_paper(np.unique(frame.tree.reshape(-1, 2), axis=0)).tolist():
        yield Disc((x, y), 1.5, style.SKELETON)
    yield from _crossings(on_paper(frame.crossings))


def _outline(frame: Keyframe | ShapeKeyframe) -> Stroke:
    return style.OUTLINE if frame.simple else style.CROSSING_OUTLINE


def _pieces(rings: list[Floats]) -> Iterator[Item]:
    for number, ring in enumerate(rings):
        yield Area(ring, style.PIECES[number % len(style.PIECES)], style.PIECE_OUTLINE)


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


def _pins(ring: Floats, marks: tuple[int, ...]) -> Iterator[Item]:
    for number, row in enumerate(marks, 1):
        x, y = ring[row].tolist()
        yield Disc((x, y), 0.75 * style.PIN_SIZE, style.INK)
        yield Label(
            str(number), (x, y - 0.35 * style.PIN_SIZE), style.PIN_SIZE, style.PAPER, "middle", bold=True
        )
