"""Families of seeded polygons and pairs, for tests and benchmarks."""

import numpy as np

from starskel.arrays import Floats, Indices
from starskel.crossings import crossing_edges
from starskel.errors import InvalidPolygon
from starskel.polygon import Polygon

ATTEMPTS = 20
"""Sets of points tried before a grid is given up as too full."""


def two_opt(n: int, seed: int, grid: int = 0) -> Floats:
    """A random simple ring of n vertices: a random tour, untangled; on an integer grid if one is given."""
    rng = np.random.default_rng([n, seed, grid])
    for _ in range(ATTEMPTS):
        points = rng.random((n, 2)) * 100
        if grid:
            cells = rng.choice(grid * grid, n, replace=False)
            points = np.stack(np.divmod(cells, grid), axis=1).astype(float)
        ring = _untangle(points, rng)
        try:
            return Polygon(ring).vertices
        except InvalidPolygon:
            continue
    raise ValueError(f"none of {ATTEMPTS} tours of {n} points untangled: take a larger grid than {grid}")


def _untangle(ring: Floats, rng: np.random.Generator) -> Floats:
    """Reverse ways between crossing edges, in each pass as many as have no edge in common."""
    n = len(ring)
    for _ in range(10 * n):
        ring = np.roll(ring[:: rng.choice((-1, 1))], rng.integers(n), axis=0)
        pairs = crossing_edges(ring)
        if not len(pairs):
            break
        order = list(range(n))
        for first, second in _without_common_edges(rng.permutation(pairs), n).tolist():
            _reverse_between(first, second, order)
        ring = ring[order]
    return ring


def _without_common_edges(pairs: Indices, n: int) -> Indices:
    rank = np.arange(len(pairs))
    first = np.full(n, len(pairs))
    np.minimum.at(first, pairs.ravel(), rank.repeat(2))
    return pairs[(first[pairs] == rank[:, None]).all(axis=1)]


def _reverse_between(first: int, second: int, order: list[int]) -> None:
    """Reverse the way between two edges, named by where they were; between neighbours swap vertices."""
    n = len(order)
    i, j = sorted(_start(order.index(edge), order.index((edge + 1) % n), n) for edge in (first, second))
    stop = j + 1 if j - i > 1 else j + 2
    order[i + 1 : stop] = order[i + 1 : stop][::-1]


def _start(end: int, other: int, n: int) -> int:
    """Give where in a tour the edge between two neighbouring places starts."""
    return min(end, other) if abs(end - other) == 1 else n - 1


def related(n: int, seed: int, spread: float = 0.5) -> tuple[Floats, Floats]:
    """A random ring, and one with its turning angles and edge lengths perturbed."""
    rng = np.random.default_rng([n, seed, 7])
    source = two_opt(n, seed)
    edges = np.roll(source, -1, axis=0) - source
    lengths = np.hypot(*edges.T)
    directions = np.unwrap(np.arctan2(edges[:, 1], edges[:, 0]))
    for attempt in range(10_000):
        scale = spread * 0.999**attempt
        bent = directions + np.cumsum(rng.normal(0, scale, n)) * 0.3
        stretched = lengths * np.exp(rng.normal(0, scale, n))
        steps = stretched[:, None] * np.stack([np.cos(bent), np.sin(bent)], axis=1)
        steps -= steps.mean(axis=0)
        target = np.roll(np.cumsum(steps, axis=0), 1, axis=0)
        try:
            polygon = Polygon(target)
        except InvalidPolygon:
            continue
        if np.array_equal(polygon.vertices, target):
            return source, target
    raise AssertionError("no simple relative found")


def comb(teeth: int, depth: float = 8.0) -> Floats:
    """A comb: teeth of one width on a bar; tips and valleys on two straight lines."""
    upper = [(2 * k + dx, y) for k in range(teeth) for dx, y in ((0, 1), (0, depth), (1, depth), (1, 1))]
    ring = [(0, 0), (2 * teeth - 1, 0), *upper[::-1]]
    return Polygon(np.array(ring[:-1] if ring[-1] == (0, 1) else ring, dtype=float)).vertices


def spiral(n: int, turns: float = 2.0, handed: int = 1) -> Floats:
    """A spiral band of n vertices (n even)."""
    angles = np.linspace(0.5, 2 * np.pi * turns, n // 2)
    arm = np.stack([np.cos(angles), handed * np.sin(angles)], axis=1) * angles[:, None]
    inner = arm * (1 - 2.0 / np.maximum(angles, 4))[:, None]
    ring = np.concatenate([arm, inner[::-1]])
    if len(crossing_edges(ring)):  # too few vertices for so many turns
        return spiral(n, 0.8 * turns, handed)
    return Polygon(ring).vertices


def blob(n: int, seed: int = 0, arms: int = 5, depth: float = 0.5) -> Floats:
    """A smooth ring of n vertices with arms."""
    rng = np.random.default_rng([seed, arms])
    angles = np.linspace(0, 2 * np.pi, n, endpoint=False)
    radius = (
        1 + depth * np.cos(arms * angles + rng.random()) + 0.15 * np.cos((arms + 2) * angles + rng.random())
    )
    bend = 0.4 * np.sin(2 * angles + rng.random())
    return 10 * radius[:, None] * np.stack([np.cos(angles + bend), np.sin(angles + bend)], axis=1)


def subdivided(ring: Floats, parts: int) -> Floats:
    """The ring with every edge cut into parts: long runs of vertices that are straight but for rounding."""
    shares = np.arange(parts)[None, :, None] / parts
    ends = np.roll(ring, -1, axis=0)
    return ((1 - shares) * ring[:, None] + shares * ends[:, None]).reshape(-1, 2)


def turned(ring: Floats, angle: float) -> Floats:
    """The ring turned round the coordinates' origin."""
    c, s = np.cos(angle), np.sin(angle)
    return ring @ np.array([[c, s], [-s, c]])


def articulated(seed: int, spread: float = 1.0) -> tuple[Floats, Floats]:
    """A body with three to five limbs of two joints, in two poses, vertex i on vertex i."""
    rng = np.random.default_rng([seed, 91])
    while True:
        sides = int(rng.integers(5, 9))
        angles = np.linspace(0, 2 * np.pi, sides, endpoint=False) + rng.normal(0, 0.1, sides)
        body = np.stack([np.cos(angles), 1.2 * np.sin(angles)], axis=1)
        limbs = rng.choice(sides, size=int(rng.integers(3, 6)), replace=False).tolist()
        sizes = rng.uniform([0.8, 0.7, 0.4], [2.0, 1.8, 1.0], (len(limbs), 3))
        pose = spread * rng.normal(0, [0.3, 0.4], (len(limbs), 2))
        other = pose + spread * rng.normal(0, [0.5, 0.7], (len(limbs), 2))
        rings = [
            _posed(body, dict(zip(limbs, zip(sizes, p, strict=True), strict=True))) for p in (pose, other)
        ]
        if not any(len(crossing_edges(ring)) for ring in rings):
            return rings[0], rings[1]


def _posed(body: Floats, limbs: dict[int, tuple[Floats, Floats]]) -> Floats:
    parts = []
    for side, (start, end) in enumerate(zip(body, np.roll(body, -1, axis=0), strict=True)):
        parts.append(start[None])
        if side in limbs:
            parts.append(_limb(0.8 * start + 0.2 * end, 0.2 * start + 0.8 * end, *limbs[side]))
    return np.concatenate(parts)


def _limb(right: Floats, left: Floats, size: Floats, bends: Floats) -> Floats:
    """The outline of a limb of two parts on a side of the body, by their lengths, its taper and its bends."""
    x, y = left - right
    upper = np.arctan2(y, x) - np.pi / 2 + bends[0]
    lower, half = upper + bends[1], np.hypot(x, y) / 2
    joint = (right + left) / 2 + size[0] * _direction(upper)
    tip = joint + size[1] * _direction(lower)
    aside = _direction((upper + lower) / 2 - np.pi / 2) / np.cos(bends[1] / 2) * half * (1 + size[2]) / 2
    round_tip = tip + size[2] * half * _direction(lower + np.linspace(-np.pi / 2, np.pi / 2, 4))
    ways = [
        (right, (right + joint + aside) / 2, joint + aside, (joint + aside + round_tip[0]) / 2),
        ((joint - aside + round_tip[-1]) / 2, joint - aside, (left + joint - aside) / 2, left),
    ]
    return np.concatenate([ways[0], round_tip, ways[1]])


def _direction(angles: Floats) -> Floats:
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)
