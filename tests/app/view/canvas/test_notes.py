import numpy as np
import pytest
import shapely
from PySide6.QtCore import QPointF, QRectF

from app.tools.toolbox import TOOLS
from app.view.canvas.painters.notes import NOTICE_MARGIN, KeptClear, how_to_draw, notice_box
from tests.app.driver import Driver
from tests.families import subdivided

ROOM = QRectF(10, 36, 600, 300)
CORNERS = np.array([(100.0, 200.0), (300.0, 200.0), (300.0, 300.0), (100.0, 300.0)])
RING = subdivided(CORNERS, 10)


def test_a_notice_is_beside_what_it_is_about() -> None:
    concerned = [QPointF(100, 200), QPointF(300, 200)]
    box = notice_box(200, 50, ROOM, KeptClear(concerned, ring=RING))
    assert ROOM.contains(box)
    kept = box.adjusted(-NOTICE_MARGIN, -NOTICE_MARGIN, NOTICE_MARGIN, NOTICE_MARGIN)
    assert not any(kept.contains(place) for place in concerned)
    assert box.center().y() < 200  # above, where it hides nothing of the shape
    assert abs(box.center().x() - 200) <= 100


def test_a_notice_hides_no_label_of_a_pin() -> None:
    concerned = [QPointF(100, 200), QPointF(300, 200)]
    unhindered = notice_box(200, 50, ROOM, KeptClear(concerned, ring=RING))
    label = QRectF(unhindered.center().x() - 15, unhindered.center().y() - 9, 30, 18)
    box = notice_box(200, 50, ROOM, KeptClear(concerned, [label], RING))
    assert ROOM.contains(box)
    assert not box.intersects(label)


def test_a_notice_lies_beside_a_shape_that_has_no_vertices_under_it() -> None:
    """A large triangle: its inside is far from all its vertices."""
    triangle = np.array([(20.0, 60.0), (400.0, 60.0), (20.0, 330.0)])
    box = notice_box(150, 40, ROOM, KeptClear([QPointF(210, 195)], ring=triangle))
    plate = shapely.box(box.left(), box.top(), box.right(), box.bottom())
    assert plate.intersection(shapely.Polygon(triangle)).area < 0.05 * plate.area


def test_a_notice_about_nothing_lies_on_the_lower_edge() -> None:
    assert notice_box(200, 50, ROOM, KeptClear(ring=RING)).bottom() == ROOM.bottom()


def test_a_notice_without_room_lies_on_the_lower_edge() -> None:
    small = QRectF(0, 0, 210, 60)
    assert notice_box(200, 50, small, KeptClear([QPointF(100, 30)], ring=RING)).bottom() == small.bottom()


@pytest.mark.parametrize("name", ["freehand", "rectangle", "text"])
def test_an_empty_canvas_tells_how_the_tool_in_hand_fills_it(name: str) -> None:
    assert how_to_draw(TOOLS[name]) == TOOLS[name].hint


def test_an_empty_canvas_says_nothing_about_the_shape_just_drawn_on_the_other(driver: Driver) -> None:
    driver.session.choose_tool("freehand")
    driver.drag("source", (10, 10), (50, 20), (90, 10), (90, 60), (50, 80), (10, 60), (10, 10))
    assert driver.document.source is not None
    assert how_to_draw(driver.session.tool) == TOOLS["freehand"].hint
