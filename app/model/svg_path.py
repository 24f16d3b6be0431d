"""Path data of SVG as curves (SVG 1.1, section 8.3)."""

import re
from cmath import phase, rect
from math import ceil, pi, radians, sqrt, tan

Curve = tuple[complex, ...]
"""x + iy: two points of a line, or four of a cubic Bezier curve."""

_NUMBER = re.compile(r"[\s,]*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)")
_FLAG = re.compile(r"[\s,]*([01])")
_COMMAND = re.compile(r"[\s,]*([MmLlHhVvCcSsQqTtAaZz])")


class PathError(ValueError):
    """The path data breaks off, or is none."""


def subpaths(data: str) -> list[list[Curve]]:
    """Give each subpath as curves, every one beginning where the one before it ends.

    Raises
    ------
    PathError
        Naming the character at which the data is not as it should be.
    """
    return _Reader(data).read()


class _Reader:
    def __init__(self, data: str) -> None:
        self._data = data
        self._next = 0
        self._here = self._start = self._control = 0j
        self._smooth = ""  # the kind of curve that was last, whose control point the next one may mirror
        self._paths: list[list[Curve]] = []

    def read(self) -> list[list[Curve]]:
        while self._data[self._next :].strip(" \t\r\n,"):
            command = self._take(_COMMAND)
            self._do(command)
            again = {"M": "L", "m": "l"}.get(command, command)
            while command not in "Zz" and _NUMBER.match(self._data, self._next):
                self._do(again)
        return [path for path in self._paths if path]

    def _take(self, pattern: re.Pattern[str]) -> str:
        found = pattern.match(self._data, self._next)
        if found is None:
            raise PathError(f"a path is not understood at character {self._next}")
        self._next = found.end()
        return found[1]

    def _number(self) -> float:
        return float(self._take(_NUMBER))

    def _point(self, origin: complex) -> complex:
        return origin + complex(self._number(), self._number())

    def _do(self, command: str) -> None:
        origin = self._here if command.islower() else 0j
        kind = command.upper()
        if kind == "M":
            self._here = self._start = self._point(origin)
            self._paths.append([])
        elif kind == "Z":
            self._here = self._start
            self._paths.append([])
        elif kind in "LHV":
            self._line(kind, origin)
        elif kind == "A":
            self._arc(origin)
        else:
            self._bend(kind, origin)
        self._smooth = kind

    def _draw(self, *curve: complex) -> None:
        if not self._paths:
            raise PathError("a path does not begin with M")
        self._paths[-1].append(curve)
        self._here = curve[-1]

    def _line(self, kind: str, origin: complex) -> None:
        if kind == "L":
            end = self._point(origin)
        elif kind == "H":
            end = complex(origin.real + self._number(), self._here.imag)
        else:
            end = complex(self._here.real, origin.imag + self._number())
        self._draw(self._here, end)

    def _bend(self, kind: str, origin: complex) -> None:
        here, mirrored = self._here, 2 * self._here - self._control
        if kind in "CS":
            first = self._point(origin) if kind == "C" else mirrored if self._smooth in ("C", "S") else here
            self._control = self._point(origin)
            self._draw(here, first, self._control, self._point(origin))
            return
        between = self._point(origin) if kind == "Q" else mirrored if self._smooth in ("Q", "T") else here
        self._control = between
        end = self._point(origin)
        self._draw(here, here + 2 / 3 * (between - here), end + 2 / 3 * (between - end), end)

    def _arc(self, origin: complex) -> None:
        radii = abs(self._number()), abs(self._number())
        turn = radians(self._number())
        large, sweep = self._take(_FLAG) == "1", self._take(_FLAG) == "1"
        end = self._point(origin)
        if not all(radii) or end == self._here:
            self._draw(self._here, end)
            return
        for curve in _elliptic((self._here, end), radii, turn, large=large, sweep=sweep):
            self._draw(*curve)


def _elliptic(
    ends: tuple[complex, complex], radii: tuple[float, float], turn: float, *, large: bool, sweep: bool
) -> list[Curve]:
    """Give an arc of an ellipse in parts of at most a quarter (SVG 1.1, appendix F.6)."""

    def round_off(point: complex) -> complex:  # to where the ellipse is a circle of radius 1
        turned = point * rect(1, -turn)
        return complex(turned.real / radii[0], turned.imag / radii[1])

    def back(point: complex) -> complex:
        return complex(point.real * radii[0], point.imag * radii[1]) * rect(1, turn)

    a, b = (round_off(end) for end in ends)
    half = abs(b - a) / 2
    if half > 1:  # too small to reach: as large as it must be
        radii = radii[0] * half, radii[1] * half
        a, b, half = *(round_off(end) for end in ends), 1.0
    aside = sqrt(max(1 - half * half, 0)) * (b - a) / abs(b - a) * 1j
    centre = (a + b) / 2 + (aside if large != sweep else -aside)
    first = phase(a - centre)
    extent = (phase(b - centre) - first) % (2 * pi) - (0 if sweep else 2 * pi)
    parts = max(ceil(abs(extent) / (pi / 2)), 1)
    step = extent / parts
    reach = 4 / 3 * tan(step / 4)
    curves = []
    for k in range(parts):
        p, q = rect(1, first + k * step), rect(1, first + (k + 1) * step)
        points = (p, p * (1 + 1j * reach), q * (1 - 1j * reach), q)
        curves.append(tuple(back(centre + point) for point in points))
    curves[-1] = (*curves[-1][:-1], ends[1])
    return curves
