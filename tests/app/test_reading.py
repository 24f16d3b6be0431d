"""The checks of what is written find what they are there to find."""

import pytest
from PySide6.QtWidgets import QCheckBox, QLabel, QPushButton, QSpinBox, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from tests.app.pseudo import lengthened
from tests.app.reading import clipped, unnamed, untranslated


@pytest.fixture
def panel(qtbot: QtBot) -> QWidget:
    panel = QWidget()
    QVBoxLayout(panel)
    qtbot.addWidget(panel)
    return panel


def put(panel: QWidget, *parts: QWidget) -> None:
    layout = panel.layout()
    assert layout is not None
    for part in parts:
        layout.addWidget(part)
    panel.show()


def test_a_text_that_does_not_fit_is_found(panel: QWidget) -> None:
    label, box = QLabel("much to say"), QCheckBox("much to choose")
    put(panel, label, box, QLabel("fits"))
    assert not clipped(panel)
    for narrow in (label, box):
        narrow.setFixedWidth(30)
    panel.adjustSize()
    assert len(clipped(panel)) == 2


def test_a_control_without_a_name_is_found(panel: QWidget) -> None:
    named, nameless = QSpinBox(), QSpinBox()
    named.setAccessibleName("how many")
    put(panel, named, nameless, QPushButton("Go"))
    assert len(unnamed(panel)) == 1


def test_a_text_that_nobody_translated_is_found(panel: QWidget) -> None:
    put(panel, QLabel(lengthened("Translated {count}")), QLabel("forgotten"), QLabel("bird.json"))
    assert len(untranslated(panel, "bird.json", "count")) == 1


def test_the_pseudo_language_keeps_what_programs_read() -> None:
    assert lengthened("&Open {name}…") == "&Oṕéń {name}…··"
