"""A face with two eyes, and the list of its parts: what tests of shapes of several parts begin with."""

from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QDropEvent
from PySide6.QtTest import QTest

from app.model.pairing import Ends
from app.view.lists.parts_list import PartsTable
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.project import Project
from starskel.files.projects.step import Link, Step
from starskel.polygon import Polygon
from tests.app.driver import CONTROL, LEFT, Driver

METHODS = ("stitched", "vertex")
EYE = ((20, 55), (35, 55), (35, 70), (20, 70))


def box(x: float, y: float, width: float, height: float) -> Polygon:
    return Polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)])


FACE, LEFT_EYE, RIGHT_EYE = box(10, 10, 80, 80), box(20, 55, 15, 15), box(65, 55, 15, 15)


def with_face(driver: Driver) -> Driver:
    """Show a face that becomes the same face."""
    shape = KeyShape.of(FACE, LEFT_EYE, RIGHT_EYE)
    step = Step(tuple(Link(k, k) for k in range(3)))
    driver.session.show_project(Project("face", (shape, shape), (step,), METHODS))
    driver.wait_for_blends()
    return driver


def table(driver: Driver) -> PartsTable:
    return driver.window.parts.table


def ends(driver: Driver) -> list[Ends]:
    return [link.ends for link in driver.document.way.links]


def go_to(driver: Driver, row: int, column: int) -> None:
    view = table(driver)
    place = view.visualRect(view.model().index(row, column)).center() + QPoint(20, 0)
    QTest.mouseClick(view.viewport(), LEFT, pos=place)


def drag(driver: Driver, start: tuple[int, int], stop: tuple[int, int], *, besides: bool = False) -> None:
    """Drop a cell of the list on another one, as Qt tells of it; offscreen there is no drag to follow."""
    view, model = table(driver), table(driver).model()
    data: QMimeData = model.mimeData([model.index(*start)])
    action = Qt.DropAction.CopyAction if besides else Qt.DropAction.MoveAction
    place = QPointF(view.visualRect(model.index(*stop)).center())
    keys = CONTROL if besides else Qt.KeyboardModifier.NoModifier
    event = QDropEvent(place, Qt.DropAction.MoveAction | Qt.DropAction.CopyAction, data, LEFT, keys)
    event.setDropAction(action)
    view.dropEvent(event)
