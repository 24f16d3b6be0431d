import numpy as np
import pytest

from app.model.document import Document
from starskel.errors import InvalidMarks, InvalidPolygon
from starskel.polygon import Polygon

SQUARE = Polygon([(0, 0), (10, 0), (10, 10), (0, 10)])


def test_drawing_a_shape_anew_drops_its_marks() -> None:
    document = Document.of(source=SQUARE, target=SQUARE, marks=((0, 0), (1, 1)))
    assert document.draw("target", Polygon([(0, 0), (5, 0), (0, 5)])).marks == ()


def test_an_inserted_vertex_shifts_the_marks_behind_it() -> None:
    document = Document.of(source=SQUARE, target=SQUARE, marks=((0, 0), (1, 1), (3, 3)))
    inserted = document.insert("target", 1, (10, 5))
    assert inserted.marks == ((0, 0), (1, 1), (3, 4))
    assert inserted.vertices("target")[2].tolist() == [10, 5]
    assert inserted.source is document.source


def test_a_vertex_inserted_on_the_last_edge_shifts_no_mark() -> None:
    document = Document.of(source=SQUARE, target=SQUARE, marks=((3, 3),))
    inserted = document.insert("source", 3, (0, 5))
    assert inserted.marks == ((3, 3),)
    assert inserted.vertices("source")[4].tolist() == [0, 5]


def test_deleted_vertices_take_their_marks_along() -> None:
    hexagon = Polygon([(np.cos(a), np.sin(a)) for a in np.arange(6) * np.pi / 3])
    document = Document.of(source=hexagon, target=hexagon, marks=((0, 0), (2, 2), (4, 4), (5, 5)))
    assert document.delete("source", [1, 4]).marks == ((0, 0), (1, 2), (3, 5))


def test_deleting_every_vertex_removes_the_shape() -> None:
    document = Document.of(source=SQUARE, target=SQUARE, marks=((0, 0),))
    empty = document.delete("source", range(4))
    assert empty.source is None
    assert empty.marks == ()


@pytest.mark.parametrize("gone", [[0, 1], [0, 1, 2]])
def test_a_shape_of_fewer_than_three_vertices_is_refused(gone: list[int]) -> None:
    with pytest.raises(InvalidPolygon, match="at least 3"):
        Document.of(source=SQUARE).delete("source", gone)


def test_a_move_that_makes_edges_cross_is_refused_and_names_them() -> None:
    with pytest.raises(InvalidPolygon) as caught:
        Document.of(source=SQUARE).move("source", [0], (20, 5))
    assert len(caught.value.vertices) == 4


def test_marks_follow_a_triangle_turned_inside_out() -> None:
    triangle = Polygon([(0, 0), (10, 0), (0, 10)])
    document = Document.of(source=triangle, target=triangle, marks=((0, 0), (1, 2)))
    moved = document.move("source", [0], (20, 20))
    source = moved.vertices("source")
    assert source[moved.marks[0][0]].tolist() == [20, 20]
    assert source[moved.marks[1][0]].tolist() == [10, 0]


def test_turning_a_shape_inside_out_is_refused_where_marks_would_cross() -> None:
    triangle = Polygon([(0, 0), (10, 0), (0, 10)])
    document = Document.of(source=triangle, target=triangle, marks=((0, 0), (1, 1), (2, 2)))
    with pytest.raises(InvalidMarks):
        document.move("source", [0], (20, 20))


def test_a_mark_out_of_order_is_refused_naming_both() -> None:
    document = Document.of(source=SQUARE, target=SQUARE, marks=((0, 0), (1, 1)))
    with pytest.raises(InvalidMarks) as caught:
        document.mark(2, 1)
    assert set(caught.value.marks) == {(2, 1), (1, 1)}
    crossing = Document.of(source=SQUARE, target=SQUARE, marks=((0, 0), (1, 1), (3, 3)))
    with pytest.raises(InvalidMarks) as caught:
        crossing.repin(2, "target", 1)
    assert set(caught.value.marks) == {(3, 1), (1, 1)}


@pytest.mark.parametrize(
    ("new", "passed"), [((1, 4), (5, 5)), ((4, 0), (5, 5)), ((2, 4), (3, 3)), ((2, 0), (1, 1))]
)
def test_the_mark_that_was_passed_is_named(new: tuple[int, int], passed: tuple[int, int]) -> None:
    octagon = Polygon([(np.cos(a), np.sin(a)) for a in np.arange(8) * np.pi / 4])
    marks = tuple((k, k) for k in (1, 2, 3, 5) if k != new[0])
    document = Document.of(source=octagon, target=octagon, marks=marks)
    with pytest.raises(InvalidMarks) as caught:
        document.mark(*new)
    assert set(caught.value.marks) == {new, passed}


def test_a_vertex_has_at_most_one_mark() -> None:
    document = Document.of(source=SQUARE, target=SQUARE, marks=((0, 0),))
    with pytest.raises(InvalidMarks, match="both name vertex 0"):
        document.mark(0, 2)


def test_any_turn_of_the_marks_is_a_good_order() -> None:
    for shift in range(4):
        marks = tuple((k, (k + shift) % 4) for k in (2, 0, 3, 1))
        assert Document.of(source=SQUARE, target=SQUARE, marks=marks).marks == marks


def test_crossed_marks_get_into_no_document() -> None:
    with pytest.raises(InvalidMarks):
        Document.of(source=SQUARE, target=SQUARE, marks=((0, 0), (1, 2), (2, 1)))


def test_moving_a_pin_keeps_its_number() -> None:
    document = Document.of(source=SQUARE, target=SQUARE, marks=((0, 0), (1, 1), (2, 2)))
    assert document.repin(1, "target", 1).marks == document.marks
    assert document.unmark(0).repin(0, "source", 0).marks == ((0, 1), (2, 2))
