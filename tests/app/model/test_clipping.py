import pytest

from app.model import clipping
from app.model.document import Document
from app.model.selection import Selection, everything
from app.model.sequence import Sequence
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.step import Link, Step
from starskel.polygon import Polygon


def box(x: float, y: float, side: float) -> Polygon:
    return Polygon([(x, y), (x + side, y), (x + side, y + side), (x, y + side)])


FACE, EYE, MOUTH, HAT = box(0, 0, 90), box(10, 50, 20), box(50, 10, 20), box(20, 100, 30)
PLAIN = KeyShape.of(box(0, 0, 60))


@pytest.fixture
def document() -> Document:
    """A face with two holes, and a hat; it becomes a square and what is left of it goes."""
    links = (Link(0, 0), Link(1, None), Link(2, None), Link(3, None))
    return Document().arranged(Sequence((KeyShape.of(FACE, EYE, MOUTH, HAT), PLAIN), (Step(links),)), 0)


def test_nothing_selected_means_the_whole_shape(document: Document) -> None:
    copied = clipping.clipping_of(document, Selection("source"))
    assert copied is not None
    assert copied.whole
    assert copied.shape.outer == (-1, 0, 0, -1)
    assert clipping.clipping_of(Document(), Selection("source")) is None


def test_a_part_that_is_selected_has_its_holes_with_it(document: Document) -> None:
    copied = clipping.clipping_of(document, everything(document, "source"))
    assert copied is not None
    assert not copied.whole
    assert copied.shape.rings == (FACE, EYE, MOUTH)
    holes = clipping.clipping_of(document, Selection("source", links=frozenset([1, 3])))
    assert holes is not None
    assert (holes.shape.rings, holes.shape.outer) == ((EYE, HAT), (-1, -1))  # a hole by itself is a part


def test_what_is_cut_is_gone_and_comes_back_where_it_was(document: Document) -> None:
    chosen = Selection("source", links=frozenset([1, 3]))
    copied, rest = clipping.clipping_of(document, chosen), clipping.cut(document, chosen)
    assert rest.shape("source").rings == (FACE, MOUTH)
    assert rest.shape("target") == document.shape("target")
    assert copied is not None
    back = clipping.pasted(rest, "source", copied)
    assert set(back.shape("source").rings) == {FACE, EYE, MOUTH, HAT}
    assert back.shape("source").shape.outer == (-1, 0, 0, -1)
    assert not clipping.cut(document, Selection("source")).shape("source").parts


def test_copied_parts_are_added_and_paired_with_what_they_are_copies_of(document: Document) -> None:
    chosen = Selection("source", links=frozenset([1, 2]))
    copied = clipping.clipping_of(document, chosen)
    assert copied is not None
    across = clipping.pasted(document, "target", copied)
    assert across.shape("target").rings == (*PLAIN.rings, EYE, MOUTH)
    assert {link.ends for link in across.way.links} == {(0, 0), (1, 1), (2, 2), (3, None)}


def test_copies_on_the_same_canvas_lie_beside(document: Document) -> None:
    copied = clipping.clipping_of(document, Selection("source", links=frozenset([1, 3])))
    assert copied is not None
    twice = clipping.pasted(clipping.pasted(document, "source", copied), "source", copied)
    assert len(set(twice.shape("source").rings)) == len(twice.shape("source").rings) == 8


def test_a_whole_shape_takes_the_place_of_another(document: Document) -> None:
    copied = clipping.clipping_of(document, Selection("source"))
    assert copied is not None
    replaced = clipping.pasted(document, "target", copied)
    assert replaced.shape("target").rings == document.shape("source").rings
    assert len(replaced.way.links) == 4
