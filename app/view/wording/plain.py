"""Texts as they are: names of a person's may look like markup, and Qt would take them for it."""

from html import escape

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QWidget


class Label(QLabel):
    """A label of plain text, which may be wrapped where it is too long for a line."""

    def __init__(self, text: str = "", parent: QWidget | None = None, *, wrapped: bool = False) -> None:
        super().__init__(parent)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setWordWrap(wrapped)
        self.setText(text)


def tip(text: str) -> str:
    """Give a text for a tool tip, which has no way to say that it is plain."""
    if "<" not in text and "&" not in text:
        return text
    return f'<p style="white-space: pre-wrap">{escape(text)}</p>'


def title(text: str) -> str:
    """Give a text for the title of a window, where [*] is the place of a sign for what is unsaved."""
    return text.replace("[*]", "[*][*]")


def entry(text: str) -> str:
    """Give a text for a menu or a button, where & is before the letter that chooses it."""
    return text.replace("&", "&&")
