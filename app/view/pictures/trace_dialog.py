"""Trace the outline of what is seen in a picture: set how, and see at once what that gives."""

from functools import partial
from math import log

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QSlider,
    QVBoxLayout,
    QWidget,
)

from app.compute.errands import Errands, Outcome
from app.compute.tracing import LEVEL, Traced, Tracer, TraceSettings
from app.model.marks import Side
from app.view.asking import answers
from app.view.painting.pictures import image_of
from app.view.painting.theme import theme_of
from app.view.pictures.trace_preview import TracePreview
from app.view.wording import words
from app.view.wording.counts import COUNTS
from app.view.wording.plain import Label
from starskel.errors import StarskelError, told
from starskel.files.projects.picture import Picture

FINEST, COARSEST = 0.25, 40.0
"""Ends of the slider that simplifies, in pixels of the picture; each step multiplies by the same factor."""

STEPS = 100

USUAL = 1 / 300
"""How far the outline may stray at first, as a part of the longer side, but at least a pixel."""


class TraceDialog(QDialog):
    """Asks how to trace; the worker traces anew with each change, and only what was found can be taken.

    Attributes
    ----------
    found : Traced or None
        What is traced as everything is set now.
    """

    def __init__(self, picture: Picture, side: Side, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Trace outline"))
        self.found: Traced | None = None
        self._tracer = Tracer(picture)
        self._errands = Errands(self)
        self._errands.done.connect(self._take)
        self._waiting = False
        self._preview = TracePreview(picture, side)
        self._by = self._by_field()
        self._level, self._percent = self._slider("level", 1, 99), Label()
        self._level.setValue(round(100 * LEVEL))
        self._tolerance, self._pixels = self._slider("tolerance", 0, STEPS), Label()
        image = image_of(picture.content)
        self._set_tolerance(max(1.0, USUAL * max(image.width(), image.height())))
        self._several = QCheckBox(self.tr("All parts, not the largest alone"))
        self._holes = QCheckBox(self.tr("Holes"))
        self._holes.setChecked(True)
        self._verdict = Label(wrapped=True)
        self._verdict.setObjectName("verdict")
        self._arrange()
        for signal in (
            self._by.activated,
            self._level.valueChanged,
            self._tolerance.valueChanged,
            self._several.toggled,
            self._holes.toggled,
        ):
            signal.connect(self._trace)
        self._trace()

    @property
    def settings(self) -> TraceSettings:
        """What is set."""
        return TraceSettings(
            self._by.currentData(),
            self._level.value() / 100,
            FINEST * (COARSEST / FINEST) ** (self._tolerance.value() / STEPS),
            self._several.isChecked(),
            self._holes.isChecked(),
        )

    def accept(self) -> None:
        """Take what was found; what is being traced is waited for, with the dialog still open."""
        if self._errands.busy:
            self._waiting = True
        elif self.found is not None:
            super().accept()

    def done(self, result: int) -> None:
        """End the thread with the dialog."""
        self._errands.close()
        super().done(result)

    def _by_field(self) -> QComboBox:
        field = QComboBox()
        for by, text in (
            ("alpha", self.tr("What is opaque")),
            ("dark", self.tr("What is dark")),
            ("light", self.tr("What is light")),
        ):
            field.addItem(text, by)
        field.setCurrentIndex(-1)  # until the picture has told what suggests itself
        return field

    def _slider(self, name: str, low: int, high: int) -> QSlider:
        slider = QSlider(Qt.Orientation.Horizontal)
        slider.setObjectName(name)
        slider.setRange(low, high)
        return slider

    def _set_tolerance(self, pixels: float) -> None:
        self._tolerance.setValue(round(STEPS * log(pixels / FINEST) / log(COARSEST / FINEST)))

    def _arrange(self) -> None:
        kind = QDialogButtonBox.StandardButton
        buttons = answers(self, kind.Ok | kind.Cancel)
        self._ok = buttons.button(kind.Ok)
        self._ok.setText(self.tr("Trace &Outline"))
        layout = QVBoxLayout(self)
        layout.addWidget(self._preview, 1)
        layout.addWidget(self._verdict)
        layout.addLayout(self._form())
        layout.addWidget(buttons)
        self.resize(560, 640)

    def _form(self) -> QFormLayout:
        """Give what can be set, a row each, and beside sliders what they say."""
        form = QFormLayout()
        for label, control, figure in (
            (self.tr("&Trace"), self._by, None),
            (self.tr("T&hreshold"), self._level, self._percent),
            (self.tr("&Simplify"), self._tolerance, self._pixels),
            ("", self._several, None),
            ("", self._holes, None),
        ):
            row = QHBoxLayout()
            row.addWidget(control, 1)
            if figure is not None:
                figure.setMinimumWidth(56)
                row.addWidget(figure)
            name = Label(label)
            name.setBuddy(control)
            control.setAccessibleName(label.replace("&", ""))
            form.addRow(name, row)
        for box in (self._several, self._holes):
            box.setAccessibleName(box.text())
        return form

    @Slot()
    def _trace(self) -> None:
        settings = self.settings
        self._percent.setText(words.figure(f"{self._level.value()} %"))
        self._pixels.setText(self.tr("{pixels} px").format(pixels=words.figure(f"{settings.tolerance:.1f}")))
        self._errands.do(partial(self._tracer.trace, settings))

    @Slot(object)
    def _take(self, outcome: Outcome) -> None:
        self.found = outcome.value
        if self.found is not None:
            self._by.setCurrentIndex(self._by.findData(self.found.by))
            self._preview.show_rings([ring.vertices for ring in self.found.shape.rings])
            self._say(self._counted(self.found), theme_of(self.palette()).muted)
        else:
            self._preview.show_rings(())
            error = outcome.error
            if not isinstance(error, StarskelError):
                error = StarskelError(told("the picture could not be traced"), told("take another picture"))
            self._say(f"✕ {words.sentences(error, ' ')}", theme_of(self.palette()).refused)
        self._ok.setEnabled(self.found is not None)
        if self._waiting:
            self._waiting = False
            self.accept()

    @staticmethod
    def _counted(found: Traced) -> str:
        shape = found.shape
        outlines = len(shape.outlines)
        vertices = COUNTS.vertices(sum(map(len, shape.rings)))
        several = [COUNTS.parts(outlines)] if outlines > 1 else []
        holes = [COUNTS.holes(len(shape) - outlines)] if len(shape) > outlines else []
        return ", ".join((*several, *holes, vertices))

    def _say(self, text: str, colour: str) -> None:
        self._verdict.setText(text)
        self._verdict.setStyleSheet(f"color: {colour}")
