"""What there is to set of the picture behind the shape that was worked on last."""

from functools import partial
from math import degrees

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QSlider, QToolButton

from app.model.marks import Side
from app.model.point import Point
from app.session import Session
from app.tools.verbs.picture import centre_picture, fade_picture, resize_picture, turn_picture
from app.view.canvas.options.placement_page import Measured, PlacementPage
from app.view.commands.actions import Actions
from starskel.files.projects.picture import Picture

SMALLEST = 0.01
"""The smallest width and height that can be typed."""


class PicturePage(PlacementPage):
    """Numbers of the picture, how much of it is seen, and buttons for what can be done to it."""

    def __init__(self, session: Session, actions: Actions) -> None:
        super().__init__(session)
        self._actions = actions
        for box in (self._width, self._height):
            box.setMinimum(SMALLEST)
        self._opacity = QSlider(Qt.Orientation.Horizontal)
        self._opacity.setObjectName("opacity")
        self._opacity.setRange(5, 100)
        self._opacity.setFixedWidth(90)
        self.add(self.tr("Opacity"), self._opacity)
        for name in ("picture-trace", "picture-crop", "picture-lock", "picture-remove", "picture-open"):
            button = QToolButton()
            button.setDefaultAction(actions[name])
            button.setAutoRaise(True)
            self._row.insertWidget(self._row.count() - 1, button)
        self._opacity.valueChanged.connect(self._fade)
        session.changed.connect(self._show)
        self._show()

    @property
    def turn_tip(self) -> str:
        return self.tr("How far the picture is turned, counter-clockwise from upright")

    def measured(self) -> Measured | None:
        picture = self._picture
        if picture is None or picture.locked:
            return None
        return Measured(picture.middle, *picture.size, degrees(picture.rotation))

    def centre(self, middle: Point) -> None:
        self.session.edit(partial(centre_picture, side=self._side, middle=middle))

    def resize_to(self, size: Point) -> None:
        self.session.edit(partial(resize_picture, side=self._side, size=size))

    def turn_to(self, degrees: float) -> None:
        self.session.edit(partial(turn_picture, side=self._side, degrees=degrees))

    @property
    def _side(self) -> Side:
        return self.session.selection.side

    @property
    def _picture(self) -> Picture | None:
        return self.session.document.picture(self._side)

    @Slot(int)
    def _fade(self, percent: int) -> None:
        self.session.edit(partial(fade_picture, side=self._side, opacity=percent / 100))

    @Slot()
    def _show(self) -> None:
        picture = self._picture
        for name in ("picture-trace", "picture-lock", "picture-crop", "picture-remove"):
            self._actions[name].setEnabled(picture is not None)
        self._actions["picture-lock"].setChecked(picture is not None and picture.locked)
        self._actions["picture-crop"].setChecked(picture is not None and picture.cropped)
        self._opacity.setEnabled(picture is not None)
        self._opacity.blockSignals(True)  # what is shown is no edit
        self._opacity.setValue(round(100 * picture.opacity) if picture is not None else 50)
        self._opacity.blockSignals(False)
