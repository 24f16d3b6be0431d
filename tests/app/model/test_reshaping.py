import numpy as np

from app.model import reshaping
from app.model.document import Document
from app.model.sequence import lost_marks
from starskel.polygon import Polygon

FLAG = Polygon([(0, 0), (8, 0), (8, 5), (4, 3), (0, 6)])
SQUARE = Polygon([(0, 0), (9, 0), (9, 9), (0, 9)])
PAIR = Document.of(source=FLAG, target=SQUARE, marks=((0, 0), (2, 2), (4, 3)))


def marked_places(document: Document) -> list[list[float]]:
    return [document.vertices("source")[source].tolist() for source, _ in document.marks]


def test_refining_keeps_marks_on_their_places() -> None:
    finer = reshaping.refine(PAIR, "source", 9, range(5))
    assert len(finer.vertices("source")) == 14
    assert marked_places(finer) == marked_places(PAIR)


def test_simplifying_keeps_marked_vertices() -> None:
    finer = reshaping.refine(PAIR, "source", 9, range(5))
    simpler = reshaping.simplify(finer, "source", 100, range(14))
    assert marked_places(simpler) == marked_places(PAIR)
    assert len(simpler.vertices("source")) < 5
    assert not lost_marks(finer.sequence, simpler.sequence)


def test_only_the_vertices_named_may_go() -> None:
    finer = reshaping.refine(PAIR, "source", 5, range(5))
    same = reshaping.simplify(finer, "source", 100, [0])
    assert len(same.vertices("source")) == 10


def test_setting_the_first_vertex_turns_the_numbers_and_not_the_shape() -> None:
    turned = reshaping.set_first(PAIR, "source", 3)
    assert turned.vertices("source")[0].tolist() == [4, 3]
    assert marked_places(turned) == marked_places(PAIR)
    assert reshaping.set_first(turned, "source", 2) == PAIR


def test_a_mirrored_shape_keeps_the_marks_that_still_agree() -> None:
    ring = reshaping.mirrored(PAIR, "source", range(5), (-1, 1))
    document = reshaping.turn_round(PAIR, "source", ring)
    assert marked_places(document) == [[8, 0], [0, 5]]
    assert lost_marks(PAIR.sequence, document.sequence) == 1
    np.testing.assert_array_equal(np.sort(document.vertices("source"), axis=0), np.sort(ring, axis=0))


def test_a_copy_corresponds_to_itself_where_it_was_marked() -> None:
    copied = reshaping.copy_across(PAIR, "source")
    assert copied.target == FLAG
    assert copied.marks == ((0, 0), (2, 2), (4, 4))


def test_exchanging_twice_changes_nothing() -> None:
    assert PAIR.exchanged().exchanged() == PAIR
    assert PAIR.exchanged().marks == ((0, 0), (2, 2), (3, 4))
