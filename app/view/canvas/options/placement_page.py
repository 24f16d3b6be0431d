"""Numbers of what can be placed: where it is, how large, and by how much it is turned."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import radians

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QDoubleSpinBox

from app.model.point import Point
from app.session import Session
from app.tools.tool import Response, ToolContext
from app.tools.verbs import numbers
from app.view.canvas.options.pages import Page
from app.view.wording.decimal_field import DecimalField


@dataclass(frozen=True)
class Measured:
    """What the fields show; None is greyed out.

    Attributes
    ----------
    middle : (float, float)
    width, height : float or None
    degrees : float or None
    """

    middle: Point
    width: float | None
    height: float | None
    degrees: float | None


class PlacementPage(Page):
    """Place, size and angle of something, to be read and to be set."""

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._x = self._box(self.tr("X"), "x", self.tr("Middle, from left to right"))
        self._y = self._box(self.tr("Y"), "y", self.tr("Middle, upwards"))
        self._width = self._box(self.tr("W"), "width", self.tr("Width"))
        self._height = self._box(self.tr("H"), "height", self.tr("Height"))
        self._turn = self._box(self.tr("Turn"), "turn", self.turn_tip)
        self._turn.setSuffix("°")
        self._turn.setRange(-3600, 3600)
        for box in (self._x, self._y):
            box.valueChanged.connect(self._centre)
        for box in (self._width, self._height):
            box.valueChanged.connect(self._resize)
        self._turn.valueChanged.connect(self._rotate)
        session.changed.connect(self.show_numbers)
        self.show_numbers()

    @property
    def turn_tip(self) -> str:
        """What the angle is measured from."""
        raise NotImplementedError

    def measured(self) -> Measured | None:
        """Give the numbers as they are now, None where there is nothing."""
        raise NotImplementedError

    def centre(self, middle: Point) -> None:
        """Put the middle somewhere else."""
        raise NotImplementedError

    def resize_to(self, size: Point) -> None:
        """Change the size."""
        raise NotImplementedError

    def turn_to(self, degrees: float) -> None:
        """Change the angle."""
        raise NotImplementedError

    @Slot()
    def show_numbers(self) -> None:
        """Show the numbers as they are."""
        found = self.measured()
        x, y = found.middle if found else (None, None)
        width, height, degrees = (found.width, found.height, found.degrees) if found else (None, None, None)
        for field, value in (
            (self._x, x),
            (self._y, y),
            (self._width, width),
            (self._height, height),
            (self._turn, degrees),
        ):
            field.setEnabled(value is not None)
            field.follow(value or 0.0)

    def _box(self, label: str, name: str, tip: str) -> DecimalField:
        box = DecimalField()
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
        found = self.measured()
        if found is not None:
            self.centre((self._typed(self._x, found.middle[0]), self._typed(self._y, found.middle[1])))
        self.show_numbers()

    @Slot()
    def _resize(self) -> None:
        found = self.measured()
        if found is not None:
            width, height = found.width or 0.0, found.height or 0.0
            self.resize_to((self._typed(self._width, width), self._typed(self._height, height)))
        self.show_numbers()

    def _typed(self, field: QDoubleSpinBox, value: float) -> float:
        """Give what was typed into a field, or the value itself: what is shown of it is rounded."""
        return field.value() if self.sender() is field else value

    @Slot()
    def _rotate(self) -> None:
        self.turn_to(self._turn.value())
        self.show_numbers()


class SelectionPage(PlacementPage):
    """The numbers of the selection; it counts as not turned when it is selected, and after other edits."""

    def __init__(self, session: Session) -> None:
        self._turned: tuple[ToolContext, float] = ToolContext(session.document, session.selection), 0.0
        super().__init__(session)

    @property
    def turn_tip(self) -> str:
        return self.tr("By how much to turn the selection about its middle")

    def measured(self) -> Measured | None:
        context = self._context
        box = numbers.selected_box(context)
        if box is None:
            return None
        width, height = box.size
        many = len(context.selection.vertices) > 1
        return Measured(box.middle, width or None, height or None, self._degrees if many else None)

    def centre(self, middle: Point) -> None:
        self._edit(partial(numbers.centred, middle=middle))

    def resize_to(self, size: Point) -> None:
        self._edit(partial(numbers.sized, size=size))

    def turn_to(self, degrees: float) -> None:
        before = self.session.document
        self._edit(partial(numbers.turned, angle=radians(degrees - self._degrees)))
        if self.session.document is not before:  # else it was refused
            self._turned = self._context, degrees

    @property
    def _context(self) -> ToolContext:
        return ToolContext(self.session.document, self.session.selection)

    @property
    def _degrees(self) -> float:
        """By how much what is selected has just been turned here."""
        context, degrees = self._turned
        same = context.document is self.session.document and context.selection == self.session.selection
        return degrees if same else 0.0

    def _edit(self, verb: Callable[[ToolContext], Response]) -> None:
        self.session.edit(verb)
