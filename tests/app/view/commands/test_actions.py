import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAccessible, QAction, QKeySequence
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QMenu,
    QScrollBar,
    QToolBar,
    QToolButton,
    QWidget,
)

from app.view.canvas.canvas import Canvas
from app.view.commands.table import COMMANDS, MENUS, TOOLBAR
from app.view.main_window import MainWindow
from app.view.painting.theme import DARK, LIGHT, Theme, apply_theme

SUBMENUS = {"methods", "layers"}

ASKING = {
    "quit",
    "open",
    "import",
    "save",
    "save-as",
    "recover",
    "export",
    "picture-open",
    "find-command",
    "shortcuts",
    "about",
}


def menu_actions(menu: QMenu) -> list[QAction]:
    return [
        inner
        for action in menu.actions()
        for inner in (menu_actions(action.menu()) if action.menu() else [action])
    ]


def test_every_command_is_in_exactly_one_menu(window: MainWindow) -> None:
    shown = [name for _, names in MENUS for name in names if name]
    for command in COMMANDS:
        assert shown.count(command.name) == 1
    assert {name for name in TOOLBAR if name} - SUBMENUS <= {command.name for command in COMMANDS}
    in_menus = [a for top in window.menuBar().actions() for a in menu_actions(top.menu())]
    for command in COMMANDS:
        assert window.actions_table[command.name] in in_menus


def test_a_screen_reader_finds_every_command_in_the_menus_with_its_name(window: MainWindow) -> None:
    told = {name for menu in window.menuBar().findChildren(QMenu) for name in names_told(menu)}
    for command in COMMANDS:
        action = window.actions_table[command.name]
        assert action.text().replace("&", "") in told
        assert action.toolTip()
        assert action.statusTip()


def names_told(menu: QMenu) -> list[str]:
    """Give what a screen reader says of the entries of a menu."""
    told = QAccessible.queryAccessibleInterface(menu)
    entries = [told.child(k) for k in range(told.childCount())]
    return [entry.text(QAccessible.Text.Name) for entry in entries]


def test_every_command_is_reached_by_the_keyboard(window: MainWindow) -> None:
    """By a shortcut, or by the letters of its menu and its entry."""
    for top in window.menuBar().actions():
        assert "&" in top.text()
        for action in top.menu().actions():
            assert action.isSeparator() or "&" in action.text(), action.text()


def test_a_button_that_shows_only_an_icon_tells_what_it_does(window: MainWindow) -> None:
    for button in window.findChildren(QToolButton):
        drawn_alone = button.toolButtonStyle() == Qt.ToolButtonStyle.ToolButtonIconOnly and button.icon()
        if drawn_alone and not button.objectName().startswith("qt_"):
            assert not button.icon().isNull(), button.toolTip()
            assert button.toolTip()
            assert QAccessible.queryAccessibleInterface(button).text(QAccessible.Text.Name)


def test_a_toolbar_too_narrow_for_words_keeps_all_its_buttons(window: MainWindow) -> None:
    bar = window.findChild(QToolBar, "toolbar")
    assert bar is not None
    window.resize(2000, 800)
    QApplication.processEvents()
    wanted = bar.sizeHint().width()
    window.resize(window.minimumSizeHint().width(), 800)
    bar.resize(wanted - 1, bar.height())
    QApplication.processEvents()
    buttons = [bar.widgetForAction(action) for action in bar.actions() if not action.isSeparator()]
    assert bar.toolButtonStyle() == Qt.ToolButtonStyle.ToolButtonIconOnly
    assert bar.sizeHint().width() < wanted
    assert all(button.isVisible() for button in buttons)
    window.resize(2000, 800)
    QApplication.processEvents()
    assert bar.toolButtonStyle() == Qt.ToolButtonStyle.ToolButtonTextBesideIcon


def test_icons_are_drawn_for_screens_of_twice_the_density(window: MainWindow) -> None:
    for command in COMMANDS:
        drawn = window.actions_table[command.name].icon()
        if not drawn.isNull():
            assert drawn.pixmap(QSize(24, 24), 2.0).size() == QSize(48, 48)


def test_no_shortcut_is_given_twice() -> None:
    keys = [QKeySequence(keys).toString() for command in COMMANDS for keys in command.keys]
    assert all(keys)
    assert len(keys) == len(set(keys))


@pytest.mark.parametrize("command", [c.name for c in COMMANDS if c.name not in ASKING])
def test_every_command_can_be_given_at_any_time(window: MainWindow, command: str) -> None:
    window.actions_table[command].trigger()


def test_every_control_has_an_accessible_name(window: MainWindow) -> None:
    kinds = (QAbstractButton, QAbstractSlider, QAbstractSpinBox, QComboBox, Canvas)
    for control in window.findChildren(QWidget):
        part_of_another = control.objectName().startswith("qt_") or isinstance(control, QScrollBar)
        if isinstance(control, kinds) and not part_of_another:
            named = control.accessibleName() or (isinstance(control, QAbstractButton) and control.text())
            assert named, f"{control} has no accessible name"


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda theme: theme.name)
def test_writing_stands_out_from_its_ground(theme: Theme) -> None:
    """Contrast of at least 4.5 to 1 (WCAG 2.2, success criterion 1.4.3)."""
    for colour in (theme.text, theme.muted, theme.refused, theme.simple):
        for ground in (theme.window, theme.base):
            assert contrast(colour, ground) >= 4.5, (colour, ground)
    assert contrast(theme.on_accent, theme.accent) >= 4.5
    for pin in theme.pins:
        assert contrast("#ffffff", pin) >= 4.5, pin


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda theme: theme.name)
def test_lines_stand_out_from_the_canvas(theme: Theme) -> None:
    """Contrast of at least 3 to 1 (WCAG 2.2, success criterion 1.4.11)."""
    for colour in (theme.source, theme.middle, theme.target, theme.accent, *theme.methods):
        assert contrast(colour, theme.base) >= 3, colour


def test_the_theme_is_switched_from_the_menu(window: MainWindow, qapp) -> None:  # type: ignore[no-untyped-def]
    light = window.grab().toImage()
    window.actions_table["dark"].trigger()
    qapp.processEvents()
    assert window.grab().toImage() != light
    assert window.actions_table["dark"].isChecked()
    window.actions_table["light"].trigger()
    qapp.processEvents()
    assert window.grab().toImage() == light
    apply_theme(qapp, LIGHT)


def contrast(first: str, second: str) -> float:
    a, b = sorted((luminance(first), luminance(second)))
    return (b + 0.05) / (a + 0.05)


def luminance(colour: str) -> float:
    channels = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
