"""A field for numbers that takes a comma and a point alike, and may follow one from elsewhere."""

from PySide6.QtCore import QSignalBlocker
from PySide6.QtGui import QValidator
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
        typing = self.hasFocus() and self.cleanText() != self.textFromValue(self.value())
        if not typing:
            with QSignalBlocker(self):
                self.setValue(value)
