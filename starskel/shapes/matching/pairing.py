"""Which rings of two shapes become which: suggested, or given and checked."""

import operator
from collections.abc import Iterable, Sequence
from math import remainder, tau

import numpy as np
import shapely
from numpy.typing import NDArray

from starskel.arguments import items, refusal
from starskel.arrays import Floats
from starskel.errors import InvalidMarks, told
from starskel.predicates import DIGITS
from starskel.shapes.shape import Shape, ShapeLike

RingLink = tuple[int | None, int | None]
"""A ring of the source and a ring of the target; None where there is no partner."""

Polygons = NDArray[np.object_]

TURNS = np.linspace(-np.pi, np.pi, 25)[1:]
"""By how much the target is turned on trial, to find the partners in a turned copy."""

REFINEMENTS = 7
"""How often the steps are halved to say by how much the whole turns: to an eighth of a degree."""

TURNING_PRICE = 0.1
"""What half a turn costs for each ring: as much as a tenth of it that does not overlap."""


def suggest_pairing(source: ShapeLike, target: ShapeLike) -> list[RingLink]:
    """Propose which rings become which, from where they lie.

    Both shapes are laid on each other, middle on middle and in one size. Then parts are paired so that all
    together overlap most and differ least in size and place; a shape that is only turned is turned back for
    that, small turns before large ones. Holes are paired likewise within parts that are partners. Outlines
    become outlines, and holes holes. Where one shape has more of them than the other, those that fit worst
    have no partner: see `match` for what becomes of these. Exchanging the shapes gives the same pairs.

    Parameters
    ----------
    source, target : Shape, shapely Polygon or MultiPolygon, or iterable of rings

    Returns
    -------
    list of (int or None, int or None)
        Indices of rings as given, from 0, in the order of the source's, then those of the target alone.

    Raises
    ------
    InvalidPolygon
        Where the rings form no shape.

    Examples
    --------
    >>> import starskel
    >>> outline = [(0, 0), (8, 0), (8, 8), (0, 8)]
    >>> one = starskel.Shape([outline, [(2, 2), (6, 2), (6, 6), (2, 6)]])
    >>> two = starskel.Shape([outline, [(1, 1), (3, 1), (3, 3), (1, 3)], [(5, 5), (7, 5), (7, 7), (5, 7)]])
    >>> starskel.suggest_pairing(one, two)
    [(0, 0), (1, 1), (None, 2)]
    """
    shapes = Shape(source), Shape(target)
    outlines = _paired(shapes, shapes[0].outlines, shapes[1].outlines)
    links = [*outlines, *(hole for outline in outlines for hole in _holes(shapes, outline))]
    return sorted(links, key=_order)


def turn_between(source: Shape, target: Shape, pairing: Iterable[RingLink]) -> float:
    """Give by about how much the source turns as a whole; 0 for one ring, which tells by itself."""
    links = [(i, j) for i, j in pairing if i is not None and j is not None]
    if len(links) < 2:
        return 0.0
    sides = [[link[side] for link in links] for side in (0, 1)]
    around = [
        [k for k in own if shape.outer[k] < 0] or own
        for own, shape in zip(sides, (source, target), strict=True)
    ]
    first, second = _laid(source, sides[0], around[0]), _laid(target, sides[1], around[1])

    def cost(turn: float) -> tuple[float, float]:
        own = _costs(*_turned(first, second, turn))
        least = abs(remainder(turn, tau))
        price = TURNING_PRICE * len(links) * least / np.pi
        return round(float(own.sum()) + price, DIGITS), round(least, DIGITS)

    turn = float(min(TURNS.tolist(), key=cost))
    for halvings in range(1, REFINEMENTS + 1):
        step = float(TURNS[1] - TURNS[0]) / 2**halvings
        turn = min((turn, turn - step, turn + step), key=cost)
    return turn


def checked_pairing(source: Shape, target: Shape, pairing: Iterable[RingLink]) -> tuple[RingLink, ...]:
    """Give the links as given, when every ring is in one.

    Raises
    ------
    InvalidMarks
        Where a link names a ring that is not there, pairs an outline with a hole or stands twice, or a ring
        is in no link, or a hole in several.
    """
    links = tuple(_as_link(link) for link in items(pairing, "the pairing", _PAIRS, InvalidMarks))
    for side, shape in enumerate((source, target)):
        _check_named(side, shape, [ring for ring in (link[side] for link in links) if ring is not None])
    for i, j in links:
        if i is not None and j is not None and (source.outer[i] < 0) != (target.outer[j] < 0):
            raise InvalidMarks(
                told("rings {i} and {j} are paired, but one is an outline and the other a hole", i=i, j=j),
                told("pair outlines with outlines and holes with holes"),
            )
    twice = next((link for link in links if links.count(link) > 1), None)
    if twice is not None:
        raise InvalidMarks(f"the pairing has {twice} twice", "give it once")
    return links


def _check_named(side: int, shape: Shape, named: Sequence[int]) -> None:
    """Check that all rings of a shape are named, and no others, and holes once."""
    name = ("source", "target")[side]
    for ring in named:
        if not 0 <= ring < len(shape):
            raise InvalidMarks(
                f"the pairing names ring {ring} of the {name}, which has {len(shape)}",
                f"give one from 0 to {len(shape) - 1}",
            )
    _check_holes(name, shape, named)
    missing = sorted(set(range(len(shape))) - set(named))
    if missing:
        alone = (missing[0], None) if side == 0 else (None, missing[0])
        raise InvalidMarks(
            f"ring {missing[0]} of the {name} is in no pair",
            f"pair it, or say by {alone} that it {'closes to' if side == 0 else 'grows from'} a point",
        )


def _check_holes(name: str, shape: Shape, named: Sequence[int]) -> None:
    several = sorted({ring for ring in named if shape.outer[ring] >= 0 and named.count(ring) > 1})
    if several:
        raise InvalidMarks(
            f"ring {several[0]} of the {name}, a hole, is in several pairs: only outlines can be cut",
            "leave it in one of them",
        )


def _as_link(given: Iterable[int | None]) -> RingLink:
    try:
        i, j = (None if ring is None else operator.index(ring) for ring in given)
    except (TypeError, ValueError):
        i, j = None, None
    if i is None and j is None:
        raise refusal(given, "a pair of rings", _PAIRS, InvalidMarks)
    return i, j


_PAIRS = "give pairs (ring of the source, ring of the target), or None for one of them"


def _holes(shapes: tuple[Shape, Shape], outline: RingLink) -> list[RingLink]:
    """Pair the holes of a part, the outlines laid on each other."""
    first, second = (() if k is None else shape.holes(k) for shape, k in zip(shapes, outline, strict=True))
    return _paired(shapes, first, second, outline)


def _paired(
    shapes: tuple[Shape, Shape], first: Sequence[int], second: Sequence[int], around: RingLink | None = None
) -> list[RingLink]:
    """Pair some rings of both shapes, those around them laid on each other, or else all these themselves."""
    if not first or not second:
        return [*((i, None) for i in first), *((None, j) for j in second)]
    sides = (first, second) if around is None else tuple((ring,) for ring in around if ring is not None)
    first_laid, second_laid = (
        _laid(shape, own if around is None else (*own, *outer), outer)
        for shape, own, outer in zip(shapes, (first, second), sides, strict=True)
    )
    found = min(_assigned(first_laid, second_laid, turn, around is not None) for turn in TURNS.tolist())
    rows, columns = found[2]
    links: list[RingLink] = [(first[i], second[j]) for i, j in zip(rows, columns, strict=True)]
    links += [(k, None) for i, k in enumerate(first) if i not in rows]
    links += [(None, k) for j, k in enumerate(second) if j not in columns]
    return links


def _laid(shape: Shape, rings: Sequence[int], around: Sequence[int]) -> list[Floats]:
    """Move and scale rings as puts the middle of those around at 0, the sum of their areas 1."""
    areas = shapely.area(polygons := _polygons([shape.rings[k].vertices for k in around]))
    middle = areas @ shapely.get_coordinates(shapely.centroid(polygons)) / areas.sum()
    return [(shape.rings[k].vertices - middle) / np.sqrt(areas.sum()) for k in rings]


def _polygons(rings: Sequence[Floats]) -> Polygons:
    return np.asarray(shapely.polygons([shapely.linearrings(ring) for ring in rings]))


def _assigned(
    source: Sequence[Floats], target: Sequence[Floats], turn: float, around: bool
) -> tuple[float, float, tuple[list[int], list[int]]]:
    """Give the best assignment where the target is turned back by this angle, and before it its cost.

    Where there is an outline around, the last ring, that has to fit as well.
    """
    from scipy.optimize import linear_sum_assignment  # noqa: PLC0415 -- it takes as long to load as a window

    first, second = _turned(source, target, turn)
    costs = _costs(first[:, None], second[None])
    fixed = float(costs[-1, -1]) if around else 0.0
    costs = costs[:-1, :-1] if around else costs
    rows, columns = linear_sum_assignment(costs)
    price = TURNING_PRICE * (len(rows) + around) * abs(turn) / np.pi
    total = round(float(costs[rows, columns].sum()) + fixed + price, DIGITS)
    return total, abs(round(turn, DIGITS)), (rows.tolist(), columns.tolist())


def _turned(source: Sequence[Floats], target: Sequence[Floats], turn: float) -> tuple[Polygons, Polygons]:
    """Give polygons, those of both turned to meet half-way."""
    half = np.array([[np.cos(turn / 2), -np.sin(turn / 2)], [np.sin(turn / 2), np.cos(turn / 2)]])
    return _polygons([ring @ half.T for ring in source]), _polygons([ring @ half for ring in target])


def _costs(first: Polygons, second: Polygons) -> Floats:
    """Give what it costs to pair polygons: little overlap, distance of the middles, difference of sizes."""
    common, union = (
        shapely.area(shapely.intersection(first, second)),
        shapely.area(shapely.union(first, second)),
    )
    apart = shapely.distance(shapely.centroid(first), shapely.centroid(second))
    sizes = np.abs(np.log(shapely.area(first) / shapely.area(second))) / 2
    return np.asarray(1 - common / union + apart + sizes)


def _order(link: RingLink) -> tuple[float, float]:
    return tuple(np.inf if ring is None else ring for ring in link)  # type: ignore[return-value]
