"""What is shown of the frames beside their outline, and which part of them: the same in all panels."""

from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal, Slot

from app.model.point import Point
from app.view.painting.camera import Camera


@dataclass(frozen=True)
class Layers:
    """Switches.

    Attributes
    ----------
    pieces : bool
        Star pieces, each in its colour.
    skeleton : bool
        The skeleton, with star origins, mid-points and root.
    onion : bool
        Onion skin: frames before and after as faint outlines.
    ways : bool
        The paths of the vertices through time.
    numbers : bool
        The numbers of the vertices.
    pictures : bool
        The pictures of source and target in the frames.
    """

    pieces: bool = False
    skeleton: bool = False
    onion: bool = False
    ways: bool = False
    numbers: bool = False
    pictures: bool = True


class Display(QObject):
    """The layers, and the linked view: zoomed or moved in one panel, all of them follow."""

    changed = Signal()
    moved = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.layers = Layers()
        self._zoom = 1.0
        self._centre: Point | None = None

    def show(self, layers: Layers) -> None:
        """Show these layers from now on."""
        self.layers = layers
        self.changed.emit()

    def seen_by(self, fitted: Camera) -> Camera:
        """Give the linked view for a panel that would show everything by this camera."""
        centre = fitted.centre if self._centre is None else self._centre
        return replace(fitted, scale=fitted.scale * self._zoom, centre=centre)

    def look(self, fitted: Camera, camera: Camera) -> None:
        """Have all panels look as this camera does in one of them; `fitted` would show everything there."""
        self._zoom, self._centre = camera.scale / fitted.scale, camera.centre
        self.moved.emit()

    @Slot()
    def fit(self) -> None:
        """Have all panels show everything."""
        self._zoom, self._centre = 1.0, None
        self.moved.emit()
