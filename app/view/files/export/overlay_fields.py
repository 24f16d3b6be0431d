"""What is to be seen on exported frames besides their shapes."""

from PySide6.QtWidgets import QCheckBox, QGridLayout, QWidget

from app.view.painting.display import Layers
from starskel.sheet.keyframe import Shown


class OverlayFields(QWidget):
    """Asks what is shown; begins with what the panels show."""

    def __init__(self, layers: Layers, *, pictured: bool) -> None:
        super().__init__()
        self._pictured = pictured
        self._pictures = QCheckBox(self.tr("Pictures in the shapes"))
        self._pictures.setChecked(pictured and layers.pictures)
        self._marks = QCheckBox(self.tr("Marks"))
        self._vertices = QCheckBox(self.tr("Vertices"))
        self._pieces = QCheckBox(self.tr("Star pieces"))
        self._pieces.setChecked(layers.pieces)
        self._skeleton = QCheckBox(self.tr("Skeleton"))
        self._skeleton.setChecked(layers.skeleton)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.addWidget(self._pictures, 0, 0, 1, 2)
        for number, box in enumerate(self._drawn):
            grid.addWidget(box, 1 + number // 2, number % 2)
        for box in (self._pictures, *self._drawn):
            box.setAccessibleName(box.text())

    @property
    def shown(self) -> Shown:
        """What was chosen."""
        return Shown(
            marks=self._marks.isChecked(),
            pieces=self._pieces.isChecked(),
            skeleton=self._skeleton.isChecked(),
            vertices=self._vertices.isChecked(),
            pictures=self._pictures.isChecked(),
        )

    def begin_with(self, shown: Shown) -> None:
        """Show what was chosen before of what panels do not show."""
        self._marks.setChecked(shown.marks)
        self._vertices.setChecked(shown.vertices)

    def offer(self, *, drawn: bool) -> None:
        """Offer what goes onto frames, or nothing where none are drawn."""
        for box in self._drawn:
            box.setEnabled(drawn)
        self._pictures.setEnabled(drawn and self._pictured)

    @property
    def _drawn(self) -> tuple[QCheckBox, ...]:
        return self._marks, self._vertices, self._pieces, self._skeleton
