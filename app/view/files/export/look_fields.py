"""How exported frames look: what they are filled with, their outline, what is behind and around them."""

from enum import Enum

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QCheckBox, QComboBox, QFormLayout, QHBoxLayout, QWidget

from app.view.files.export.colour_button import ColourButton
from app.view.wording.decimal_field import DecimalField
from starskel.sheet.drawing import Stroke
from starskel.sheet.style import INK, OUTLINE, PAPER, USUAL, WAY, Look


class Fill(Enum):
    """What frames are filled with."""

    USUAL = 0
    OWN = 1
    NONE = 2


class LookFields(QWidget):
    """Asks for a `Look`; lengths are points."""

    def __init__(self) -> None:
        super().__init__()
        self._fill = QComboBox()
        self._fill.addItem(self.tr("Usual colours"), Fill.USUAL)
        self._fill.addItem(self.tr("Own colours"), Fill.OWN)
        self._fill.addItem(self.tr("Nothing"), Fill.NONE)
        self._first = ColourButton(WAY[0], self.tr("Colour of the source"))
        self._last = ColourButton(WAY[-1], self.tr("Colour of the target"))
        self._outlined = QCheckBox(self.tr("Outline"))
        self._outlined.setChecked(True)
        self._stroke = ColourButton(INK, self.tr("Colour of the outline"))
        self._width = self._length(OUTLINE.width, 0.1, 20, 0.1)
        self._papered = QCheckBox(self.tr("Paper"))
        self._papered.setToolTip(self.tr("Else nothing is behind; sheets and video are white"))
        self._paper = ColourButton(PAPER, self.tr("Colour of the paper"))
        self._margin = self._length(USUAL.margin, 0, 200, 1)
        self._gap = self._length(USUAL.gap, 0, 200, 1)
        self._gap.setToolTip(self.tr("Of frames in a row, in a sheet, or side by side"))
        self._size = self._length(0, 0, 2000, 10)
        self._size.setSpecialValueText(self.tr("usual"))
        self._size.setToolTip(self.tr("The longer side of the largest frame"))
        self._captions = QCheckBox(self.tr("Times below"))
        self._captions.setChecked(True)
        self._signs = QCheckBox(self.tr("Signs where frames cross themselves"))
        self._signs.setChecked(True)
        self._arrange()
        self._fill.currentIndexChanged.connect(self._follow)
        self._outlined.toggled.connect(self._follow)
        self._papered.toggled.connect(self._follow)
        self._follow()

    @property
    def look(self) -> Look:
        """What was chosen."""
        fills = {Fill.USUAL: WAY, Fill.OWN: (self._first.colour, self._last.colour), Fill.NONE: ()}
        outline = Stroke(self._stroke.colour, self._width.value()) if self._outlined.isChecked() else None
        return Look(
            colours=fills[self._fill.currentData()],
            outline=outline,
            paper=self._paper.colour if self._papered.isChecked() else None,
            gap=self._gap.value(),
            margin=self._margin.value(),
            size=self._size.value() or None,
            signs=self._signs.isChecked(),
            captions=self._captions.isChecked(),
        )

    def begin_with(self, look: Look) -> None:
        """Show a look that was chosen before."""
        fill = Fill.USUAL if look.colours == WAY else Fill.OWN if look.colours else Fill.NONE
        self._fill.setCurrentIndex(fill.value)
        if fill is Fill.OWN:
            self._first.take(look.colours[0])
            self._last.take(look.colours[-1])
        self._outlined.setChecked(look.outline is not None)
        if look.outline is not None:
            self._stroke.take(look.outline.colour)
            self._width.setValue(look.outline.width)
        self._papered.setChecked(look.paper is not None)
        self._paper.take(look.paper or PAPER)
        for field, length in (
            (self._margin, look.margin),
            (self._gap, look.gap),
            (self._size, look.size or 0),
        ):
            field.setValue(length)
        self._signs.setChecked(look.signs)
        self._captions.setChecked(look.captions)

    def _arrange(self) -> None:
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        self._width.setAccessibleName(self.tr("Width of the outline"))
        for label, fields in (
            (self.tr("F&illed with"), (self._fill, self._first, self._last)),
            ("", (self._outlined, self._stroke, self._width)),
            ("", (self._papered, self._paper)),
            (self.tr("Ma&rgin"), (self._margin,)),
            (self.tr("&Between frames"), (self._gap,)),
            (self.tr("Largest &frame"), (self._size,)),
            ("", (self._captions,)),
            ("", (self._signs,)),
        ):
            row = QHBoxLayout()
            for field in fields:
                row.addWidget(field)
                name = label or (field.text() if isinstance(field, QCheckBox) else "")
                field.setAccessibleName(field.accessibleName() or name.replace("&", ""))
            row.addStretch()
            form.addRow(label, row)
            if label and (caption := form.labelForField(row)) is not None:
                caption.setBuddy(fields[0])  # type: ignore[attr-defined]

    def _length(self, value: float, least: float, most: float, step: float) -> DecimalField:
        field = DecimalField()
        field.setRange(least, most)
        field.setSingleStep(step)
        field.setDecimals(1)
        field.setSuffix(self.tr(" pt"))
        field.setValue(value)
        return field

    @Slot()
    def _follow(self) -> None:
        for button in (self._first, self._last):
            button.setEnabled(self._fill.currentData() is Fill.OWN)
        for field in (self._stroke, self._width):
            field.setEnabled(self._outlined.isChecked())
        self._paper.setEnabled(self._papered.isChecked())
