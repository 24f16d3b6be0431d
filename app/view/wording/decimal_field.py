"""A field for numbers that takes a comma and a point alike, and may follow one from elsewhere."""

from PySide6.QtCore import QEvent, QSignalBlocker, Qt
from PySide6.QtGui import QKeyEvent, QValidator
from PySide6.QtWidgets import QDoubleSpinBox


class DecimalField(QDoubleSpinBox):
    """Qt would take the other sign as one between thousands: "1,5" would become 15 in English."""

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        """Write either sign as the language does; without thousands marked, both mean the same."""
        point = self.locale().decimalPoint()
        state, same, place = super().validate(text.replace(",", point).replace(".", point), position)
        return state, same, place

    def follow(self, value: float) -> None:
        """Show a number as it is now: that is no edit, and what is being typed stays until it is entered."""
        if not self._typing:
            with QSignalBlocker(self):
                self.setValue(value)

    @property
    def _typing(self) -> bool:
        """Whether something is typed that does not count yet."""
        pending = not self.keyboardTracking() and self.cleanText() != self.textFromValue(self.value())
        return self.hasFocus() and pending

    def event(self, event: QEvent) -> bool:
        """Keep Escape from the window while it gives up what is typed."""
        asked = event.type() == QEvent.Type.ShortcutOverride
        if asked and isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape and self._typing:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self._typing:
            self.setValue(self.value())
            self.selectAll()
        else:
            super().keyPressEvent(event)
