"""Shapes of several parts: drawing, removing, pairing, splitting, and what becomes of marks."""

from dataclasses import replace

import numpy as np
import pytest

from app.model import arranging, parts
from app.model.document import Document
from app.model.history import History
from app.model.marks import Marks
from app.model.pairing import Ends
from app.model.sequence import Sequence, lost_marks
from starskel.errors import InvalidPolygon
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.step import Link, Step
from starskel.polygon import Polygon


def square(x: float, y: float, size: float = 2) -> Polygon:
    return Polygon([(x, y), (x + size, y), (x + size, y + size), (x, y + size)])


FACE, LEFT, RIGHT, MOUTH = square(0, 0, 20), square(4, 12), square(12, 12), square(8, 4, 3)
MARKS = ((0, 0), (2, 2))


@pytest.fixture
def face() -> Document:
    """A face that becomes itself, every part marked; the left eye is worked on."""
    shape = KeyShape.of(FACE, LEFT, RIGHT, MOUTH)
    step = Step(tuple(Link(k, k, MARKS) for k in range(4)))
    return replace(Document(sequence=Sequence((shape, shape), (step,))), link=1)


def ends(document: Document) -> list[Ends]:
    return [link.ends for link in document.way.links]


def marks(document: Document) -> dict[Ends, Marks]:
    return {link.ends: link.marks for link in document.way.links}


def test_the_link_worked_on_is_what_source_target_and_marks_mean(face: Document) -> None:
    assert (face.source, face.target, face.marks) == (LEFT, LEFT, MARKS)
    mouth = face.showing(0, 3)
    assert mouth.source == MOUTH
    assert mouth.sequence is face.sequence
    assert face.working_on("target", 2).link == 2


def test_an_edit_touches_the_part_worked_on_alone(face: Document) -> None:
    moved = face.move("source", range(4), (0.5, 0.5)).unmark(0)
    assert moved.shape("source").rings == (FACE, square(4.5, 12.5), RIGHT, MOUTH)
    assert moved.shape("target") is face.shape("target")
    assert [len(link.marks) for link in moved.way.links] == [2, 1, 2, 2]


def test_parts_are_drawn_one_after_the_other_and_become_partners() -> None:
    document = Document().draw("source", FACE)
    assert ends(document) == [(0, None)]
    document = document.draw("target", FACE)
    assert ends(document) == [(0, 0)]
    document = document.showing(0, 1)
    assert (document.source, document.target, document.marks) == (None, None, ())
    document = document.draw("target", LEFT)
    assert ends(document) == [(0, 0), (None, 1)]
    document = document.draw("source", RIGHT)
    assert ends(document) == [(0, 0), (1, 1)]
    assert (document.source, document.target) == (RIGHT, LEFT)


def test_a_part_that_is_removed_leaves_its_partner_alone(face: Document) -> None:
    gone = face.delete("source", range(4))
    assert gone.shape("source").rings == (FACE, RIGHT, MOUTH)
    assert ends(gone) == [(0, 0), (None, 1), (1, 2), (2, 3)]
    assert (gone.source, gone.target) == (None, LEFT)
    assert marks(gone)[1, 2] == MARKS
    assert lost_marks(face.sequence, gone.sequence) == 2
    both = gone.delete("target", range(4))
    assert ends(both) == [(0, 0), (1, 1), (2, 2)]


def test_removing_the_last_part_leaves_nothing() -> None:
    document = Document.of(FACE).draw("source", None)
    assert document.sequence == Sequence()
    assert (document.link, document.source) == (0, None)


def test_holes_that_meet_are_refused_with_the_place(face: Document) -> None:
    with pytest.raises(InvalidPolygon) as caught:
        face.move("source", range(4), (7, 0.5))
    assert caught.value.place == pytest.approx((12, 12.5), abs=2)
    with pytest.raises(InvalidPolygon):
        face.showing(0, 4).draw("source", square(11, 11))


def test_parts_that_are_paired_anew_exchange_their_partners(face: Document) -> None:
    crossed = parts.pair(face, 1, 2)
    assert ends(crossed) == [(0, 0), (1, 2), (2, 1), (3, 3)]
    assert (crossed.source, crossed.target) == (LEFT, RIGHT)
    assert marks(crossed)[1, 2] == ()
    assert marks(crossed)[3, 3] == MARKS
    assert lost_marks(face.sequence, crossed.sequence) == 4
    assert parts.pair(face, 1, 1) == face


def test_parts_go_their_own_ways_and_come_together_again(face: Document) -> None:
    apart = parts.part_ways(face)
    assert ends(apart) == [(0, 0), (1, None), (None, 1), (2, 2), (3, 3)]
    assert apart.source == LEFT
    placed = parts.place(apart, (9.0, 9.0))
    assert placed.pair.place == (9.0, 9.0)
    assert parts.part_ways(placed) == placed
    assert ends(parts.pair(placed, 1, 1)) == [(0, 0), (1, 1), (2, 2), (3, 3)]


def test_one_part_becomes_several_and_several_one() -> None:
    one, two = KeyShape.of(FACE), KeyShape.of(LEFT, RIGHT)
    document = Document(sequence=Sequence((one, two), (Step((Link(0, 0, MARKS), Link(None, 1))),)))
    cut = parts.split(document, 0, 1)
    assert ends(cut) == [(0, 0), (0, 1)]
    assert marks(cut) == {(0, 0): (), (0, 1): ()}
    assert (cut.source, cut.target) == (FACE, RIGHT)
    assert ends(cut.exchanged()) == [(0, 0), (1, 0)]
    assert ends(parts.part_ways(cut)) == [(0, 0), (None, 1)]


def test_another_pairing_keeps_what_stays_together(face: Document) -> None:
    anew = parts.pair_anew(face, [(3, 3), (0, 0), (1, 2), (2, None), (None, 1)])
    assert ends(anew) == [(0, 0), (3, 3), (1, 2), (2, None), (None, 1)]
    assert marks(anew)[3, 3] == MARKS
    assert parts.pair_anew(face, ends(face)) == face


def test_the_order_is_that_of_painting_and_the_same_part_is_worked_on(face: Document) -> None:
    lowest = parts.reorder(face, 0)
    assert ends(lowest) == [(1, 1), (0, 0), (2, 2), (3, 3)]
    assert lowest.source == LEFT
    assert parts.stacked(lowest, "target") == [1, 0, 2, 3]
    assert lost_marks(face.sequence, lowest.sequence) == 0


def test_looks_belong_to_both_partners(face: Document) -> None:
    red = parts.style(face, 1, colour="#aa0000", name="eye", visible=False)
    assert {part.name for part in parts.members(red, 1)} == {"eye"}
    assert parts.colours(red, 1) == ("#aa0000", "#aa0000")
    assert (parts.shown(red, 1), parts.shown(red, 0)) == (False, True)


def film() -> Document:
    """Three shapes: a face with two eyes, one whose eyes are listed the other way round, and a bare one."""
    one, two, three = KeyShape.of(FACE, LEFT, RIGHT), KeyShape.of(FACE, RIGHT, LEFT), KeyShape.of(FACE)
    first = Step((Link(0, 0, MARKS), Link(1, 2, MARKS), Link(2, 1)))
    second = Step((Link(0, 0, MARKS), Link(1, None, place=(1.0, 2.0)), Link(2, None)))
    return Document(sequence=Sequence((one, two, three), (first, second)))


def test_the_same_part_is_worked_on_in_the_next_step() -> None:
    eye = film().showing(0, 1).showing(1)
    assert eye.source == LEFT
    assert eye.showing(0).source == LEFT


def test_a_part_that_goes_leaves_both_steps_of_its_shape() -> None:
    gone = film().showing(0, 2).delete("target", range(4))
    assert [link.ends for link in gone.sequence.steps[0].links] == [(0, 0), (1, 1), (2, None)]
    assert [link.ends for link in gone.sequence.steps[1].links] == [(0, 0), (1, None)]


def test_a_part_that_comes_is_alone_in_the_step_beyond() -> None:
    grown = film().showing(0, 3).draw("target", MOUTH)
    assert [link.ends for link in grown.sequence.steps[0].links] == [(0, 0), (1, 2), (2, 1), (None, 3)]
    assert [link.ends for link in grown.sequence.steps[1].links][-1] == (3, None)


def test_links_lead_by_way_of_a_shape_that_is_taken_out() -> None:
    left = arranging.delete_shape(film(), 1)
    assert ends(left) == [(0, 0), (1, None), (2, None)]
    assert marks(left)[0, 0] == MARKS
    back = arranging.move_shape(film(), 2, 0).sequence
    assert [link.ends for link in back.steps[0].links] == [(0, 0), (None, 1), (None, 2)]


def test_a_copy_has_every_part_marked_where_its_original_is() -> None:
    copied = arranging.duplicate_shape(film(), 0)
    assert ends(copied) == [(0, 0), (1, 1), (2, 2)]
    assert marks(copied) == {(0, 0): MARKS, (1, 1): MARKS, (2, 2): ()}
    empty = arranging.add_shape(film(), 0)
    assert ends(empty) == [(0, None), (1, None), (2, None)]


def test_choosing_a_part_is_no_edit(face: Document) -> None:
    history = History.of(face).showing(0, 3)
    assert history.document.source == MOUTH
    assert not history.unsaved
    assert history.undoes is None


def test_a_vertex_that_moves_takes_its_marks_in_both_steps_along() -> None:
    document = film().showing(0, 1)
    turned = document.reform("target", np.roll(LEFT.vertices, -1, axis=0), lambda v: (v - 1) % 4)
    assert marks(turned)[1, 2] == ((0, 3), (2, 1))
    assert marks(turned)[0, 0] == MARKS
