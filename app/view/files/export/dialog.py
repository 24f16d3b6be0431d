"""What to export: keyframes, pages, a sheet of all methods, what moves, or coordinates."""

from collections.abc import Sequence

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, Qt, Slot
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from app.export import FORMATS, Choice, ExportedStep, Layout
from app.view.asking import answers
from app.view.files.export.look_fields import LookFields
from app.view.files.export.motion_fields import MotionFields
from app.view.files.export.overlay_fields import OverlayFields
from app.view.files.export.times_field import TimesField
from app.view.painting.display import Display
from app.view.timeline.player import Player
from app.view.wording import words
from app.view.wording.decimal_field import DecimalField
from app.view.wording.plain import Label

_LAYOUTS: tuple[tuple[Layout, object], ...] = (
    ("row", QT_TRANSLATE_NOOP("ExportDialog", "Keyframes in a row")),
    ("frame", QT_TRANSLATE_NOOP("ExportDialog", "One frame")),
    ("pages", QT_TRANSLATE_NOOP("ExportDialog", "Each keyframe by itself")),
    ("sheet", QT_TRANSLATE_NOOP("ExportDialog", "All methods side by side")),
    ("animation", QT_TRANSLATE_NOOP("ExportDialog", "Animation")),
    ("morph", QT_TRANSLATE_NOOP("ExportDialog", "Pictures alone")),
    ("numbers", QT_TRANSLATE_NOOP("ExportDialog", "Coordinates of keyframes")),
)

SMALLEST, LARGEST = 15, 8192
"""Pixels of the longer side; the smallest stands for the usual."""


class ExportDialog(QDialog):
    """Asks for a `Choice`; fields that do not matter for the layout are greyed out."""

    def __init__(
        self,
        shown: ExportedStep,
        player: Player,
        display: Display,
        parent: QWidget | None = None,
        *,
        whole: bool = False,
    ) -> None:
        super().__init__(parent)
        title = self.tr("Export keyframes")
        self.setWindowTitle(f"{title}: {shown.name}" if shown.name else title)
        self._layout_field = QComboBox()
        self._pictured = shown.pictures != (None, None)
        for layout, text in _LAYOUTS:
            if self._pictured or layout != "morph":
                self._layout_field.addItem(QCoreApplication.translate("ExportDialog", str(text)), layout)
        self._method = _method_field([result.method for result in shown.results])
        self._frames = QSpinBox()
        self._frames.setRange(2, 240)
        self._frames.setValue(6)
        self._t = DecimalField()
        self._t.setRange(0, 1)
        self._t.setSingleStep(0.01)
        self._t.setValue(player.t)
        self._times = TimesField()
        self._motion = MotionFields(player, self)
        self._can_be_whole = whole
        self._whole = QCheckBox(self.tr("The whole sequence"))
        self._whole.setToolTip(self.tr("From the first key shape to the last, once all steps are blended"))
        self._whole.setChecked(whole)
        self._easing = player.easing
        self._eased = QCheckBox(self.tr("Apart as played, with easing"))
        self._eased.setChecked(whole or not player.easing.even)
        self._overlays = OverlayFields(display.layers, pictured=self._pictured)
        self._look = LookFields()
        self._pixels = self._pixels_field()
        self._formats = Label(wrapped=True)
        self._arrange()
        self._layout_field.currentIndexChanged.connect(self._follow)
        self._whole.toggled.connect(self._follow)
        self._times.textChanged.connect(self._follow)
        self._follow()

    def _pixels_field(self) -> QSpinBox:
        field = QSpinBox()
        field.setRange(SMALLEST, LARGEST)
        field.setSingleStep(16)
        field.setSuffix(self.tr(" px"))
        field.setSpecialValueText(self.tr("usual"))
        field.setToolTip(self.tr("The longer side, of formats that are made of pixels"))
        return field

    @property
    def choice(self) -> Choice:
        """What was chosen."""
        return Choice(
            self._layout_field.currentData(),
            self._method.currentData(),
            self._frames.value(),
            self._t.value(),
            self._overlays.shown,
            self._eased.isChecked(),
            self._whole.isEnabled() and self._whole.isChecked(),
            self._motion.seconds,
            self._motion.returning,
            self._pixels.value() if self._pixels.value() > SMALLEST else None,
            self._motion.rate,
            self._look.look,
            self._times.times or (),
            self._motion.tolerance,
        )

    def begin_with(self, former: Choice) -> None:
        """Show what was chosen before, except for what goes with the document, the player and the panels."""
        for field, value in ((self._layout_field, former.layout), (self._method, former.method)):
            if (place := field.findData(value)) >= 0:
                field.setCurrentIndex(place)
        self._frames.setValue(former.frames)
        self._times.begin_with(former.times)
        self._pixels.setValue(former.pixels or SMALLEST)
        self._motion.begin_with(former.rate, former.tolerance)
        self._look.begin_with(former.look)
        self._overlays.begin_with(former.shown)

    def _arrange(self) -> None:
        form = self._form()
        kind = QDialogButtonBox.StandardButton
        buttons = self._buttons = answers(self, kind.Save | kind.Cancel)
        buttons.button(kind.Save).setText(self.tr("&Export…"))
        right = QVBoxLayout()
        right.addWidget(self._look)
        right.addSpacing(12)
        right.addWidget(self._overlays)
        right.addStretch()
        columns = QHBoxLayout()
        columns.setSpacing(24)
        columns.addLayout(form)
        columns.setAlignment(form, Qt.AlignmentFlag.AlignTop)
        columns.addLayout(right)
        layout = QVBoxLayout(self)
        layout.setSpacing(12)
        layout.addLayout(columns)
        layout.addWidget(self._formats)
        layout.addStretch()
        layout.addWidget(buttons)

    def _form(self) -> QFormLayout:
        """Give the fields that say what is exported, a row each."""
        form = QFormLayout()
        self._labels: dict[QWidget, QWidget] = {}
        form.setVerticalSpacing(8)
        for label, field in (
            (self.tr("&What"), self._layout_field),
            ("", self._whole),
            (self.tr("&Method"), self._method),
            (self.tr("&Keyframes"), self._frames),
            (self.tr("At t&hese times"), self._times),
            ("", self._eased),
            (self.tr("&Time t"), self._t),
            *self._motion.rows,
            (self.tr("Pi&xels"), self._pixels),
        ):
            form.addRow(label, field)
            if label and (caption := form.labelForField(field)) is not None:
                self._labels[field] = caption
            field.setAccessibleName(label.replace("&", "") or field.accessibleName())
        for box in (self._whole, self._eased):
            box.setAccessibleName(box.text())
        return form

    @Slot()
    def _follow(self) -> None:
        layout: Layout = self._layout_field.currentData()
        times = self._times.times
        self._method.setEnabled(layout != "sheet")
        self._times.setEnabled(layout not in ("frame", "animation"))
        self._frames.setEnabled(self._times.isEnabled() and times == ())
        self._whole.setEnabled(layout not in ("frame", "morph") and self._can_be_whole)
        whole = self._whole.isEnabled() and self._whole.isChecked()
        self._eased.setEnabled(layout != "frame" and (whole or not self._easing.even))
        self._t.setEnabled(layout == "frame")
        self._motion.offer(layout)
        for field, label in self._labels.items():
            label.setEnabled(field.isEnabled())
        self._pixels.setEnabled(layout != "numbers")
        self._look.setEnabled(layout != "numbers")
        self._overlays.offer(drawn=layout not in ("numbers", "morph"))
        known = times is not None or not self._times.isEnabled()
        self._buttons.button(QDialogButtonBox.StandardButton.Save).setEnabled(known)
        if not known:
            self._formats.setText(self.tr("Times are numbers from 0 to 1, set apart by spaces"))
            return
        names = ", ".join(str(words.retold(each.name)) for each in FORMATS[layout])
        self._formats.setText(self.tr("Can be written as {names}").format(names=names))


def _method_field(methods: Sequence[str]) -> QComboBox:
    field = QComboBox()
    for number, method in enumerate(methods):
        field.addItem(words.method(method), method)
        field.setItemData(number, words.method_tip(method), Qt.ItemDataRole.ToolTipRole)
    return field
