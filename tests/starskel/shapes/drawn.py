"""Letters and faces drawn for the tests: rings, the outlines before their holes."""

import numpy as np

from starskel.arrays import Floats

Rings = list[Floats]


def ellipse(x: float, y: float, width: float, height: float, count: int = 16) -> Floats:
    """An ellipse by half its width and half its height."""
    angles = 0.3 + np.linspace(0, 2 * np.pi, count, endpoint=False)
    return np.stack([x + width * np.cos(angles), y + height * np.sin(angles)], axis=1)


def _ring(*points: tuple[float, float]) -> Floats:
    return np.array(points, dtype=np.float64)


def _bow(x: float, low: float, high: float, width: float, count: int = 9) -> list[tuple[float, float]]:
    """The right half of an ellipse, from below."""
    angles = np.linspace(-np.pi / 2, np.pi / 2, count)
    middle, half = (low + high) / 2, (high - low) / 2
    return [(x + width * np.cos(a), middle + half * np.sin(a)) for a in angles.tolist()]


A = [
    _ring((0, 0), (18, 0), (26, 24), (64, 24), (72, 0), (90, 0), (54, 100), (36, 100)),
    _ring((32, 40), (58, 40), (45, 80)),
]
R = [
    _ring(
        (0, 0), (18, 0), (18, 40), (40, 40), (62, 0), (84, 0), (58, 44), *_bow(50, 44, 100, 32)[1:], (0, 100)
    ),
    _ring((18, 56), *_bow(46, 56, 84, 16), (18, 84)),
]
B = [
    _ring((0, 0), *_bow(45, 0, 54, 35), *_bow(42, 54, 100, 30)[1:], (0, 100)),
    _ring((18, 15), *_bow(42, 15, 44, 20), (18, 44)),
    _ring((18, 60), *_bow(40, 60, 86, 16), (18, 86)),
]
_LOWER, _UPPER = (
    np.roll(ellipse(45, 27, 34, 27, 20), -7, axis=0),
    np.roll(ellipse(45, 76, 29, 24, 20), 3, axis=0),
)
EIGHT = [np.concatenate([_LOWER[:15], _UPPER[:16]]), ellipse(45, 27, 18, 14), ellipse(45, 76, 14, 12)]
O = [ellipse(45, 50, 45, 50, 28), ellipse(45, 50, 27, 33, 20)]  # noqa: E741 -- the letter
_TAIL = _ring((66, 5), (84, -14), (98, -2), (80, 16))
Q = [np.concatenate([O[0][:22], _TAIL, O[0][26:]]), O[1]]
I = [_ring((0, 0), (18, 0), (18, 70), (0, 70)), ellipse(9, 90, 10, 10, 12)]  # noqa: E741 -- the letter
J = [
    _ring(
        (0, -26), (18, -26), (27, -24), (34, -19), (39, -8), (40, 70), (22, 70), (22, 0), (16, -8), (0, -10)
    ),
    ellipse(31, 90, 10, 10, 12),
]
T = [_ring((30, 0), (50, 0), (50, 80), (80, 80), (80, 100), (0, 100), (0, 80), (30, 80))]
D = [_ring((0, 0), *_bow(40, 0, 100, 48, 13), (0, 100)), _ring((18, 18), *_bow(38, 18, 82, 32, 11), (18, 82))]
BAR = [_ring((0, 0), (20, 0), (20, 80), (0, 80))]
COLON = [ellipse(10, 20, 10, 10, 12), ellipse(10, 60, 10, 10, 12)]
FACE = [
    ellipse(50, 50, 50, 50, 32),
    ellipse(32, 65, 8, 8, 12),
    ellipse(68, 65, 8, 8, 12),
    _ring((25, 35), (50, 25), (75, 35), (72, 40), (50, 32), (28, 40)),
]
LONG_FACE = [
    ellipse(50, 50, 44, 50, 32),
    ellipse(30, 60, 6, 12, 12),
    ellipse(70, 60, 6, 12, 12),
    _ring((25, 22), (50, 26), (75, 22), (72, 30), (50, 32), (28, 30)),
]

LETTERS = {
    "A-R": (A, R),
    "B-8": (B, EIGHT),
    "i-j": (I, J),
    "O-Q": (O, Q),
    "A-T": (A, T),
    "B-D": (B, D),
    "T-i": (T, I),
    "T-8": (T, EIGHT),
    "face": (FACE, LONG_FACE),
}


def moved(rings: Rings, angle: float, x: float = 0.0, y: float = 0.0) -> Rings:
    """The rings turned round the coordinates' origin, then shifted."""
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return [np.asarray(ring, dtype=np.float64) @ turn.T + (x, y) for ring in rings]
