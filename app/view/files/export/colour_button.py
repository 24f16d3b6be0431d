"""A button that shows a colour, and asks for another one when it is pressed."""

from PySide6.QtCore import QSize, Signal, Slot
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QColorDialog, QToolButton

from app.view.painting.icons import swatch

SWATCH = QSize(28, 14)


class ColourButton(QToolButton):
    """Holds a colour."""

    changed = Signal()

    def __init__(self, colour: str, name: str) -> None:
        super().__init__()
        self.setAccessibleName(name)
        self.setToolTip(name)
        self.setIconSize(SWATCH)
        self._colour = QColor(colour)
        self._show()
        self.clicked.connect(self._ask)

    @property
    def colour(self) -> str:
        """The colour, as "#rrggbb"."""
        return self._colour.name()

    def take(self, colour: str) -> None:
        """Hold another colour."""
        self._colour = QColor(colour)
        self._show()

    @Slot()
    def _ask(self) -> None:
        found = QColorDialog.getColor(self._colour, self, self.accessibleName())
        if found.isValid():
            self.take(found.name())
            self.changed.emit()

    def _show(self) -> None:
        self.setIcon(swatch(self._colour, SWATCH))
        self.setAccessibleDescription(self.colour)
