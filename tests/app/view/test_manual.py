"""The manual in its window: every link leads to a page, every picture is there, and words are found."""

import re

import pytest
from PySide6.QtCore import Qt, QUrl

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
