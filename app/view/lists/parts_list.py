"""The list of parts beside the canvases: shown or not, named, coloured, and what becomes of each."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from PySide6.QtCore import (
    QAbstractItemModel,
    QEvent,
    QItemSelection,
    QModelIndex,
    QSignalBlocker,
    QSize,
    Qt,
    Slot,
)
from PySide6.QtGui import QAction, QDrag, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QHeaderView,
    QLineEdit,
    QSizePolicy,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.session import Session
from app.view.commands.actions import Actions
from app.view.lists.partnering import Partnering
from app.view.lists.parts_model import ICON, NAME, Index, PartsModel
from app.view.wording.plain import Label

BUTTONS = ("part-add", "part-remove", "part-forward", "part-backward", "part-colour", "suggest-pairing")
"""The commands that stand above the list."""


class PartDelegate(QStyledItemDelegate):
    """Edits a name as text, and a partner as a choice."""

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        model = index.model()
        if index.column() == NAME or not isinstance(model, PartsModel):
            editor = QLineEdit(parent)
            editor.setFrame(False)
            return editor
        box = QComboBox(parent)
        for text, part in model.choices(index):
            box.addItem(text, part)
        box.activated.connect(self._close)
        return box

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        model = index.model()
        if isinstance(editor, QComboBox) and isinstance(model, PartsModel):
            editor.setCurrentIndex(editor.findData(model.part(index)))
        else:
            super().setEditorData(editor, index)

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        if isinstance(editor, QComboBox):
            model.setData(index, editor.currentData(), Qt.ItemDataRole.EditRole)
        else:
            super().setModelData(editor, model, index)

    @Slot()
    def _close(self) -> None:
        editor = self.sender()
        if isinstance(editor, QComboBox):
            self.commitData.emit(editor)
            self.closeEditor.emit(editor)


class PartsTable(QTableView):
    """The row it is on is the part worked on; Enter edits, Space shows or hides, a drag pairs or reorders."""

    def __init__(self, session: Session, partnering: Partnering, actions: Actions) -> None:
        super().__init__()
        self._session = session
        self._actions = actions
        self._parts = PartsModel(session, partnering, self)
        self._pressed, self._chooses = QModelIndex(), False
        self.setModel(self._parts)
        self.setItemDelegate(PartDelegate(self))
        self.setObjectName("parts-table")
        self.setAccessibleName(self.tr("Parts"))
        self.setIconSize(ICON)
        self.setEditTriggers(QAbstractItemView.EditTrigger.DoubleClicked)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setDragDropMode(QAbstractItemView.DragDropMode.DragDrop)
        self.setDefaultDropAction(Qt.DropAction.MoveAction)
        self.setDragDropOverwriteMode(True)
        self.setTabKeyNavigation(False)
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setHighlightSections(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(28)
        for signal in (session.document_changed, session.changed):
            signal.connect(self.follow)
        self.follow()

    def event(self, event: QEvent) -> bool:
        own = (Qt.Key.Key_Delete, Qt.Key.Key_Backspace, Qt.Key.Key_Home, Qt.Key.Key_End)
        asked = event.type() == QEvent.Type.ShortcutOverride
        if asked and isinstance(event, QKeyEvent) and event.key() in own:
            event.accept()  # here they are about parts, in the rest of the window about vertices and time
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        editing = self.state() == QAbstractItemView.State.EditingState
        if event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self._actions["part-remove"].trigger()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and not editing:
            index = self.currentIndex()
            if self._parts.flags(index) & Qt.ItemFlag.ItemIsEditable:
                self.edit(index)
        else:
            with self._choosing():
                super().keyPressEvent(event)

    def currentChanged(self, current: Index, previous: Index) -> None:
        super().currentChanged(current, previous)
        if current.isValid():
            self._session.show_link(self._parts.link(current.row()))

    def selectionChanged(self, selected: QItemSelection, deselected: QItemSelection) -> None:
        """Let all rows that are chosen be selected parts, where they are several."""
        super().selectionChanged(selected, deselected)
        rows = self.selectionModel().selectedRows()
        links = frozenset(self._parts.link(index.row()) for index in rows) if len(rows) > 1 else frozenset()
        selection = self._session.selection
        self._session.choose(replace(selection, links=links))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._pressed = self.indexAt(event.position().toPoint())
        with self._choosing():
            super().mousePressEvent(event)

    def startDrag(self, supported: Qt.DropAction) -> None:
        """Drag the cell that was pressed: by its column one sees whether it is a partner or the whole row."""
        if self._parts.flags(self._pressed) & Qt.ItemFlag.ItemIsDragEnabled:
            drag = QDrag(self)
            drag.setMimeData(self._parts.mimeData([self._pressed]))
            drag.exec(supported, self.defaultDropAction())

    @contextmanager
    def _choosing(self) -> Iterator[None]:
        """Let rows be as the user chooses them while Qt goes through an event: it makes several changes."""
        self._chooses = True
        try:
            yield
        finally:
            self._chooses = False

    @Slot()
    def follow(self) -> None:
        """Be on the row of the part that is worked on; more rows that are chosen stay so."""
        row = self._parts.row(self._session.document.link)
        if not (self._chooses or self._session.selection.links):
            with QSignalBlocker(self.selectionModel()):
                column = max(self.currentIndex().column(), NAME)
                self.setCurrentIndex(self._parts.index(row, column))
        self.viewport().update()


class PartsPanel(QWidget):
    """Buttons, the list, and how it is used."""

    def __init__(self, session: Session, partnering: Partnering, actions: Actions) -> None:
        super().__init__()
        self.table = PartsTable(session, partnering, actions)
        self.setFocusProxy(self.table)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 4, 6, 6)
        layout.addLayout(self._buttons(actions))
        layout.addWidget(self.table, 1)
        layout.addWidget(self._switch(actions["joined"]))
        layout.addWidget(self._help())

    def _buttons(self, actions: Actions) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(2)
        for name in BUTTONS:
            row.addWidget(_button(actions[name]))
        row.addStretch(1)
        return row

    def _switch(self, action: QAction) -> QCheckBox:
        box = QCheckBox(action.text().replace("&", ""))
        box.setObjectName("joined")
        box.setToolTip(action.toolTip())
        box.clicked.connect(action.trigger)
        action.changed.connect(self._follow_switch)
        self._joined, self._box = action, box
        return box

    @Slot()
    def _follow_switch(self) -> None:
        self._box.setChecked(self._joined.isChecked())
        self._box.setEnabled(self._joined.isEnabled())

    def _help(self) -> Label:
        text = self.tr(
            "Drag a source or a target onto another row to pair it there; Enter lets you choose a partner."
        )
        label = Label(text, wrapped=True)
        policy = label.sizePolicy()
        policy.setHorizontalPolicy(QSizePolicy.Policy.Ignored)  # else the list opens as wide as its words
        label.setSizePolicy(policy)
        label.setForegroundRole(self.palette().ColorRole.PlaceholderText)
        return label


def _button(action: QAction) -> QToolButton:
    button = QToolButton()
    button.setDefaultAction(action)
    button.setIconSize(QSize(20, 20))
    button.setAutoRaise(True)
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
    button.setAccessibleName(action.text().replace("&", "").replace("…", ""))
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button
