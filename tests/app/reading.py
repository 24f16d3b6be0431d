"""What is written on widgets: texts that do not fit or were not translated, and controls without a name."""

import re
from collections.abc import Callable, Iterator
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QDockWidget,
    QFontComboBox,
    QGroupBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QProgressBar,
    QScrollArea,
    QScrollBar,
    QTabBar,
    QTableView,
    QToolBar,
    QWidget,
)

from starskel.errors import Told
from starskel.export.formats import FORMATS

CONTROLS = (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QProgressBar,
)
"""What somebody works with; besides, whatever the Tab key reaches."""

FORMAT_NAMES = tuple(each.name for each in FORMATS if not isinstance(each.name, Told))
"""Those of formats that are the same in every language."""

LATIN = re.compile(r"[A-Za-z]{3,}")


def written(root: QWidget) -> Iterator[QWidget]:
    """Give all widgets that are shown, without those that Qt put into others for its own ends."""
    for widget in (root, *root.findChildren(QWidget)):
        if widget.isVisible() and not widget.objectName().startswith("qt_"):
            yield widget


def clipped(root: QWidget) -> list[str]:
    """Name the widgets that are too small for what is written on them."""
    return [f"{_named(w)}: {fault}" for w in written(root) if (fault := _clipping(w))]


def unnamed(root: QWidget) -> list[str]:
    """Name the controls that a screen reader could not name."""
    return [_named(w) for w in written(root) if _is_control(w) and not spoken_name(w)]


def untranslated(root: QWidget, *names: str) -> list[str]:
    """Name the texts with letters that no translator has seen, apart from these names."""
    return [
        f"{_named(w)}: {text!r}"
        for w in written(root)
        for text in _texts(w)
        if LATIN.search(_bare(text, names))
    ]


def spoken_name(widget: QWidget) -> str:
    """Give the name by which a screen reader calls a control."""
    text = widget.text() if isinstance(widget, QAbstractButton) else ""
    return widget.accessibleName() or text.replace("&", "")


def _is_control(widget: QWidget) -> bool:
    part = isinstance(widget, QScrollBar | QHeaderView) or isinstance(
        widget.parent(), QAbstractSpinBox | QComboBox
    )
    editor = isinstance(widget.parent() and widget.parent().parent(), QAbstractItemView)
    tabbed = bool(widget.focusPolicy() & Qt.FocusPolicy.TabFocus) and not isinstance(widget, QScrollArea)
    return (isinstance(widget, CONTROLS) or tabbed) and not part and not editor


def _clipping(widget: QWidget) -> str:
    for kind, look in LOOKS.items():
        if isinstance(widget, kind) and not isinstance(widget, QFontComboBox):
            return look(widget)
    return ""


def _too_narrow(widget: QWidget) -> str:
    needed, texts = widget.sizeHint().width(), _texts(widget)
    return (
        f"{texts[0]!r} needs {needed} and has {widget.width()}" if texts and widget.width() < needed else ""
    )


def _label_clipping(label: QLabel) -> str:
    if not label.text():
        return ""
    if label.wordWrap():
        needed = label.heightForWidth(label.width())
        return f"{label.text()!r} needs {needed} lines of pixels" if label.height() < needed else ""
    return _too_narrow(label)


def _field_clipping(field: QAbstractSpinBox | QLineEdit) -> str:
    line = field.findChild(QLineEdit) if isinstance(field, QAbstractSpinBox) else field
    if line is None or isinstance(field.parent(), QComboBox | QAbstractSpinBox):
        return ""
    text = line.text() if isinstance(field, QAbstractSpinBox) else line.placeholderText()
    needed = line.fontMetrics().horizontalAdvance(text) + 4
    return f"{text!r} needs {needed} and has {line.width()}" if text and line.width() < needed else ""


def _header_clipping(header: QHeaderView) -> str:
    if header.orientation() != Qt.Orientation.Horizontal:
        return ""
    for section in range(header.count()):
        if header.sectionSize(section) < header.sectionSizeHint(section):
            needed, has = header.sectionSizeHint(section), header.sectionSize(section)
            return f"column {section} needs {needed} and has {has}"
    return ""


def _table_clipping(table: QTableView) -> str:
    model = table.model()
    for row in range(model.rowCount()):
        for column in range(model.columnCount()):
            index = model.index(row, column)
            if table.columnWidth(column) < table.sizeHintForIndex(index).width():
                return f"the cell {row}, {column} with {index.data()!r} is cut off"
    return ""


LOOKS: dict[Any, Callable[[Any], str]] = {
    QLabel: _label_clipping,
    QHeaderView: _header_clipping,
    QAbstractSpinBox: _field_clipping,
    QLineEdit: _field_clipping,
    QTableView: _table_clipping,
    (QAbstractButton, QComboBox, QGroupBox, QDockWidget, QTabBar): _too_narrow,
}
"""How each kind of widget is found to be too small."""


def _texts(widget: QWidget) -> list[str]:
    """Give what a person reads on a widget, its tip and its name."""
    texts = [widget.toolTip(), widget.accessibleName()]
    if isinstance(widget, QLabel | QAbstractButton):
        texts.insert(0, widget.text())
    elif isinstance(widget, QComboBox) and not isinstance(widget, QFontComboBox):
        texts = [widget.itemText(k) for k in range(widget.count())] + texts
    elif isinstance(widget, QGroupBox):
        texts.insert(0, widget.title())
    elif isinstance(widget, QTabBar):
        texts += [widget.tabText(k) for k in range(widget.count())]
    elif isinstance(widget, QLineEdit) and not isinstance(widget.parent(), QComboBox | QAbstractSpinBox):
        texts.append(widget.placeholderText())
    elif isinstance(widget, QToolBar | QDockWidget) or widget.isWindow():
        texts.append(widget.windowTitle())
    return [text for text in texts if text]


def _bare(text: str, names: tuple[str, ...]) -> str:
    """Give a text without what is the same in every language: keys, and names given to things."""
    keys = ("Ctrl", "Shift", "Alt", "Backspace", "PgDown", "PgUp", "Down", "Del", "Esc", "Home", "End")
    for name in (*keys, "starskel", *FORMAT_NAMES, *names):
        text = text.replace(name, "")
    return text


def _named(widget: QWidget) -> str:
    return f"{type(widget).__name__} {widget.objectName() or widget.accessibleName()}".strip()
