"""Where the key shapes lie in their strip, and the steps between them."""

from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, QSize

TILE = QSize(76, 58)
"""Size of the picture of a shape, in pixels."""

STEP = 58
"""Width of what joins two shapes."""

EDGE = 10

TIMES = 16
"""Height of the line of times below the pictures."""


@dataclass(frozen=True)
class StripLayout:
    """Tiles in a row, a step between each two, and behind the last a place for a further shape."""

    shapes: int

    @property
    def size(self) -> QSize:
        """The room that all of it takes."""
        return QSize(round(self.addition.right()) + EDGE, TILE.height() + TIMES + 8)

    @property
    def addition(self) -> QRectF:
        """Where a click adds a shape."""
        left = self.tile(self.shapes - 1).right() + STEP / 2
        return QRectF(left, 4 + TILE.height() / 2 - 14, 28, 28)

    def tile(self, shape: int) -> QRectF:
        """Give the place of a shape's picture."""
        return QRectF(EDGE + shape * (TILE.width() + STEP), 4, TILE.width(), TILE.height())

    def step(self, step: int) -> QRectF:
        """Give the place of what joins two shapes."""
        return QRectF(self.tile(step).right(), 4, STEP, TILE.height())

    def tile_at(self, place: QPointF) -> int | None:
        """Give the shape under a pixel."""
        return next((k for k in range(self.shapes) if self.tile(k).contains(place)), None)

    def step_at(self, place: QPointF) -> int | None:
        """Give the step under a pixel."""
        return next((k for k in range(self.shapes - 1) if self.step(k).contains(place)), None)

    def slot_at(self, x: float) -> int:
        """Give how many shapes lie left of here: where a shape would go that is dropped."""
        return sum(self.tile(shape).center().x() < x for shape in range(self.shapes))

    def slot(self, slot: int) -> float:
        """Give the middle of the gap where a shape would go."""
        return max(self.tile(slot).left() - STEP / 2, EDGE / 2)
