"""How to begin, in five lines: shown at the first start, and again from the Help menu."""

from PySide6.QtCore import QSettings, Qt, Slot
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QFrame, QHBoxLayout, QToolButton, QVBoxLayout

from app.view.commands.actions import Actions
from app.view.wording.plain import Label

_KEY = "begun"


def begun() -> bool:
    """Tell whether the user has put the lines away before."""
    return bool(QSettings().value(_KEY, False, bool))


class Beginning(QFrame):
    """Five lines side by side, in the order of the work, above the canvases: it hides nothing.

    Parameters
    ----------
    actions : Actions
        All commands: "begin" shows it and puts it away, and the lines name the keys that others have.
    """

    def __init__(self, actions: Actions) -> None:
        super().__init__()
        self._actions = actions
        self._texts = [Label() for _ in self._lines()]
        self.setObjectName("beginning")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 8, 8, 8)
        row.setSpacing(16)
        for number, (text, (heading, _)) in enumerate(zip(self._texts, self._lines(), strict=True), start=1):
            row.addLayout(_column(Label(f"{number}  {heading}"), text), 1)
        self._name_keys()
        for name in ("mark", "play", "export"):
            actions[name].changed.connect(self._name_keys)
        self.close_button = QToolButton()
        self.close_button.setObjectName("dismiss")
        self.close_button.setText("✕")
        self.close_button.setAutoRaise(True)
        self.close_button.setToolTip(self.tr("Put this away; it is in the Help menu"))
        self.close_button.setAccessibleName(self.tr("Put away how to begin"))
        self.close_button.clicked.connect(actions["begin"].trigger)
        row.addWidget(self.close_button, 0, Qt.AlignmentFlag.AlignTop)
        self.hide()

    def _lines(self) -> tuple[tuple[str, str], ...]:
        mark, play, export = (self._keys(name) for name in ("mark", "play", "export"))
        marking = self.tr("{keys}, then click a vertex and the one that it becomes.")
        writing = self.tr("{keys} writes keyframes, an animation or numbers.")
        return (
            (self.tr("Draw"), self.tr("New, then set the corners of both shapes; or open an example.")),
            (self.tr("Mark"), marking.format(keys=mark)),
            (self.tr("Compare"), self.tr("All methods side by side: does a blend cross itself?")),
            (self.tr("Play"), self.tr("{keys} plays; drag the slider to any moment.").format(keys=play)),
            (self.tr("Export"), writing.format(keys=export)),
        )

    def _keys(self, name: str) -> str:
        """Give the keys of a command as the user has set them; its name where it has none."""
        action = self._actions[name]
        keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        return keys or action.text().replace("&", "").rstrip("…")

    @Slot()
    def _name_keys(self) -> None:
        for text, (_, line) in zip(self._texts, self._lines(), strict=True):
            text.setText(line)

    def switch(self, *, shown: bool) -> None:
        """Show the lines, or put them away for good."""
        if not shown:
            QSettings().setValue(_KEY, True)
        self.setVisible(shown)


def _column(title: Label, text: Label) -> QVBoxLayout:
    font = title.font()
    font.setBold(True)
    title.setFont(font)
    text.setWordWrap(True)
    column = QVBoxLayout()
    column.setSpacing(2)
    column.addWidget(title)
    column.addWidget(text, 1, Qt.AlignmentFlag.AlignTop)
    return column
