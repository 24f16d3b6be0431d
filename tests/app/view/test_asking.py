"""Dialogs that were answered are gone: nothing of them stays with the window."""

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QDialog, QPushButton, QWidget

from app.view.files import dialogs
from starskel.errors import InvalidFile, told
from tests.app.driver import Driver

ERROR = InvalidFile(told("{path} is damaged", path="a.json"), told("take another"))

PATH = Path("a.json")

QUESTIONS: dict[str, Callable[[QWidget], object]] = {
    "changes": lambda window: dialogs.ask_about_changes(window, "a"),
    "overtaken": lambda window: dialogs.ask_about_overtaking(window, PATH),
    "elsewhere": lambda window: dialogs.ask_for_another_place(window, PATH, ERROR),
    "overwrite": lambda window: dialogs.may_overwrite(window, [PATH]),
    "complaint": lambda window: dialogs.complain(window, "heading", ERROR),
    "save": lambda window: dialogs.path_to_save(window, "Save", "a", [".json"]),
}

COMMANDS = ("export", "find-command", "shortcuts", "about", "part-colour")


def gone(driver: Driver) -> bool:
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    return not driver.window.findChildren(QDialog)


@pytest.mark.parametrize("question", QUESTIONS)
def test_a_question_that_was_answered_is_gone(driver: Driver, question: str) -> None:
    driver.in_dialog(lambda dialog: dialog.close())
    QUESTIONS[question](driver.window)
    assert gone(driver)


def test_buttons_of_questions_are_words_alone(driver: Driver) -> None:
    shown: list[bool] = []

    def look(dialog: QWidget) -> None:
        shown.extend(button.icon().isNull() for button in dialog.findChildren(QPushButton))
        dialog.close()

    driver.in_dialog(look)
    dialogs.ask_about_changes(driver.window, "a")
    assert shown == [True, True, True]


@pytest.mark.parametrize("command", COMMANDS)
def test_the_dialog_of_a_command_is_gone_when_it_was_closed(driver: Driver, command: str) -> None:
    seen: list[QWidget] = []

    def close(dialog: QWidget) -> None:
        seen.append(dialog)
        dialog.close()

    driver.draw_both()
    driver.wait_for_blends()
    driver.in_dialog(close)
    driver.window.actions_table[command].trigger()
    assert seen
    assert gone(driver)
