"""Camera: how document units fall on the pixels of a view."""

from dataclasses import dataclass, replace

import numpy as np

from app.model.point import Point
from app.model.transforms import Box
from starskel.arrays import Floats

FARTHEST, NEAREST = 1e-3, 1e6
"""Parts of the scale by which everything is shown; beyond, shapes are dots, or lines that Qt cannot paint."""


@dataclass(frozen=True)
class Camera:
    """A view of the plane, y up.

    Attributes
    ----------
    width, height : float
        Size of the view in pixels.
    scale : float
        Pixels per document unit.
    centre : (float, float)
        The place in the middle of the view.
    fitted : float
        The scale by which everything was shown last; zooming goes no farther from it than `FARTHEST` and
        `NEAREST` times.
    """

    width: float = 1.0
    height: float = 1.0
    scale: float = 4.0
    centre: Point = (50.0, 50.0)
    fitted: float = 4.0

    def to_screen(self, points: Floats) -> Floats:
        """Give places on the screen, (..., 2), y down."""
        screen: Floats = (points - np.array(self.centre)) * (self.scale, -self.scale)
        screen += (self.width / 2, self.height / 2)
        return screen

    def to_document(self, x: float, y: float) -> Point:
        """Give the place in the document under a place on the screen."""
        return (
            self.centre[0] + (x - self.width / 2) / self.scale,
            self.centre[1] - (y - self.height / 2) / self.scale,
        )

    @property
    def seen(self) -> Box:
        """What of the plane is in the view."""
        left, high = self.to_document(0, 0)
        right, low = self.to_document(self.width, self.height)
        return Box((left, low), (right, high))

    def resized(self, width: float, height: float) -> "Camera":
        """Show the same place in the middle of a view of another size."""
        return replace(self, width=width, height=height)

    def zoomed(self, factor: float, x: float, y: float) -> "Camera":
        """Zoom so that what is under a place on the screen stays there, while there is anything to see."""
        fixed = self.to_document(x, y)
        scale = min(max(self.scale * factor, FARTHEST * self.fitted), NEAREST * self.fitted)
        centre = (
            fixed[0] - (x - self.width / 2) / scale,
            fixed[1] + (y - self.height / 2) / scale,
        )
        return replace(self, scale=scale, centre=centre)

    def panned(self, dx: float, dy: float) -> "Camera":
        """Move what is shown by a way on the screen."""
        return replace(self, centre=(self.centre[0] - dx / self.scale, self.centre[1] + dy / self.scale))

    def fitting(self, points: Floats, margin: float) -> "Camera":
        """Show all of these points with so many pixels free around them; none: a box of 100 by 100."""
        if not len(points):
            points = np.array([(0.0, 0.0), (100.0, 100.0)])
        low, high = points.min(axis=0), points.max(axis=0)
        free = np.maximum(np.array([self.width, self.height]) - 2 * margin, 1.0)
        scale = float((free / (high - low)).min())
        middle = (low + high) / 2
        return replace(self, scale=scale, centre=(float(middle[0]), float(middle[1])), fitted=scale)
