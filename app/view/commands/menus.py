"""Menus and toolbar, filled from the table of commands."""

from collections.abc import Mapping, Sequence

from PySide6.QtCore import QCoreApplication, QSize, Qt
from PySide6.QtGui import QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QMenu, QMenuBar, QToolBar, QToolButton, QWidget

from app.view.commands.actions import Actions, say
from app.view.commands.table import MENUS, PALETTE, TOOLBAR
from app.view.wording import words
from starskel.blending import COMPARED

translate = QCoreApplication.translate


def fill_menu_bar(bar: QMenuBar, actions: Actions, submenus: Mapping[str, QMenu]) -> None:
    """Add all menus; names in the table that are no commands stand for submenus."""
    for title, names in MENUS:
        menu = bar.addMenu(say(title))
        for name in names:
            if not name:
                menu.addSeparator()
            elif name in submenus:
                menu.addMenu(submenus[name])
            else:
                menu.addAction(actions[name])


class CommandBar(QToolBar):
    """A toolbar that leaves out the words beside its icons where the window is too narrow for them."""

    def __init__(self, title: str) -> None:
        super().__init__(title)
        self.setMovable(False)
        self.setIconSize(QSize(20, 20))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._wanted = 0

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        worded = Qt.ToolButtonStyle.ToolButtonTextBesideIcon
        if self.toolButtonStyle() == worded:
            self._wanted = self.sizeHint().width()
        enough = self.width() >= self._wanted
        self.setToolButtonStyle(worded if enough else Qt.ToolButtonStyle.ToolButtonIconOnly)


def tool_bar(actions: Actions, submenus: Mapping[str, QMenu]) -> QToolBar:
    """Give the toolbar; names in the table that are no commands stand for buttons that open a menu."""
    bar = CommandBar(translate("Menus", "Commands"))
    bar.setObjectName("toolbar")
    for name in TOOLBAR:
        if name in submenus:
            bar.addWidget(_menu_button(name, submenus[name]))
        elif name:
            bar.addAction(actions[name])
        else:
            bar.addSeparator()
    return bar


def _menu_button(name: str, menu: QMenu) -> QToolButton:
    button = QToolButton()
    button.setObjectName(f"{name}-button")
    button.setText(menu.title().replace("&", ""))
    button.setMenu(menu)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button


def tool_palette(actions: Actions) -> QToolBar:
    """Give the bar of tools at the left of the window; their names are in their tips and in the menu."""
    bar = QToolBar(translate("Menus", "Drawing Tools"))
    bar.setObjectName("palette")
    bar.setMovable(False)
    bar.setOrientation(Qt.Orientation.Vertical)
    bar.setIconSize(QSize(24, 24))
    for name in PALETTE:
        bar.addAction(actions[name])
    return bar


class SwitchMenu(QMenu):
    """A menu of switches, which stays open while they are clicked one after another."""

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        action = self.actionAt(event.position().toPoint())
        if action is not None and action.isCheckable() and action.isEnabled():
            action.trigger()
        else:
            super().mouseReleaseEvent(event)


def layers_menu(parent: QWidget, actions: Actions, names: Sequence[str]) -> QMenu:
    """Give a menu of the switches of what is shown."""
    menu = SwitchMenu(translate("Menus", "Sh&ow"), parent)
    menu.addActions([actions[name] for name in names])
    return menu


def methods_menu(parent: QWidget) -> QMenu:
    """Give a menu of switches for the methods; each action's data is the method's name."""
    menu = SwitchMenu(translate("Menus", "&Methods"), parent)
    menu.setToolTipsVisible(True)
    for method in COMPARED:
        action = menu.addAction(words.method(method))
        action.setToolTip(words.method_tip(method))
        action.setStatusTip(words.method_tip(method))
        action.setCheckable(True)
        action.setData(method)
    return menu
