"""Pages of the options bar, one a tool."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import log
from typing import Any

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QFontComboBox,
    QHBoxLayout,
    QLineEdit,
    QSlider,
    QSpinBox,
    QWidget,
)

from app.session import Session
from app.tools.settings import ToolSettings
from app.view.canvas.options.lettering import lettering
from app.view.wording.counts import COUNTS
from app.view.wording.plain import Label
from app.view.wording.words import figure

FINEST, COARSEST = 0.5, 40.0
"""Ends of the slider for the tolerance, in pixels; it grows by the same factor from step to step."""

STEPS = 100


@dataclass(frozen=True)
class NumberField:
    """A number to be set.

    Attributes
    ----------
    label : str
    name : str
        Of the setting.
    low, high : int
    suffix : str
    factor : float
        What one unit of the field is in the setting.
    """

    label: str
    name: str
    low: int
    high: int
    suffix: str = ""
    factor: float = 1


class Page(QWidget):
    """Options in a row; numbers first, as told by the fields."""

    left = Signal()
    """A number was entered: the keys belong to the canvas again."""

    def __init__(self, session: Session, *fields: NumberField) -> None:
        super().__init__()
        self.session = session
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(6)
        self._followers: list[Callable[[ToolSettings], None]] = []
        self._row.addStretch(1)
        for field in fields:
            self._add_field(field)

    def follow(self) -> None:
        """Show the settings as they are."""
        for follower in self._followers:
            follower(self.session.settings)

    def set(self, **values: Any) -> None:
        """Change some of the settings."""
        self.session.set(replace(self.session.settings, **values))

    def add(self, label: str, control: QWidget) -> None:
        """Put a control and its label behind those there are."""
        for line in control.findChildren(QLineEdit):
            line.returnPressed.connect(self.left)
        writing = Label(label)
        writing.setBuddy(control)
        control.setAccessibleName(label)
        control.setObjectName(control.objectName() or label)
        for widget in (writing, control):
            self._row.insertWidget(self._row.count() - 1, widget)

    def add_note(self, note: Label) -> None:
        """Put writing behind what there is."""
        self._row.insertWidget(self._row.count() - 1, note)

    def follow_with(self, follower: Callable[[ToolSettings], None]) -> None:
        """Call this with the settings whenever they are to be shown."""
        self._followers.append(follower)
        follower(self.session.settings)

    def _add_field(self, field: NumberField) -> None:
        kind = type(getattr(self.session.settings, field.name))
        box = QSpinBox()
        box.setObjectName(field.name)
        box.setRange(field.low, field.high)
        box.setSuffix(field.suffix)
        self.add(field.label, box)
        self.follow_with(lambda settings: box.setValue(round(getattr(settings, field.name) / field.factor)))
        box.valueChanged.connect(lambda value: self.set(**{field.name: kind(value * field.factor)}))


class TolerancePage(Page):
    """How far a simplified outline may leave the drawn one, and how many vertices that gives."""

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._slider = QSlider(Qt.Orientation.Horizontal)
        self._slider.setObjectName("tolerance")
        self._slider.setRange(0, STEPS)
        self._slider.setFixedWidth(180)
        self._figure, self._count = Label(), Label()
        self.add(self.tr("Tolerance"), self._slider)
        self.add_note(self._figure)
        self.add_note(self._count)
        self.follow_with(self._show)
        self._slider.valueChanged.connect(self._take)
        session.document_changed.connect(self._show_count)
        self._show_count()

    @Slot(int)
    def _take(self, step: int) -> None:
        self.set(tolerance=FINEST * (COARSEST / FINEST) ** (step / STEPS))

    def _show(self, settings: ToolSettings) -> None:
        step = STEPS * log(settings.tolerance / FINEST) / log(COARSEST / FINEST)
        self._slider.setValue(round(step))
        self._figure.setText(self.tr("{pixels} px").format(pixels=figure(f"{settings.tolerance:.1f}")))

    @Slot()
    def _show_count(self) -> None:
        session = self.session
        count = len(session.document.vertices(session.selection.side))
        self._count.setText(COUNTS.vertices(count) if count else "")


class TextPage(Page):
    """Text, font and size."""

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._text = QLineEdit(session.settings.text)
        self._text.setObjectName("text")
        self._text.setFixedWidth(140)
        self._font = QFontComboBox()
        self._font.setFontFilters(QFontComboBox.FontFilter.ScalableFonts)
        self._font.setObjectName("font")
        self._font.setFixedWidth(190)
        self.add(self.tr("Text"), self._text)
        self.add(self.tr("Font"), self._font)
        self._add_field(NumberField(self.tr("Size"), "size", 1, 10_000))
        self._text.textChanged.connect(self._set_letters)
        self._font.currentFontChanged.connect(self._set_letters)

    def showEvent(self, event: QShowEvent) -> None:
        """Be ready for typing; the outlines are made only now, for fonts take a moment to load."""
        if not self.session.settings.lettering.rings:
            self._set_letters()
        self._text.setFocus()
        self._text.selectAll()

    @Slot()
    def _set_letters(self) -> None:
        text, font = self._text.text(), self._font.currentFont().family()
        self.set(text=text, font=font, lettering=lettering(text, font))
