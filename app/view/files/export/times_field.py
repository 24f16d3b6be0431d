"""A field for moments: numbers from 0 to 1, set apart by spaces."""

import re
from collections.abc import Sequence

from PySide6.QtWidgets import QLineEdit, QWidget

from app.view.wording.words import figure


class TimesField(QLineEdit):
    """Asks for times; left empty there are none of their own."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        point = self.locale().decimalPoint()
        self.setPlaceholderText("  ".join(("0", f"0{point}25", f"0{point}5", "1")))
        self.setToolTip(self.tr("Numbers from 0 to 1, set apart by spaces; empty for evenly spread ones"))
        self.setClearButtonEnabled(True)

    def begin_with(self, times: Sequence[float]) -> None:
        """Show times that were chosen before."""
        self.setText("  ".join(figure(f"{time:.6g}") for time in times))

    @property
    def times(self) -> tuple[float, ...] | None:
        """The times, none where nothing is written; None where it is something else."""
        separators = r"[\s;]+" if self.locale().decimalPoint() == "," else r"[\s;,]+"
        words = [word for word in re.split(separators, self.text()) if word]
        try:
            times = tuple(float(word.replace(",", ".")) for word in words)
        except ValueError:
            return None
        return times if all(0 <= time <= 1 for time in times) else None
