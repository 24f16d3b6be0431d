"""Numbers of what is selected: where it is, how large, and by how much it was turned."""

from collections.abc import Callable
from functools import partial
from math import radians

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QDoubleSpinBox

from app.model.selection import Selection
from app.session import Session
from app.tools import numbers
from app.tools.tool import Response, Scene
from app.view.canvas.option_pages import Page


class Numbers(Page):
    """Place, size and angle of the selection, to be read and to be set."""

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._x = self._box(self.tr("X"), "x", self.tr("Middle of the selection, from left to right"))
        self._y = self._box(self.tr("Y"), "y", self.tr("Middle of the selection, upwards"))
        self._width = self._box(self.tr("W"), "width", self.tr("Width of the selection"))
        self._height = self._box(self.tr("H"), "height", self.tr("Height of the selection"))
        self._turn = self._box(
            self.tr("Turn"), "turn", self.tr("How far the selection was turned since it was selected")
        )
        self._turn.setSuffix("°")
        self._turn.setRange(-3600, 3600)
        self._turned: tuple[Selection, float] = Selection(), 0.0
        for box in (self._x, self._y):
            box.valueChanged.connect(self._centre)
        for box in (self._width, self._height):
            box.valueChanged.connect(self._resize)
        self._turn.valueChanged.connect(self._rotate)
        session.changed.connect(self.follow_selection)
        self.follow_selection()

    @Slot()
    def follow_selection(self) -> None:
        """Show the numbers of what is selected."""
        scene = Scene(self.session.document, self.session.selection)
        box = numbers.selected_box(scene)
        many = len(scene.selection.vertices) > 1
        if self._turned[0] != scene.selection:
            self._turned = scene.selection, 0.0
        x, y = box.middle if box else (0.0, 0.0)
        width, height = box.size if box else (0.0, 0.0)
        for field, value, usable in (
            (self._x, x, box is not None),
            (self._y, y, box is not None),
            (self._width, width, width > 0),
            (self._height, height, height > 0),
            (self._turn, self._turned[1], many),
        ):
            field.blockSignals(True)  # what is shown is no edit
            field.setEnabled(usable)
            field.setValue(value)
            field.blockSignals(False)

    def _box(self, label: str, name: str, tip: str) -> QDoubleSpinBox:
        box = QDoubleSpinBox()
        box.setObjectName(name)
        box.setRange(-1e6, 1e6)
        box.setDecimals(2)
        box.setFixedWidth(86)
        box.setKeyboardTracking(False)  # what is typed counts when it is complete
        box.setToolTip(tip)
        self.add(label, box)
        box.setAccessibleName(tip)
        return box

    @Slot()
    def _centre(self) -> None:
        self._edit(partial(numbers.centred, middle=(self._x.value(), self._y.value())))

    @Slot()
    def _resize(self) -> None:
        self._edit(partial(numbers.sized, size=(self._width.value(), self._height.value())))

    @Slot()
    def _rotate(self) -> None:
        selection, former = self._turned
        angle = self._turn.value()
        self._turned = selection, angle
        self._edit(partial(numbers.turned, angle=radians(angle - former)))

    def _edit(self, verb: Callable[[Scene], Response]) -> None:
        self.session.edit(verb)
        self.follow_selection()
