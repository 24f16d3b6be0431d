"""About the program: what it is, and which versions are at work, to be copied into a report."""

import platform
from importlib.metadata import PackageNotFoundError, version

from PySide6.QtCore import Slot, qVersion
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QPlainTextEdit, QVBoxLayout, QWidget

from app.view.asking import answers
from app.view.wording.plain import Label

PACKAGES = ("starskel", "PySide6-Essentials", "numpy", "scipy", "shapely")


def versions() -> str:
    """Give the versions of all that is at work, a line each."""
    lines = [f"{name} {_version(name)}" for name in PACKAGES]
    return "\n".join([*lines, f"Qt {qVersion()}", f"Python {platform.python_version()}", platform.platform()])


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "-"


class AboutDialog(QDialog):
    """Says what the program is, and lets the versions be copied."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("About starskel"))
        text = Label(
            self.tr(
                "Blends one drawn shape into another by the star-skeleton, after M. Shapira and "
                "A. Rappoport, IEEE Computer Graphics and Applications, March 1995. MIT licence."
            ),
            wrapped=True,
        )
        self.versions = QPlainTextEdit(versions())
        self.versions.setReadOnly(True)
        self.versions.setAccessibleName(self.tr("Versions"))
        self.versions.setObjectName("versions")
        buttons = answers(self, QDialogButtonBox.StandardButton.Close)
        copy = buttons.addButton(self.tr("&Copy Versions"), QDialogButtonBox.ButtonRole.ActionRole)
        copy.setObjectName("copy-versions")
        copy.clicked.connect(self._copy)
        layout = QVBoxLayout(self)
        for widget in (text, self.versions, buttons):
            layout.addWidget(widget)
        self.resize(460, 320)

    @Slot()
    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.versions.toPlainText())
