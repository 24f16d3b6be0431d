"""The marks as a table: a row each, and a last row in which a new one can be typed."""

from functools import partial
from typing import Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QObject, QPersistentModelIndex, QSize, Qt, Slot
from PySide6.QtGui import QColor, QIcon, QPalette

from app.model.marks import SIDES, Side, end
from app.session import Session
from app.tools.verbs.marks import move_mark, set_mark
from app.view.painting.icons import swatch
from app.view.painting.theme import theme_of
from app.view.wording import words

Index = QModelIndex | QPersistentModelIndex

LABEL = 0
"""The column of the marks' names; those of source and target follow."""

SWATCH = QSize(16, 16)
"""Size of a mark's colour, in pixels."""


class MarksModel(QAbstractTableModel):
    """Follows the session's marks, and edits them there.

    Attributes
    ----------
    draft : dict of side to int
        What has been typed of a new mark.
    """

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._shown = session.document.marks
        self.draft: dict[Side, int] = {}
        self._swatches: dict[str | None, QIcon] = {}
        session.document_changed.connect(self._follow)

    @staticmethod
    def side(column: int) -> Side:
        """Give the shape that a column names vertices of."""
        return SIDES[column - LABEL - 1]

    def vertex(self, index: Index) -> int | None:
        """Give the vertex that a cell names; the label counts as the source's."""
        side = self.side(max(index.column(), LABEL + 1))
        if index.row() < len(self._shown):
            return end(self._shown[index.row()], side)
        return self.draft.get(side)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 -- as Qt calls it
        return 0 if parent.isValid() else len(self._shown) + 1

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else LABEL + 1 + len(SIDES)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:
        if orientation != Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        return self.tr("Mark") if section == LABEL else words.side(self.side(section))

    def flags(self, index: Index) -> Qt.ItemFlag:
        usual = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        return usual if index.column() == LABEL else usual | Qt.ItemFlag.ItemIsEditable

    def data(self, index: Index, role: int = 0) -> Any:
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.EditRole):
            return self._text(index)
        if role == Qt.ItemDataRole.DecorationRole and index.column() == LABEL:
            return self._swatch(index.row())
        if role == Qt.ItemDataRole.TextAlignmentRole and index.column() != LABEL:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.ToolTipRole and index.row() == len(self._shown):
            return self.tr("Type the numbers of two vertices that correspond")
        return None

    def setData(self, index: Index, value: Any, role: int = 0) -> bool:
        """Take a vertex number; a new mark is set as soon as both of its vertices are typed."""
        if role != Qt.ItemDataRole.EditRole or str(value).strip() == "":
            return False
        side, vertex = self.side(index.column()), int(value)
        if index.row() < len(self._shown):
            self._session.edit(partial(move_mark, index=index.row(), side=side, vertex=vertex))
            return self.vertex(index) == vertex
        self.draft[side] = vertex
        self.dataChanged.emit(index, index)
        if len(self.draft) == len(SIDES):
            self._session.edit(partial(set_mark, source=self.draft["source"], target=self.draft["target"]))
        return True

    def forget(self) -> None:
        """Empty the row of the new mark."""
        row = len(self._shown)
        self.draft = {}
        self.dataChanged.emit(self.index(row, LABEL), self.index(row, len(SIDES)))

    def _text(self, index: Index) -> str:
        if index.column() == LABEL:
            return words.mark(index.row())
        vertex = self.vertex(index)
        return "" if vertex is None else str(vertex)

    def _swatch(self, row: int) -> QIcon:
        """Give a mark's colour, the same icon whenever it is asked for: Qt keeps what it painted of each."""
        theme = theme_of(QPalette())
        colour = theme.pins[row % len(theme.pins)] if row < len(self._shown) else None
        if colour not in self._swatches:
            self._swatches[colour] = swatch(QColor(colour or Qt.GlobalColor.transparent), SWATCH)
        return self._swatches[colour]

    @Slot()
    def _follow(self) -> None:
        """Take over the marks; rows come and go at the end, so that an editor that is open stays so."""
        marks, shown = self._session.document.marks, self._shown
        if marks == shown:
            return
        self.draft = {}
        if len(marks) > len(shown):
            self.beginInsertRows(QModelIndex(), len(shown), len(marks) - 1)
            self._shown = marks
            self.endInsertRows()
        elif len(marks) < len(shown):
            self.beginRemoveRows(QModelIndex(), len(marks), len(shown) - 1)
            self._shown = marks
            self.endRemoveRows()
        self._shown = marks
        self.dataChanged.emit(self.index(0, LABEL), self.index(len(marks), len(SIDES)))
