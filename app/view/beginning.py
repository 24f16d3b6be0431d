"""How to begin, in five lines: shown at the first start, and again from the Help menu."""

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QToolButton, QVBoxLayout

_KEY = "begun"


def begun() -> bool:
    """Tell whether the user has put the lines away before."""
    return bool(QSettings().value(_KEY, False, bool))


class Beginning(QFrame):
    """Five lines side by side, in the order of the work, above the canvases: it hides nothing.

    Parameters
    ----------
    switch : QAction
        What shows it and puts it away.
    """

    def __init__(self, switch: QAction) -> None:
        super().__init__()
        self.setObjectName("beginning")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 8, 8, 8)
        row.setSpacing(16)
        for number, (heading, line) in enumerate(self._lines(), start=1):
            row.addLayout(_column(f"{number}  {heading}", line), 1)
        self.close_button = QToolButton()
        self.close_button.setObjectName("dismiss")
        self.close_button.setText("✕")
        self.close_button.setAutoRaise(True)
        self.close_button.setToolTip(self.tr("Put this away; it is in the Help menu"))
        self.close_button.setAccessibleName(self.tr("Put away how to begin"))
        self.close_button.clicked.connect(switch.trigger)
        row.addWidget(self.close_button, 0, Qt.AlignmentFlag.AlignTop)
        self.hide()

    def _lines(self) -> tuple[tuple[str, str], ...]:
        return (
            (self.tr("Draw"), self.tr("New, then set the corners of both shapes; or open an example.")),
            (self.tr("Mark"), self.tr("M, then click a vertex and the one that it becomes.")),
            (self.tr("Compare"), self.tr("All methods side by side: does a blend cross itself?")),
            (self.tr("Play"), self.tr("P plays; drag the slider to any moment.")),
            (self.tr("Export"), self.tr("Ctrl+E writes keyframes, an animation or numbers.")),
        )

    def switch(self, *, shown: bool) -> None:
        """Show the lines, or put them away for good."""
        if not shown:
            QSettings().setValue(_KEY, True)
        self.setVisible(shown)


def _column(heading: str, line: str) -> QVBoxLayout:
    title, text = QLabel(heading), QLabel(line)
    font = title.font()
    font.setBold(True)
    title.setFont(font)
    text.setWordWrap(True)
    column = QVBoxLayout()
    column.setSpacing(2)
    column.addWidget(title)
    column.addWidget(text, 1, Qt.AlignmentFlag.AlignTop)
    return column
