"""German is complete and agrees with the English texts; both languages load, from whatever is chosen."""

import re
import runpy
import shutil
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import pytest
from PySide6.QtCore import QLocale, QTranslator
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QMenu, QWidget

import app
from app.model.document import Document
from app.view.main_window import MainWindow
from app.view.wording import language, words
from app.view.wording.counts import COUNTS
from app.view.wording.verdicts import summaries
from starskel.errors import InvalidFile, StarskelError, either, told
from starskel.files.projects.examples import resource_folder
from starskel.polygon import Polygon
from tests.app.driver import Driver
from tests.app.view.wording.test_verdicts import STILL

FOLDER = resource_folder() / "translations"
SCRIPT = Path(__file__).parents[4] / ".ci" / "translations.py"
NAMES = re.compile(r"\{[^}]*\}|%n|\(\*[^)]*\)")


ONLY_FOR_PROGRAMS = (
    "the shapely Polygon has holes",
    "points of shape",
    "there is no example",
    "give a shapely Polygon",
    "the pair is of regions",
)
"""Errors that nobody at the editor meets."""


class Message(NamedTuple):
    context: str
    source: str
    translations: tuple[str, ...]
    finished: bool


def messages(path: Path) -> list[Message]:
    return [
        Message(
            context.findtext("name", ""),
            message.findtext("source", ""),
            tuple(form.text or "" for form in message.iter("numerusform"))
            or (message.findtext("translation", ""),),
            message.find("translation").get("type") is None,  # type: ignore[union-attr] # every message has one
        )
        for context in ElementTree.parse(path).getroot().iter("context")
        for message in context.iter("message")
    ]


GERMAN = messages(FOLDER / "starskel_de.ts")


@pytest.fixture
def german(qapp: QApplication) -> Iterator[None]:
    loaded = language.speak(qapp, "de")
    yield
    for translator in loaded:
        qapp.removeTranslator(translator)
    QLocale.setDefault(QLocale.c())


def test_the_translations_hold_exactly_the_texts_of_the_code(tmp_path: Path) -> None:
    """`make translations` mends it."""
    for file in FOLDER.glob("*.ts"):
        shutil.copy(file, tmp_path)
    runpy.run_path(str(SCRIPT))["main"](tmp_path)
    for file in FOLDER.glob("*.ts"):
        assert messages(tmp_path / file.name) == messages(file)


def test_every_text_is_translated() -> None:
    assert [
        message.source for message in GERMAN if not message.finished or not all(message.translations)
    ] == []


def test_every_error_of_the_editor_can_be_told_in_another_language() -> None:
    """As those of reading and writing files can, and of polygons and marks, which its users meet."""
    library = SCRIPT.parents[1] / "starskel"
    met = [
        library / "polygon.py",
        library / "triangulation.py",
        library / "files",
        library / "correspondence",
    ]
    parts = [Path(app.__file__).parent, *met]
    files = [file for part in parts for file in ([part] if part.is_file() else sorted(part.rglob("*.py")))]
    untold = re.compile(r"(?:Invalid\w+|StarskelError)\(\s*f?[\"'].*")
    found = [fault for file in files for fault in untold.findall(file.read_text("utf-8"))]
    assert [fault for fault in found if not any(text in fault for text in ONLY_FOR_PROGRAMS)] == []


def test_translations_take_the_same_values_and_end_alike() -> None:
    for _, source, translations, _ in GERMAN:
        for translation in translations:
            assert sorted(NAMES.findall(source)) == sorted(NAMES.findall(translation)), source
            assert ("&" in source) == ("&" in translation), source
            for end in ("…", ".", ":"):
                assert source.endswith(end) == translation.endswith(end), source


@pytest.mark.parametrize("code", language.LANGUAGES)
def test_what_is_compiled_is_what_is_written(code: str) -> None:
    translator = QTranslator()
    assert translator.load(str(FOLDER / f"starskel_{code}.qm"))
    for context, source, translations, _ in messages(FOLDER / f"starskel_{code}.ts"):
        for count, translation in zip((1, 2), translations, strict=False):
            assert translator.translate(context, source, "", count) == translation


@pytest.mark.parametrize(
    ("choice", "locale", "expected"),
    [
        ("system", "de_AT", "de"),
        ("system", "en_GB", "en"),
        ("system", "fr_FR", "en"),
        ("de", "en_GB", "de"),
        ("en", "de_DE", "en"),
    ],
)
def test_the_language_spoken_is_the_chosen_one_or_the_systems(
    choice: str, locale: str, expected: str
) -> None:
    assert language.spoken(choice, QLocale(locale)) == expected


def test_a_choice_is_kept_for_the_next_start(window: MainWindow) -> None:
    assert language.chosen() == language.SYSTEM
    window.actions_table["language-de"].trigger()
    assert language.chosen() == "de"
    assert "next start" in window.statusBar().currentMessage()


@pytest.mark.usefixtures("german")
def test_a_window_in_german(request: pytest.FixtureRequest) -> None:
    window: MainWindow = request.getfixturevalue("window")
    assert [menu.text() for menu in window.menuBar().actions()][:2] == ["&Datei", "&Bearbeiten"]
    assert window.actions_table["draw"].statusTip() == "Eine Form Eckpunkt für Eckpunkt zeichnen"
    assert COUNTS.vertices(1) == "1 Eckpunkt"
    assert COUNTS.vertices(3) == "3 Eckpunkte"
    assert summaries(STILL)[0] == "bewiesen kreuzungsfrei, Fläche 0,0 %"


@pytest.mark.usefixtures("german")
def test_errors_of_the_library_are_told_in_german() -> None:
    with pytest.raises(StarskelError) as caught:
        Polygon([(0, 0), (1, 0), (2, 0)])
    assert words.reason(caught.value, Document()) == (
        "Alle Eckpunkte liegen auf einer Geraden: die Fläche ist null. "
        "Rücken Sie einen Eckpunkt von der Geraden weg."
    )
    where = told("{where}: {what}", where=told("source"), what=told("{path} holds no pair", path="a.json"))
    assert words.retold(where) == "Quelle: a.json enthält kein Paar"
    assert words.retold(either([".svg", ".eps"])) == ".svg oder .eps"


def test_a_sentence_begins_with_a_capital_but_a_name_stays_as_it_is() -> None:
    error = InvalidFile(
        told("{path} holds no pair", path="a.json"), told("give a file with at least one pair")
    )
    assert words.sentences(error, " ") == "a.json holds no pair. Give a file with at least one pair."
    where = told(
        "{where}: {what}", where=told("source (p)"), what=told("{path} holds no pair", path="a.json")
    )
    assert words.sentences(StarskelError(where), " ") == "Source (p): a.json holds no pair."


@pytest.mark.usefixtures("german")
def test_numbers_have_a_decimal_comma_in_german() -> None:
    assert words.figure("0.1-0.3, 0.5, ...") == "0,1-0,3; 0,5; …"
    assert words.figure(".39") == "0,39"


@pytest.mark.parametrize("code", language.LANGUAGES)
def test_no_two_entries_of_a_menu_have_the_same_mnemonic(
    qapp: QApplication, code: str, request: pytest.FixtureRequest
) -> None:
    loaded = language.speak(qapp, code)
    window: MainWindow = request.getfixturevalue("window")
    bar = window.menuBar()
    assert [twice(menu) for menu in (bar, *bar.findChildren(QMenu)) if twice(menu)] == []
    for translator in loaded:
        qapp.removeTranslator(translator)
    QLocale.setDefault(QLocale.c())


@pytest.mark.parametrize("code", language.LANGUAGES)
def test_no_two_fields_of_a_dialog_have_the_same_mnemonic(
    qapp: QApplication, code: str, request: pytest.FixtureRequest
) -> None:
    loaded = language.speak(qapp, code)
    driver: Driver = request.getfixturevalue("driver")
    driver.window.files.open_example("arm")
    driver.wait_for_blends()
    found: dict[str, list[str]] = {}

    def look(dialog: QWidget) -> None:
        named = (*dialog.findChildren(QLabel), *dialog.findChildren(QAbstractButton))
        found[type(dialog).__name__] = alike(widget.text() for widget in named)
        dialog.close()

    for name in ("export", "shortcuts", "about"):
        driver.in_dialog(look)
        driver.window.actions_table[name].trigger()
    assert found == {"ExportDialog": [], "ShortcutsDialog": [], "AboutDialog": []}
    for translator in loaded:
        qapp.removeTranslator(translator)
    QLocale.setDefault(QLocale.c())


def twice(menu: QWidget) -> list[str]:
    """Give the entries of a menu, or of the bar, whose letter another one has too."""
    return alike(action.text() for action in menu.actions())


def alike(texts: Iterable[str]) -> list[str]:
    """Give the texts whose letter another one has too."""
    texts = [text for text in texts if "&" in text]
    letters = [text[text.index("&") + 1].lower() for text in texts]
    return [text for text, letter in zip(texts, letters, strict=True) if letters.count(letter) > 1]
