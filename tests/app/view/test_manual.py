"""The manual in its window: every link leads to a page, every picture is there, and words are found."""

import re

import pytest
from PySide6.QtCore import Qt, QUrl
from PySide6.QtWidgets import QMenu, QToolButton

from app.view.manual import CONTENTS, FOLDER, Manual, page_names
from tests.app.driver import Driver


@pytest.fixture
def manual(driver: Driver) -> Manual:
    driver.key(Qt.Key.Key_F1)
    found = driver.window.findChild(Manual)
    assert found is not None
    return found


def test_every_link_shows_its_page(manual: Manual) -> None:
    for name in re.findall(r"\]\(([\w-]+\.md)\)", (FOLDER / CONTENTS).read_text("utf-8")):
        manual.show_contents()
        manual.pages.anchorClicked.emit(QUrl(name))
        assert manual.page == name
        title = (FOLDER / name).read_text("utf-8").splitlines()[0].removeprefix("# ")
        assert manual.pages.toPlainText().startswith(title)


@pytest.mark.parametrize("name", page_names())
def test_every_picture_of_a_page_is_there(name: str) -> None:
    for picture in re.findall(r"!\[[^]]*\]\(([^)]+)\)", (FOLDER / name).read_text("utf-8")):
        assert (FOLDER / picture).stat().st_size < 60_000


KEYS = re.compile(r"`((?:Ctrl\+)?[A-Z]|F\d)`")
README = FOLDER.parents[1] / "README.md"
NAMES = re.compile(r"(?<!\*)\*([A-Z][A-Za-z ]+)\*(?!\*)")


def test_every_key_and_every_command_that_is_named_is_there(driver: Driver) -> None:
    window = driver.window
    actions = window.actions_table.all
    keys = {key.toString() for action in actions for key in action.shortcuts()}
    names = {action.text().rstrip("…") for action in actions}
    names |= {menu.title() for menu in window.findChildren(QMenu)}
    names |= {button.text() for button in window.findChildren(QToolButton)}
    texts = [path.read_text("utf-8") for path in (README, *(FOLDER / name for name in page_names()))]
    named = {name for text in texts for name in NAMES.findall(text)}
    assert len(named) > 5
    assert named <= {name.replace("&", "") for name in names} | {"Pictures alone"}  # what an export can be
    pressed = {key for text in texts for key in KEYS.findall(text)}
    assert len(pressed) > 5
    assert pressed <= keys | {"Ctrl+C"}  # in a terminal


def test_words_are_found_on_other_pages_and_what_is_nowhere_is_told(manual: Manual) -> None:
    manual.search.setText("Helvetica")
    manual.find_next()
    assert manual.page == "print.md"
    assert manual.pages.textCursor().selectedText() == "Helvetica"
    manual.search.setText("no such words")
    manual.find_next()
    assert manual.page == "print.md"
    assert manual.outcome.text() == "Not found"


def test_it_is_opened_once(driver: Driver, manual: Manual) -> None:
    driver.window.actions_table["manual"].trigger()
    assert driver.window.findChildren(Manual) == [manual]
