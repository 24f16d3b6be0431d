"""The table of marks, by the keyboard alone."""

from functools import partial

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel

from app.tools.verbs.marks import set_mark
from tests.app.driver import CONTROL, SQUARE, Driver

KEYS = {"tab": Qt.Key.Key_Tab, "enter": Qt.Key.Key_Return, "up": Qt.Key.Key_Up, "down": Qt.Key.Key_Down}


@pytest.fixture
def table(driver: Driver) -> Driver:
    driver.draw_both()
    driver.key(Qt.Key.Key_T, CONTROL)
    driver.wait(driver.window.marks.table.hasFocus)
    return driver


def type_in(*words: str) -> None:
    """Press keys by name, or type digits, wherever the focus is."""
    QTest.qWait(10)
    for word in words:
        for key in [KEYS[word]] if word in KEYS else [ord(digit) for digit in word]:
            widget = QApplication.focusWidget()
            assert widget is not None
            QTest.keyClick(widget, Qt.Key(key))
            QTest.qWait(10)  # an editor takes in what was typed when its key has been dealt with


def set_in(driver: Driver, source: int, target: int) -> None:
    driver.session.edit(partial(set_mark, source=source, target=target))


def message(driver: Driver) -> str:
    label = driver.window.findChild(QLabel, "marks-message")
    assert label is not None
    return label.text() if label.isVisible() else ""


def test_marks_are_typed_one_after_another(table: Driver) -> None:
    type_in("0", "tab", "0", "enter")
    assert table.document.marks == ((0, 0),)
    type_in("2", "tab", "2", "enter")
    assert table.document.marks == ((0, 0), (2, 2))


def test_a_number_is_changed_and_undo_brings_it_back(table: Driver) -> None:
    set_in(table, 0, 0)
    set_in(table, 1, 1)
    type_in("up", "tab", "2", "enter")
    assert table.document.marks == ((0, 0), (1, 2))
    table.key(Qt.Key.Key_Z, CONTROL)
    assert table.document.marks == ((0, 0), (1, 1))


def test_delete_removes_the_mark_and_no_vertex(table: Driver) -> None:
    set_in(table, 0, 0)
    set_in(table, 1, 1)
    type_in("up", "up")
    table.key(Qt.Key.Key_Delete)
    assert table.document.marks == ((1, 1),)
    assert table.corners("source") == [list(corner) for corner in SQUARE]


def test_a_conflict_and_a_missing_vertex_are_explained(table: Driver) -> None:
    set_in(table, 0, 0)
    set_in(table, 1, 2)
    assert message(table) == ""
    set_in(table, 2, 1)
    assert "from mark" in message(table)
    assert "new mark 3 c" in message(table)
    set_in(table, 77, 1)
    assert "77" in message(table)
    assert table.document.marks == ((0, 0), (1, 2))
    QApplication.processEvents()  # both canvases paint what was refused


def test_the_row_points_at_its_vertices(table: Driver) -> None:
    set_in(table, 0, 1)
    table.wait_for_blends()
    type_in("up", "tab")
    assert table.session.pointed is not None
    matched = table.session.matched_vertex
    assert matched is not None
    assert (matched.source_vertex, matched.target_vertex) == (0, 1)


def test_tab_leaves_the_table_at_its_end(table: Driver) -> None:
    for _ in range(8):
        type_in("tab")
        if not table.window.marks.table.hasFocus():
            break
    assert not table.window.marks.table.hasFocus()


def test_the_table_is_closed_by_the_same_key(table: Driver) -> None:
    table.key(Qt.Key.Key_T, CONTROL)
    assert not table.window.marks.isVisible()
    assert not table.window.actions_table["marks"].isChecked()


def test_a_mark_has_the_same_icon_whenever_it_is_painted(table: Driver) -> None:
    set_in(table, 0, 0)
    model = table.window.marks.table.model()
    first, *others = [
        [model.index(row, 0).data(Qt.ItemDataRole.DecorationRole).cacheKey() for row in range(2)]
        for _ in range(3)
    ]
    assert others == [first, first]
    assert len(set(first)) == 2
