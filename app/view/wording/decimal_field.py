"""A field for numbers that takes a comma and a point alike."""

from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox


class DecimalField(QDoubleSpinBox):
    """Qt would take the other sign as one between thousands: "1,5" would become 15 in English."""

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        """Write either sign as the language does; without thousands marked, both mean the same."""
        point = self.locale().decimalPoint()
        state, same, place = super().validate(text.replace(",", point).replace(".", point), position)
        return state, same, place
