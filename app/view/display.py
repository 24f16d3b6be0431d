"""What is shown of the frames, beside their outline."""

from PySide6.QtCore import QObject, Signal


class Display(QObject):
    """Switches that all frame views follow.

    Attributes
    ----------
    pieces : bool
        Whether star pieces are shown, each in its colour.
    skeleton : bool
        Whether the skeleton is shown, with star origins, mid-points and root.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.pieces = False
        self.skeleton = False

    def show(self, *, pieces: bool, skeleton: bool) -> None:
        self.pieces, self.skeleton = pieces, skeleton
        self.changed.emit()
