"""Looks for names that Qt takes for markup, or for the letter that chooses an entry."""

from collections.abc import Iterator

from PySide6.QtCore import QAbstractItemModel, QAbstractListModel, QModelIndex, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QColorDialog,
    QFileDialog,
    QGroupBox,
    QLabel,
    QTabBar,
    QWidget,
)

NAME = "<b>fat & [*] co"
"""A name like any other."""


def misread(root: QWidget) -> list[str]:
    """Name the places below a widget where a name is not shown as it is."""
    widgets = [root, *root.findChildren(QWidget)]
    return [
        *(f"label: {each.text()}" for each in widgets if isinstance(each, QLabel) and not _plain(each)),
        *(f"tip: {text}" for text in _tips(root, widgets) if "<b>" in text),
        *(f"entry: {text}" for text in _entries(root, widgets) if "& " in text.replace("&&", "")),
        *(f"title: {text}" for text in [root.windowTitle()] if "fat & [*] " in text),
    ]


def shows(root: QWidget) -> bool:
    """Tell whether a name is to be seen at all."""
    widgets = [root, *root.findChildren(QWidget)]
    labels = [each.text() for each in widgets if isinstance(each, QLabel)]
    texts = [*labels, *_tips(root, widgets), *_entries(root, widgets), root.windowTitle(), *_cells(widgets)]
    return any("fat" in text for text in texts)


def _plain(label: QLabel) -> bool:
    """Tell whether a label takes its text as it is; an icon has none, and Qt's own dialogs are its affair."""
    foreign = isinstance(label.window(), QFileDialog | QColorDialog)
    return foreign or not label.text() or label.textFormat() == Qt.TextFormat.PlainText


def _entries(root: QWidget, widgets: list[QWidget]) -> list[str]:
    return [
        *(action.text() for action in root.findChildren(QAction)),
        *(each.text() for each in widgets if isinstance(each, QAbstractButton)),
        *(each.title() for each in widgets if isinstance(each, QGroupBox)),
        *(each.tabText(k) for each in widgets if isinstance(each, QTabBar) for k in range(each.count())),
    ]


def _tips(root: QWidget, widgets: list[QWidget]) -> list[str]:
    return [
        *(each.toolTip() for each in widgets),
        *(action.toolTip() for action in root.findChildren(QAction)),
        *(text for each in widgets for text in _of(each, Qt.ItemDataRole.ToolTipRole)),
    ]


def _cells(widgets: list[QWidget]) -> list[str]:
    return [text for each in widgets for text in _of(each, Qt.ItemDataRole.DisplayRole)]


def _of(widget: QWidget, role: Qt.ItemDataRole) -> Iterator[str]:
    model = widget.model() if isinstance(widget, QAbstractItemView) else None
    for index in () if model is None else _indices(model, QModelIndex()):
        if isinstance(text := index.data(role), str):
            yield text


def _indices(model: QAbstractItemModel, parent: QModelIndex) -> Iterator[QModelIndex]:
    for row in range(model.rowCount(parent)):
        for column in range(1 if isinstance(model, QAbstractListModel) else model.columnCount(parent)):
            yield (index := model.index(row, column, parent))
            yield from _indices(model, index)
