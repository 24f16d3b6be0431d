"""The list of edits."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.tools.tool import Key
from tests.app.driver import CONTROL, LEFT, PLAIN, Driver


def test_a_click_in_the_history_goes_there(driver: Driver) -> None:
    driver.draw_both()
    driver.mark((10, 10), (10, 10))
    driver.key(Qt.Key.Key_H, CONTROL)
    shown = driver.window.history
    assert shown.isVisible()
    assert [shown.item(row).text() for row in range(shown.count())] == [
        "Opened",
        "Draw shape",
        "Draw shape",
        "Set mark",
    ]
    assert shown.currentRow() == 3
    QTest.mouseClick(shown.viewport(), LEFT, PLAIN, shown.visualItemRect(shown.item(1)).center())
    assert driver.document.target is None
    assert driver.session.redoes == "Draw shape"
    for _ in range(2):
        QTest.keyClick(shown, Qt.Key.Key_Down)
    assert driver.document.marks == ((0, 0),)
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert shown.currentRow() == 2


def test_the_history_greys_out_what_is_undone_and_catches_up_when_it_is_shown(driver: Driver) -> None:
    driver.draw_both()
    shown, command = driver.window.history, driver.window.actions_table["history"]

    def rows() -> list[tuple[str, bool]]:
        items = [shown.item(row) for row in range(shown.count())]
        undone = shown.palette().brush(shown.palette().ColorGroup.Disabled, shown.palette().ColorRole.Text)
        return [(item.text(), item.foreground() == undone) for item in items]

    command.trigger()
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert rows() == [("Opened", False), ("Draw shape", False), ("Draw shape", True)]
    driver.window.actions_table["dark"].trigger()
    assert rows()[2] == ("Draw shape", True)
    command.trigger()
    driver.session.select_all("source")
    driver.session.key(Key("right"))
    driver.session.key(Key("right", alt=True))
    command.trigger()
    assert rows() == [("Opened", False), ("Draw shape", False), ("Nudge vertices", False), ("Turn", False)]
    driver.key(Qt.Key.Key_Z, CONTROL)
    driver.key(Qt.Key.Key_Z, CONTROL)
    assert [undone for _, undone in rows()] == [False, False, True, True]
    driver.window.actions_table["light"].trigger()
