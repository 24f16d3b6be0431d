"""Where the parts of the strip chart lie, for the chart and for the legend beside it."""

from dataclasses import dataclass

from PySide6.QtCore import QRectF

LANE = 12
"""Height of a method's lane of crossings, in pixels."""

AREA = 46
"""Least height of the plot of areas."""

LENGTHS = 28
"""Height of the plot of lengths."""

GAP = 4


@dataclass(frozen=True)
class ChartLayout:
    """A plot of areas, below it one of lengths, below them a lane of crossings for each method.

    Attributes
    ----------
    width, height : float
        Of the whole chart, in pixels.
    inset : float
        Pixels to the left of t = 0 and to the right of t = 1.
    methods : int
        How many lanes there are.
    """

    width: float
    height: float
    inset: float
    methods: int

    @staticmethod
    def least_height(methods: int) -> int:
        """Give the height that so many methods need."""
        return AREA + LENGTHS + LANE * max(methods, 1) + 3 * GAP

    @property
    def area(self) -> QRectF:
        """The plot of areas."""
        rest = LENGTHS + LANE * self.methods + 3 * GAP
        return QRectF(self.inset, 1, self.span, self.height - rest)

    @property
    def lengths(self) -> QRectF:
        """The plot of lengths."""
        return QRectF(self.inset, self.area.bottom() + GAP, self.span, LENGTHS)

    @property
    def span(self) -> float:
        """Pixels from t = 0 to t = 1."""
        return self.width - 2 * self.inset

    def lane(self, number: int) -> QRectF:
        """Give the lane of the k-th method."""
        return QRectF(self.inset, self.lengths.bottom() + GAP + LANE * number, self.span, LANE)

    def lane_at(self, y: float) -> int | None:
        """Give the lane at a height."""
        number = int((y - self.lane(0).top()) // LANE)
        return number if 0 <= number < self.methods else None

    def x(self, t: float) -> float:
        """Give the pixel of a moment."""
        return self.inset + t * self.span

    def t(self, x: float) -> float:
        """Give the moment of a pixel."""
        return min(max((x - self.inset) / self.span, 0.0), 1.0)
