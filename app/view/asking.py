"""Asking by a dialog that is gone afterwards."""

from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QDialog, QDialogButtonBox


def asked(dialog: QDialog) -> int:
    """Show a dialog until it is answered, and give its answer.

    Its parent would keep a dialog that was answered as long as the window is open. What was chosen in it can
    be read until the event loop goes on. Its buttons have no icons: Qt has some, but for a few of them only.
    """
    for box in dialog.findChildren(QDialogButtonBox):
        for button in box.buttons():
            button.setIcon(QIcon())
    try:
        return dialog.exec()
    finally:
        dialog.deleteLater()


def answers(dialog: QDialog, kinds: QDialogButtonBox.StandardButton) -> QDialogButtonBox:
    """Give the buttons by which a dialog is answered."""
    buttons = QDialogButtonBox(kinds)
    buttons.accepted.connect(dialog.accept)
    buttons.rejected.connect(dialog.reject)
    return buttons


def accepted(dialog: QDialog) -> bool:
    """Show a dialog until it is answered, and tell whether what is in it was accepted."""
    return asked(dialog) == QDialog.DialogCode.Accepted
