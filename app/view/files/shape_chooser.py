"""Which of the shapes of a file become the source and the target: two lists of small pictures."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QModelIndex, QPersistentModelIndex, QRectF, QSize, Qt, Slot
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from app.model.marks import Side
from app.view.asking import accepted, answers
from app.view.files.word_field import WordField
from app.view.painting.theme import theme_of
from app.view.painting.thumbnail import paint_shape
from app.view.wording import plain, words
from app.view.wording.counts import COUNTS
from app.view.wording.plain import Label
from starskel.reading.named_shape import NamedShape, Reading
from starskel.reading.readers import format_of

translate = QCoreApplication.translate

PICTURE = 56
"""Height of the picture of a shape, in pixels."""

SHAPE = Qt.ItemDataRole.UserRole


class _Rows(QStyledItemDelegate):
    """Paints the picture of a shape before its name, when it is about to be seen."""

    def __init__(self, side: Side, parent: QWidget) -> None:
        super().__init__(parent)
        self._side: Side = side

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> QSize:
        return super().sizeHint(option, index).expandedTo(QSize(0, PICTURE + 8))

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().initStyleOption(option, index)
        option.decorationSize = QSize(PICTURE + 8, PICTURE)
        option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().paint(painter, option, index)
        found: NamedShape | None = index.data(SHAPE)
        if found is not None:
            box = QRectF(option.rect).adjusted(4, 4, 0, -4)
            box.setWidth(PICTURE)
            theme, chosen = theme_of(option.palette), option.state & QStyle.StateFlag.State_Selected
            paint_shape(
                painter, box, found.shape, QColor(theme.on_accent) if chosen else theme.side(self._side)
            )


class ShapeList(QListWidget):
    """The shapes of a file for one canvas; the first row may be that its shape stays."""

    def __init__(self, side: Side, shapes: Sequence[NamedShape], *, optional: bool) -> None:
        super().__init__()
        self.setItemDelegate(_Rows(side, self))
        self.setUniformItemSizes(True)
        self.setAccessibleName(words.side(side))
        if optional:
            self.addItem(translate("ShapeChooser", "Leave as it is"))
        self._word: QListWidgetItem | None = None
        for found in shapes:
            self.addItem(_row(found))

    @property
    def chosen(self) -> NamedShape | None:
        """The shape chosen, None where none is or the one there stays."""
        item = self.currentItem()
        found: NamedShape | None = None if item is None or item.isHidden() else item.data(SHAPE)
        return found

    def put_word(self, found: NamedShape | None) -> None:
        """Show this before all other shapes, in the place of the one put there before, and choose it."""
        first = self.count() - len(self)
        if self._word is not None:
            self.takeItem(self.row(self._word))
            self._word = None
        if found is not None:
            self._word = _row(found)
            self.insertItem(first, self._word)
            self.setCurrentItem(self._word)

    def choose(self, number: int) -> None:
        """Choose a shape by its number."""
        self.setCurrentRow(self.count() - len(self) + number)

    def __len__(self) -> int:
        return sum(self.item(row).data(SHAPE) is not None for row in range(self.count()))

    def narrow(self, text: str) -> None:
        """Show only shapes whose names hold a text, and choose the first of them if need be."""
        for row in range(self.count()):
            item = self.item(row)
            item.setHidden(item.data(SHAPE) is not None and text.casefold() not in item.text().casefold())
        if self.currentItem() is None or self.currentItem().isHidden():
            shown = (row for row in range(self.count()) if not self.item(row).isHidden())
            self.setCurrentRow(next((row for row in shown if self.item(row).data(SHAPE)), -1))


def _row(found: NamedShape) -> QListWidgetItem:
    item = QListWidgetItem(str(words.retold(found.name)))
    item.setData(SHAPE, found)
    item.setToolTip(plain.tip("\n".join([item.text(), *(str(words.retold(own)) for own in found.repairs)])))
    return item


class ShapeChooser(QDialog):
    """Lets the user choose a shape for each of the canvases that get one; of fonts write words, too."""

    def __init__(
        self, path: Path, reading: Reading, sides: Sequence[Side], parent: QWidget, *, optional: bool
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Choose shapes"))
        self.resize(320 * len(sides) + 40, 560)
        heading = Label(COUNTS.shapes_in(path.name, len(reading.shapes)), wrapped=True)
        self._filter = self._filter_field()
        several = optional and len(sides) > 1
        self._lists = {side: ShapeList(side, reading.shapes, optional=several) for side in sides}
        self._mended = {side: Label(wrapped=True) for side in sides}
        writing = sides if format_of(path).module == "font" else ()
        self._words = {side: WordField(path) for side in writing}
        columns = QHBoxLayout()
        for number, (side, own) in enumerate(self._lists.items()):
            columns.addLayout(self._column(side, own))
            own.choose(min(number, len(reading.shapes) - 1))
            own.currentItemChanged.connect(self._follow)
        kind = QDialogButtonBox.StandardButton
        self._buttons = answers(self, kind.Ok | kind.Cancel)
        layout = QVBoxLayout(self)
        layout.addWidget(heading)
        layout.addWidget(self._filter)
        layout.addLayout(columns, 1)
        if reading.notes:
            notes = Label("\n".join(map(words.sentence, reading.notes)), wrapped=True)
            layout.addWidget(notes)
        layout.addWidget(self._buttons)
        next(iter(self._lists.values())).setFocus()
        self._follow()

    def _filter_field(self) -> QLineEdit:
        field = QLineEdit()
        field.setPlaceholderText(self.tr("Filter"))
        field.setAccessibleName(self.tr("Filter"))
        field.setClearButtonEnabled(True)
        field.textChanged.connect(self._narrow)
        return field

    @property
    def chosen(self) -> dict[Side, NamedShape]:
        """What was chosen, for each canvas that gets a shape."""
        found = {side: own.chosen for side, own in self._lists.items()}
        return {side: own for side, own in found.items() if own is not None}

    def _column(self, side: Side, own: ShapeList) -> QVBoxLayout:
        label, mended = Label(words.side(side)), self._mended[side]
        label.setBuddy(own)
        word = self._words.get(side)
        if word is not None:
            word.setAccessibleName(self.tr("Word for: {side}").format(side=words.side(side)))
            word.made.connect(own.put_word)
            word.refused.connect(mended.setText)
            word.pending_changed.connect(self._allow)
            self.finished.connect(word.leave)
        mended.setMinimumHeight(3 * mended.fontMetrics().lineSpacing())
        mended.setAlignment(Qt.AlignmentFlag.AlignTop)
        own.itemDoubleClicked.connect(self.accept)
        column = QVBoxLayout()
        for widget in (label, word, own, mended):
            if widget is not None:
                column.addWidget(widget)
        return column

    @Slot(str)
    def _narrow(self, text: str) -> None:
        for own in self._lists.values():
            own.narrow(text)

    @Slot()
    def _follow(self) -> None:
        """Tell what was mended of the shapes chosen."""
        for side, own in self._lists.items():
            repairs = own.chosen.repairs if own.chosen is not None else ()
            what = "; ".join(str(words.retold(own)) for own in repairs)
            self._mended[side].setText(self.tr("Mended: {what}").format(what=what) if what else "")
        self._allow()

    @Slot()
    def _allow(self) -> None:
        """Let the user go on once what is written has become a shape."""
        pending = any(word.pending for word in self._words.values())
        self._buttons.button(QDialogButtonBox.StandardButton.Ok).setEnabled(bool(self.chosen) and not pending)


def chosen_shapes(
    path: Path, reading: Reading, sides: Sequence[Side], parent: QWidget, *, optional: bool
) -> Mapping[Side, NamedShape] | None:
    """Ask for a shape for each side; None where the user thinks better of it."""
    dialog = ShapeChooser(path, reading, sides, parent, optional=optional)
    return dialog.chosen if accepted(dialog) else None
