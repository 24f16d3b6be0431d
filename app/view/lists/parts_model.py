"""The parts as a table: a row for each part and its partner, the one painted last on top."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QByteArray,
    QMimeData,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QRectF,
    QSize,
    Qt,
    Slot,
)
from PySide6.QtGui import QColor, QIcon, QPalette

from app.model.marks import SIDES, Side, other
from app.model.pairing import part_of
from app.session import Session
from app.view.lists.partnering import Partnering
from app.view.painting.drawing import layer_of, painting
from app.view.painting.theme import theme_of
from app.view.painting.thumbnail import paint_thumbnail
from app.view.wording import words
from starskel.files.projects.key_shape import KeyShape, Part
from starskel.files.projects.step import Link

Index = QModelIndex | QPersistentModelIndex

NAME, SOURCE, TARGET = range(3)

DRAGGED = "application/x-starskel-part"
"""What is dragged: the number of a link, and the column."""

ICON = QSize(22, 22)
"""Size of a part's picture, in pixels."""


class PartsModel(QAbstractTableModel):
    """Follows the links of the step on the canvases, and edits them there."""

    def __init__(self, session: Session, partnering: Partnering, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._partnering = partnering
        self._shown: tuple[Link, ...] = ()
        self._looks: tuple[KeyShape, ...] = ()
        self._icons: dict[tuple[Part, Side, str], QIcon] = {}
        session.document_changed.connect(self._follow)
        self._follow()

    def link(self, row: int) -> int:
        """Give the number of the link in a row."""
        return len(self._shown) - 1 - row

    def row(self, link: int) -> int:
        """Give the row of a link."""
        return len(self._shown) - 1 - link

    def part(self, index: Index) -> int | None:
        """Give the part that a cell names, None where there is none."""
        return part_of(self._shown[self.link(index.row())], _side(index.column()))

    def label(self, side: Side, part: int) -> str:
        """Give what a part is called."""
        return words.part(self._session.document.shape(side).parts[part], part)

    def choices(self, index: Index) -> list[tuple[str, int | None]]:
        """Give the parts that a cell may name, and what it says where there is none."""
        side = _side(index.column())
        count = len(self._session.document.shape(side))
        return [*((self.label(side, part), part) for part in range(count)), (_none(side), None)]

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 -- as Qt calls it
        return 0 if parent.isValid() else len(self._shown)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else 3

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = 0) -> Any:
        if orientation != Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        return self.tr("Part") if section == NAME else words.side(_side(section))

    def flags(self, index: Index) -> Qt.ItemFlag:
        usual = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsDropEnabled
        if not index.isValid():
            return Qt.ItemFlag.ItemIsDropEnabled
        if index.column() == NAME:
            more = Qt.ItemFlag.ItemIsUserCheckable | Qt.ItemFlag.ItemIsDragEnabled
            return usual | Qt.ItemFlag.ItemIsEditable | more
        if self.part(index) is not None:
            usual |= Qt.ItemFlag.ItemIsDragEnabled
        partner = part_of(self._shown[self.link(index.row())], other(_side(index.column())))
        return usual if partner is None else usual | Qt.ItemFlag.ItemIsEditable

    def data(self, index: Index, role: int = 0) -> Any:
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.EditRole):
            return self._text(index)
        if role == Qt.ItemDataRole.CheckStateRole and index.column() == NAME:
            shown = any(part.visible for part in self._members(index.row()))
            return Qt.CheckState.Checked if shown else Qt.CheckState.Unchecked
        if role == Qt.ItemDataRole.DecorationRole and index.column() != NAME:
            return self._icon(index)
        if role == Qt.ItemDataRole.ForegroundRole and index.column() != NAME and self.part(index) is None:
            return QPalette().placeholderText()
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._tip(index)
        return None

    def setData(self, index: Index, value: Any, role: int = 0) -> bool:
        link = self.link(index.row())
        if role == Qt.ItemDataRole.CheckStateRole:
            self._partnering.set_shown(link, shown=Qt.CheckState(value) == Qt.CheckState.Checked)
            return True
        if role != Qt.ItemDataRole.EditRole:
            return False
        if index.column() == NAME:
            if value != self._text(index):  # else what was not typed would become the name
                self._partnering.rename(link, str(value).strip())
            return True
        source, target = self._shown[link].ends
        chosen = (value, target) if index.column() == SOURCE else (source, value)
        if value is None:
            self._partnering.leave_alone(link)
        elif chosen[0] is not None and chosen[1] is not None:
            self._partnering.pair(*chosen)
        return True

    # dragging

    def supportedDropActions(self) -> Qt.DropAction:
        return Qt.DropAction.MoveAction | Qt.DropAction.CopyAction

    def mimeTypes(self) -> list[str]:
        return [DRAGGED]

    def mimeData(self, indexes: Sequence[QModelIndex]) -> QMimeData:
        index, dragged = indexes[0], QMimeData()
        content = f"{self.link(index.row())} {index.column()}"
        dragged.setData(DRAGGED, QByteArray(content.encode()))
        return dragged

    def dropMimeData(
        self, data: QMimeData, action: Qt.DropAction, row: int, column: int, parent: Index
    ) -> bool:
        """Take a part that was dropped on a row as partner, with Control besides; a name moves the row."""
        link, dragged = map(int, bytes(data.data(DRAGGED).data()).split())
        to = parent.row() if parent.isValid() else min(row, len(self._shown) - 1)
        if not 0 <= to < len(self._shown) or self.link(to) == link:
            return False
        if dragged == NAME:
            self._partnering.reorder(link, self.link(to))
            return False  # the rows follow the document; Qt is to remove none
        own, there = self._shown[link].ends, self._shown[self.link(to)].ends
        source, target = (own[0], there[1]) if dragged == SOURCE else (there[0], own[1])
        if source is not None and target is not None:
            self._partnering.pair(source, target, besides=action == Qt.DropAction.CopyAction)
        return False

    # what cells show

    def _members(self, row: int) -> list[Part]:
        ends = zip(self._looks, self._shown[self.link(row)].ends, strict=True)
        return [shape.parts[part] for shape, part in ends if part is not None]

    def _text(self, index: Index) -> str:
        if index.column() == NAME:
            return words.link(self._session.document, self.link(index.row()))
        part = self.part(index)
        return _none(_side(index.column())) if part is None else str(part + 1)

    def _icon(self, index: Index) -> QIcon | None:
        """Give a part's picture, the same icon until it looks different: Qt keeps what it painted of each."""
        part, side = self.part(index), _side(index.column())
        if part is None:
            return None
        theme = theme_of(QPalette())
        look = self._looks[SIDES.index(side)].parts[part], side, theme.name
        if look not in self._icons:
            self._icons[look] = _drawn(look[0], theme.side(side), theme.on_accent)
        return self._icons[look]

    def _tip(self, index: Index) -> str:
        if index.column() == NAME:
            return self.tr("Tick to show it, double-click to rename it, drag to change what is painted first")
        if self.part(index) is None:
            return self.tr("This part has no partner: drag one here")
        return self.tr("Drag it onto another row to pair it there; with Control pressed it is paired besides")

    @Slot()
    def _follow(self) -> None:
        document = self._session.document
        links, looks = document.way.links, (document.shape("source"), document.shape("target"))
        if (links, looks) == (self._shown, self._looks):
            return
        parts = {part for shape in looks for part in shape.parts}
        self._icons = {look: icon for look, icon in self._icons.items() if look[0] in parts}
        if len(links) != len(self._shown):
            self.beginResetModel()
            self._shown, self._looks = links, looks
            self.endResetModel()
        else:
            self._shown, self._looks = links, looks
            if links:
                self.dataChanged.emit(self.index(0, NAME), self.index(len(links) - 1, TARGET))


def _side(column: int) -> Side:
    return SIDES[column - SOURCE]


def _drawn(part: Part, usual: QColor, selected: str) -> QIcon:
    """Draw a part in its colour, and in that of the writing where it is selected."""
    icon = QIcon()
    alone = KeyShape((replace(part, colour="", visible=True),))
    for mode, colour in ((QIcon.Mode.Normal, part.colour or usual), (QIcon.Mode.Selected, selected)):
        picture = layer_of(ICON, 2.0)
        with painting(picture) as painter:
            paint_thumbnail(painter, QRectF(0, 0, ICON.width(), ICON.height()), alone, QColor(colour))
        icon.addPixmap(picture, mode)
    return icon


def _none(side: Side) -> str:
    """Say what becomes of a part whose partner is missing on this side."""
    return words.no_partner(side)
