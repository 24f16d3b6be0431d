"""The table of marks beside the canvases, which the keyboard alone can fill, change and empty."""

from functools import partial

from PySide6.QtCore import QEvent, QModelIndex, Qt, QTimer, Slot
from PySide6.QtGui import QColor, QFocusEvent, QIntValidator, QKeyEvent, QPalette
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QLineEdit,
    QPushButton,
    QSpinBox,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from app.session import Session
from app.tools.verbs.marks import remove_mark
from app.view.lists.marks_model import Index, MarksModel
from app.view.painting.theme import theme_of
from app.view.wording import words
from app.view.wording.plain import Label

MOST = 99
"""Marks that may be suggested at once; more would be hard to tell apart."""

OWN_KEYS = (Qt.Key.Key_Delete, Qt.Key.Key_Backspace, Qt.Key.Key_Home, Qt.Key.Key_End)
"""Keys that mean something else in the table than in the rest of the window."""


class VertexDelegate(QStyledItemDelegate):
    """Edits a vertex number as plain digits."""

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        editor = QLineEdit(parent)
        editor.setFrame(False)
        editor.setAlignment(Qt.AlignmentFlag.AlignRight)
        editor.setValidator(QIntValidator(0, 999_999, editor))
        return editor


class MarksTable(QTableView):
    """Points at the vertices of the row it is on; Tab and arrows move, digits change, Delete removes."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._marks = MarksModel(session, self)
        self.setModel(self._marks)
        self.setItemDelegate(VertexDelegate(self))
        self.setObjectName("marks-table")
        self.setAccessibleName(self.tr("Marks"))
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.AnyKeyPressed | QAbstractItemView.EditTrigger.DoubleClicked
        )
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.horizontalHeader().setHighlightSections(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(26)
        self._soon = QTimer(self, singleShot=True, interval=0)  # its own, so that it ends with the table
        self._soon.timeout.connect(self._to_new)
        self._marks.rowsInserted.connect(self._go_on)
        self._marks.dataChanged.connect(self._point)

    def event(self, event: QEvent) -> bool:
        asked = event.type() == QEvent.Type.ShortcutOverride
        if asked and isinstance(event, QKeyEvent) and event.key() in OWN_KEYS:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        index = self.currentIndex()
        if event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self._delete(index)
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._edit(index)
        else:
            super().keyPressEvent(event)

    def focusNextPrevChild(self, next: bool) -> bool:  # noqa: A002 -- as Qt calls it
        """Let Tab go from cell to cell, and out of the table at its end."""
        rows, columns = self._marks.rowCount(), self._marks.columnCount()
        last = self._marks.index(rows - 1, columns - 1) if next else self._marks.index(0, 0)
        self.setTabKeyNavigation(self.currentIndex() != last)
        return super().focusNextPrevChild(next)

    def currentChanged(self, current: Index, previous: Index) -> None:
        super().currentChanged(current, previous)
        self._point()

    def focusInEvent(self, event: QFocusEvent) -> None:
        if not self.currentIndex().isValid():
            self.setCurrentIndex(self._marks.index(0, 1))
        super().focusInEvent(event)
        self._point()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self._session.point("source", None)

    @Slot()
    def _point(self) -> None:
        index = self.currentIndex()
        if index.isValid() and self.hasFocus():
            self._session.point(self._marks.side(max(index.column(), 1)), self._marks.vertex(index))

    def _edit(self, index: QModelIndex) -> None:
        editing = self.state() == QAbstractItemView.State.EditingState  # then the key ends it
        if not editing and self._marks.flags(index) & Qt.ItemFlag.ItemIsEditable:
            self.edit(index)

    def _delete(self, index: QModelIndex) -> None:
        if 0 <= index.row() < self._marks.rowCount() - 1:
            self._session.edit(partial(remove_mark, index=index.row()))
        else:
            self._marks.forget()

    @Slot()
    def _go_on(self) -> None:
        """Go to where the next mark can be typed, as soon as the editor is closed."""
        self._soon.start()

    @Slot()
    def _to_new(self) -> None:
        self.setCurrentIndex(self._marks.index(self._marks.rowCount() - 1, 1))
        self.scrollTo(self.currentIndex())


class MarksPanel(QWidget):
    """Suggestion, table, and what was refused."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self.table = MarksTable(session)
        self.count = QSpinBox()
        self.count.setObjectName("suggest-count")
        self.count.setAccessibleName(self.tr("How many marks"))
        self.count.setRange(1, MOST)
        self.count.setValue(8)
        self._suggest = QPushButton(self.tr("Suggest"))
        self._suggest.setObjectName("suggest")
        self._suggest.setToolTip(self.tr("Replace all marks by ones that suggest themselves"))
        self._suggest.clicked.connect(self.suggest)
        self.message = Label(wrapped=True)
        self.message.setObjectName("marks-message")
        self.message.hide()
        self.setFocusProxy(self.table)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 4, 6, 6)
        layout.addLayout(self._suggestion())
        layout.addWidget(self.table, 1)
        layout.addWidget(self.message)
        layout.addWidget(self._help())
        session.changed.connect(self._follow)
        session.document_changed.connect(self._follow)
        self._follow()

    def _suggestion(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.addWidget(self._suggest, 1)
        row.addWidget(self.count)
        row.addWidget(Label(self.tr("marks")))
        return row

    def _help(self) -> Label:
        text = self.tr("Type a vertex number to change it, Del removes. New marks go in the last row.")
        label = Label(text, wrapped=True)
        label.setForegroundRole(self.palette().ColorRole.PlaceholderText)
        return label

    @Slot()
    def suggest(self) -> None:
        """Replace the marks by as many suggested ones as the field says."""
        self._session.suggest_marks(self.count.value())

    @Slot()
    def _follow(self) -> None:
        document, refusal = self._session.document, self._session.refusal
        self._suggest.setEnabled(document.source is not None and document.target is not None)
        concerned = refusal is not None and bool(refusal.marks)
        self.message.setVisible(concerned)
        if refusal is not None and concerned:
            self.message.setText("✕ " + words.reason(refusal.error, document))
            palette = QPalette(self.palette())
            palette.setColor(QPalette.ColorRole.WindowText, QColor(theme_of(palette).refused))
            self.message.setPalette(palette)
