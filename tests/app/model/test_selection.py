from dataclasses import replace

from app.model.document import Document
from app.model.selection import Selection, everything
from starskel.files.projects.key_shape import Part
from starskel.polygon import Polygon

SQUARE = Polygon([(0, 0), (10, 0), (10, 10), (0, 10)])


def test_toggling_twice_gives_the_same_selection() -> None:
    selection = Selection("source", frozenset([1, 2]))
    assert selection.toggle("source", 3).toggle("source", 3) == selection


def test_a_selection_lives_on_one_side() -> None:
    selection = Selection("source", frozenset([1, 2])).add("target", [0])
    assert selection == Selection("target", frozenset([0]))
    assert not selection.on("source")


def test_what_is_selected_stays_only_while_vertices_keep_their_numbers() -> None:
    document = Document.of(source=SQUARE)
    chosen = everything(document, "source")
    assert chosen.after(document, document.move("source", [0], (-1, 0))) == chosen
    assert not chosen.after(document, document.insert("source", 0, (5, 0)))


def test_nothing_stays_selected_of_a_part_that_is_no_longer_worked_on() -> None:
    other = Polygon(SQUARE.vertices + 20)
    one = Document.of(source=SQUARE)
    shape = one.sequence.add_part(0, Part(other))
    two = replace(one, sequence=shape).working_on("source", 1)
    chosen = everything(two, "source")
    assert chosen
    assert not chosen.after(two, one)
