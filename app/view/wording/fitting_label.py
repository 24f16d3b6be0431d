"""A label with a long text for much room and shorter ones for less: nothing is cut off in the middle."""

from collections.abc import Sequence

from PySide6.QtCore import QSize
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSizePolicy

from app.view.wording.plain import Label


class FittingLabel(Label):
    """Shows the first of its texts that fits, or else the last; it asks for no width of its own."""

    def __init__(self) -> None:
        super().__init__()
        self._texts: tuple[str, ...] = ("",)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)

    def minimumSizeHint(self) -> QSize:
        return QSize(0, super().minimumSizeHint().height())

    def say(self, texts: Sequence[str]) -> None:
        """Choose among these texts from now on, the longest first."""
        self._texts = tuple(texts)
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        measure = self.fontMetrics().horizontalAdvance
        fitting = [text for text in self._texts if measure(text) + 2 <= self.width()]
        text = (*fitting, self._texts[-1])[0]
        if text != self.text():  # or the whole window would be laid out anew
            self.setText(text)
