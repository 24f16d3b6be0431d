"""A language that no one speaks: every text with accents on all letters, and longer by two fifths.

A text on the screen that has no accents was never given to the translators, and one that does not fit will
not fit in a language with long words either.
"""

import re

from PySide6.QtCore import QTranslator

ACCENTED = str.maketrans(
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ",
    "áƀćďéƒǵĥíĵķĺḿńóṕɋŕśţúṽŵẋýžÁƁĆĎÉƑǴĤÍĴĶĹḾŃÓṔɊŔŚŢÚṼŴẊÝŽ",
)

KEPT = re.compile(r"\{[^}]*\}|%n|%\d|&.|\(\*[^)]*\)|<[^>]*>")
"""Names of values, mnemonics, patterns of files and tags."""

KEYS = ("QShortcut", "QKeySequence", "QFontDatabase", "QGnomeTheme", "QFontComboBox")
"""Contexts whose texts are read by programs, or that are names."""


class Pseudo(QTranslator):
    """Gives every text accented and longer."""

    def isEmpty(self) -> bool:  # noqa: N802 -- as Qt calls it
        return False

    def translate(
        self, context: str, text: str, disambiguation: str | None = None, count: int = -1
    ) -> str | None:
        return None if context in KEYS or not text else lengthened(text)


def lengthened(text: str) -> str:
    """Give a text longer by two fifths, all letters accented; what programs read in it stays."""
    letters = len(KEPT.sub("", text))
    parts = KEPT.split(text)
    kept = [*KEPT.findall(text), ""]
    accented = "".join(part.translate(ACCENTED) + held for part, held in zip(parts, kept, strict=True))
    return accented + "·" * round(0.4 * letters)
