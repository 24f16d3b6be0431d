"""Easing: how t runs over the time that a blend takes."""

from dataclasses import dataclass

Point = tuple[float, float]

HALVINGS = 60
"""Enough to find a parameter to the last digit."""


@dataclass(frozen=True)
class Easing:
    """A cubic curve from (0, 0) to (1, 1): time to the right, t upwards.

    Its two handles lie in the unit square. So t never runs back, stays in [0, 1], and each t comes once.

    Attributes
    ----------
    first, second : (float, float)
        The handles: the curve leaves (0, 0) towards the first and comes to (1, 1) from the second.
    """

    first: Point = (1 / 3, 1 / 3)
    second: Point = (2 / 3, 2 / 3)

    def __post_init__(self) -> None:
        for name in ("first", "second"):
            x, y = getattr(self, name)
            object.__setattr__(self, name, (_share(x), _share(y)))

    @property
    def even(self) -> bool:
        """Whether t runs evenly."""
        return self.first[0] == self.first[1] and self.second[0] == self.second[1]

    def t(self, time: float) -> float:
        """Give t at a share of the time."""
        return time if self.even else self._across(time, 0, 1)

    def time(self, t: float) -> float:
        """Give the share of the time at which t comes."""
        return t if self.even else self._across(t, 1, 0)

    @property
    def reversed(self) -> "Easing":
        """How t runs on the way back."""
        (x, y), (u, v) = self.first, self.second
        return Easing((1 - u, 1 - v), (1 - x, 1 - y))

    def points(self, count: int) -> list[Point]:
        """Give points of the curve, both ends among them."""
        shares = [k / (count - 1) for k in range(count)]
        return [(self._at(share, 0), self._at(share, 1)) for share in shares]

    def _across(self, value: float, known: int, wanted: int) -> float:
        """Give one coordinate where the other one is known."""
        if value in (0.0, 1.0):
            return value
        low, high = 0.0, 1.0
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if self._at(middle, known) < value else (low, middle)
        return self._at(high, wanted)

    def _at(self, share: float, axis: int) -> float:
        rest = 1 - share
        inner = 3 * rest * (rest * self.first[axis] + share * self.second[axis])
        return share * (inner + share * share)


def _share(value: float) -> float:
    """Give the nearest share in six digits: more cannot be seen, and so the way back of it leads to it."""
    return round(min(max(value, 0.0), 1.0), 6)


EVEN = Easing()
"""t is the share of the time."""
