import numpy as np
import pytest
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter

from app.view.painting.pins import CAPTION, Pin, free_box, outward, paint_pins

SQUARE = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
ROOM = QRectF(0, 0, 400, 300)


def test_labels_point_out_of_the_shape() -> None:
    middle = SQUARE.mean(axis=0)
    for vertex in range(4):
        direction = outward(SQUARE, vertex)
        assert np.hypot(*direction) == pytest.approx(1)
        assert direction @ (SQUARE[vertex] - middle) > 0


def test_a_reflex_vertex_has_its_label_outside_too() -> None:
    ring = np.array([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (5.0, 4.0), (0.0, 10.0)])
    assert outward(ring, 3)[1] > 0


def test_a_spike_that_folds_back_has_a_direction() -> None:
    ring = np.array([(0.0, 0.0), (10.0, 0.0), (5.0, 1e-12), (5.0, 5.0)])
    assert outward(ring, 1).tolist() == [1, 0]


def test_labels_keep_clear_of_each_other_of_the_caption_and_of_the_edge() -> None:
    down = np.array([0.0, 1.0])
    places = [np.array([x, 280.0]) for x in (100.0, 106.0, 112.0)] + [np.array([60.0, 46.0])]
    directions = [down, down, down, -down]
    boxes: list[QRectF] = []
    for place, direction in zip(places, directions, strict=True):
        boxes.append(free_box(Pin(place, direction, "1 a", "#000000"), 30, ROOM, [CAPTION, *boxes]))
    for index, box in enumerate(boxes):
        assert ROOM.contains(box)
        assert not box.intersects(CAPTION)
        assert not any(box.intersects(other) for other in boxes[:index])


def test_any_number_of_pins_at_one_place_is_painted(qapp) -> None:  # type: ignore[no-untyped-def]
    image = QImage(50, 50, QImage.Format.Format_RGB32)
    painter = QPainter(image)
    paint_pins(
        painter, [Pin(np.array([25.0, 25.0]), np.array([1.0, 0.0]), str(k), "#123456") for k in range(40)]
    )
    painter.end()
