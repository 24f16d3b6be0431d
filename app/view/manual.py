"""The manual: its pages in a window of their own, to be read beside the editor."""

from pathlib import Path

from PySide6.QtCore import Qt, QUrl, Slot
from PySide6.QtGui import QDesktopServices, QKeySequence, QShortcut, QTextBlock, QTextBlockFormat, QTextCursor
from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QPushButton, QTextBrowser, QVBoxLayout, QWidget

from app.view.wording.plain import Label
from starskel.files.projects.examples import resource_folder

CONTENTS = "README.md"

LEADING = 120.0
"""Percent of the usual height of a line."""

PICTURE = "\ufffc"
"""What Qt has in the place of a picture."""

FOLDER = resource_folder() / "manual"


class Manual(QWidget):
    """Shows pages, follows their links, and finds words in all of them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setWindowTitle(self.tr("Manual"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(780, 760)
        self.pages = QTextBrowser()
        self.pages.setOpenLinks(False)
        self.pages.setAccessibleName(self.tr("Page of the manual"))
        self.pages.document().setDocumentMargin(20)
        font = self.pages.font()
        font.setPointSizeF(1.1 * font.pointSizeF())
        self.pages.setFont(font)
        self.pages.anchorClicked.connect(self._follow)
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Find in the manual"))
        self.search.setAccessibleName(self.tr("Find in the manual"))
        self.search.setClearButtonEnabled(True)
        self.search.returnPressed.connect(self.find_next)
        self.outcome = Label()
        self._arrange()
        self.pages.sourceChanged.connect(self._lead)
        self.show_page(CONTENTS)
        self.pages.setFocus()

    @property
    def page(self) -> str:
        """The name of the page that is shown."""
        return Path(self.pages.source().toLocalFile()).name

    @Slot()
    def find_next(self) -> None:
        """Go to the next place with the words that are looked for, on this page or on one behind it."""
        words = self.search.text().strip()
        if not words:
            return
        names = page_names()
        start = names.index(self.page)
        self.outcome.clear()
        if self.pages.find(words):
            return
        for name in (*names[start + 1 :], *names[: start + 1]):
            self.show_page(name)
            if self.pages.find(words):
                return
        self.show_page(names[start])
        self.outcome.setText(self.tr("Not found"))

    def show_page(self, name: str) -> None:
        """Show a page from its beginning."""
        self.pages.setSource(QUrl.fromLocalFile(str(FOLDER / name)))
        cursor = self.pages.textCursor()
        cursor.setPosition(0)
        self.pages.setTextCursor(cursor)

    @Slot()
    def _lead(self) -> None:
        """Give a page room between its lines and paragraphs, which Markdown says nothing about."""
        cursor = QTextCursor(self.pages.document())
        block = self.pages.document().begin()
        while block.isValid():
            room = block.blockFormat()
            cursor.setPosition(block.position())
            if block.text() != PICTURE:
                room.setLineHeight(LEADING, QTextBlockFormat.LineHeightTypes.ProportionalHeight.value)
            if room.headingLevel():
                room.setTopMargin(12)
            if cursor.currentTable() is None:
                room.setBottomMargin(0 if is_code(block) and is_code(block.next()) else 8)
            cursor.setBlockFormat(room)
            block = block.next()

    @Slot()
    def show_contents(self) -> None:
        self.show_page(CONTENTS)

    def _arrange(self) -> None:
        back, forward = QPushButton(self.tr("&Back")), QPushButton(self.tr("&Forward"))
        contents = QPushButton(self.tr("&Contents"))
        back.clicked.connect(self.pages.backward)
        forward.clicked.connect(self.pages.forward)
        contents.clicked.connect(self.show_contents)
        ways = (back, self.pages.backwardAvailable), (forward, self.pages.forwardAvailable)
        for button, available in ways:
            button.setEnabled(False)
            available.connect(button.setEnabled)
        bar = QHBoxLayout()
        for widget in (contents, back, forward):
            bar.addWidget(widget)
        bar.addStretch()
        bar.addWidget(self.outcome)
        bar.addWidget(self.search, 1)
        layout = QVBoxLayout(self)
        layout.addLayout(bar)
        layout.addWidget(self.pages)
        for keys, act in (
            (QKeySequence.StandardKey.Find, self.search.setFocus),
            (QKeySequence.StandardKey.FindNext, self.find_next),
            (QKeySequence.StandardKey.Cancel, self.close),
        ):
            QShortcut(keys, self).activated.connect(act)

    @Slot(QUrl)
    def _follow(self, link: QUrl) -> None:
        """Show another page here, and what is not of the manual in the user's browser."""
        if link.isRelative():
            self.show_page(link.path())
        else:
            QDesktopServices.openUrl(link)


def is_code(block: QTextBlock) -> bool:
    """Tell whether a block is a line of code: all of it in letters of one width."""
    if block.blockFormat().nonBreakableLines():
        return True
    first = block.begin()
    if not block.isValid() or first.atEnd():
        return False
    fragment = first.fragment()
    return fragment.text() == block.text() and fragment.charFormat().fontFixedPitch()


def page_names() -> tuple[str, ...]:
    """Give the names of all pages, the contents first."""
    names = sorted(path.name for path in FOLDER.glob("*.md"))
    return (CONTENTS, *(name for name in names if name != CONTENTS))
