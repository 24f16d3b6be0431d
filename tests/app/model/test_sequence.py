from dataclasses import replace

import numpy as np
import pytest

from app.model import arranging
from app.model.document import Document
from app.model.history import History
from app.model.marks import Marks
from app.model.sequence import SHORTEST_DURATION, Sequence, lost_marks
from starskel.easing import Easing
from starskel.errors import InvalidMarks, StarskelError
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.step import Link, Step
from starskel.polygon import Polygon


def ring(count: int) -> Polygon:
    angles = np.arange(count) * 2 * np.pi / count
    return Polygon(np.stack([np.cos(angles), np.sin(angles)], axis=1))


A, B, C, D = ring(6), ring(7), ring(8), ring(9)
AB = ((0, 0), (2, 3), (4, 5))
BC = ((0, 1), (3, 4), (6, 7))
CD = ((1, 0), (4, 4))
SHAPES = tuple(KeyShape.of(ring) for ring in (A, B, C, D))
FOUR = Sequence(SHAPES, (Step.of(AB), replace(Step.of(BC), duration=2.0), Step.of(CD)))


def marks(sequence: Sequence) -> tuple[Marks, ...]:
    """The marks of each step, none where it has no pair of parts."""
    return tuple(step.links[0].marks if step.links else () for step in sequence.steps)


def order(sequence: Sequence) -> str:
    """The shapes by their letters, and a hyphen for each that is empty."""
    return "".join("ABCD"[SHAPES.index(shape)] if shape.parts else "-" for shape in sequence.shapes)


@pytest.fixture
def four() -> Document:
    return Document(name="four").arranged(FOUR, 1)


@pytest.mark.parametrize("step", range(3))
def test_any_step_can_be_shown_and_the_sequence_stays(four: Document, step: int) -> None:
    shown = four.showing(step)
    rings = (A, B, C, D)
    assert (shown.source, shown.target, shown.marks) == (rings[step], rings[step + 1], (AB, BC, CD)[step])
    assert shown.sequence == FOUR
    assert shown.showing(1) == four


def test_an_edit_of_a_shape_keeps_the_marks_of_both_its_steps_on_their_vertices(four: Document) -> None:
    """B is the source of the step shown, and the target of the one before."""
    x, y = (B.vertices[0] + B.vertices[1]) / 2
    longer = four.insert("source", 0, (1.2 * x, 1.2 * y)).sequence
    assert marks(longer) == (((0, 0), (2, 4), (4, 6)), ((0, 1), (4, 4), (7, 7)), CD)
    shorter = four.delete("source", [3]).sequence
    assert marks(shorter) == (((0, 0), (4, 4)), ((0, 1), (5, 7)), CD)
    redrawn = four.draw("target", A).sequence
    assert marks(redrawn) == (AB, (), ())


def test_a_shape_turned_inside_out_takes_the_marks_of_both_its_steps_along() -> None:
    triangle = Polygon([(0, 0), (10, 0), (0, 10)])
    identity = ((0, 0), (1, 1))
    three = Sequence((KeyShape.of(triangle),) * 3, (Step.of(identity), Step.of(identity)))
    moved = Document().arranged(three, 0).move("target", [0], (20, 20)).sequence
    corner = [20, 20]
    (ring,) = moved.shapes[1].rings
    assert ring.vertices[marks(moved)[0][0][1]].tolist() == corner
    assert ring.vertices[marks(moved)[1][0][0]].tolist() == corner


def test_marks_of_a_neighbouring_step_that_would_cross_refuse_the_edit() -> None:
    triangle = Polygon([(0, 0), (10, 0), (0, 10)])
    all_three = ((0, 0), (1, 1), (2, 2))
    three = Sequence((KeyShape.of(triangle),) * 3, (Step.of(), Step.of(all_three)))
    with pytest.raises(InvalidMarks):
        Document().arranged(three, 0).move("target", [0], (20, 20))


def test_an_added_shape_is_empty_and_the_step_to_it_is_shown(four: Document) -> None:
    added = arranging.add_shape(four, 3)
    assert (added.step, added.source, added.target, added.marks) == (3, D, None, ())
    assert added.sequence.durations == (1, 2, 1, 1)
    between = arranging.add_shape(four, 1)
    assert order(between.sequence) == "AB-CD"
    assert marks(between.sequence) == (AB, (), (), CD)


def test_a_copy_corresponds_to_its_original_where_that_is_marked(four: Document) -> None:
    copied = arranging.duplicate_shape(four, 1)
    assert order(copied.sequence) == "ABBCD"
    assert marks(copied.sequence) == (AB, ((0, 0), (3, 3), (5, 5), (6, 6)), BC, CD)
    assert copied.step == 1


def test_where_a_shape_is_deleted_the_marks_that_lead_through_it_are_kept(four: Document) -> None:
    rest = arranging.delete_shape(four, 1)
    assert order(rest.sequence) == "ACD"
    assert marks(rest.sequence) == (((0, 1), (2, 4)), CD)
    assert rest.sequence.durations == (2, 1)
    assert marks(arranging.delete_shape(four, 0).sequence) == (BC, CD)
    assert arranging.delete_shape(four, 3).step == 1


def test_two_shapes_are_the_least() -> None:
    with pytest.raises(StarskelError, match="keep two"):
        arranging.delete_shape(Document(), 0)


def test_a_moved_shape_keeps_the_marks_that_can_be_kept(four: Document) -> None:
    moved = arranging.move_shape(four, 1, 2)
    assert order(moved.sequence) == "ACBD"
    backwards = ((1, 0), (4, 3), (7, 6))
    assert marks(moved.sequence) == (((0, 1), (2, 4)), backwards, ((0, 0), (3, 4)))
    assert moved.sequence.durations == FOUR.durations
    assert moved.source == B
    assert arranging.move_shape(arranging.move_shape(four, 1, 0), 0, 1).sequence.shapes == FOUR.shapes


@pytest.mark.parametrize("shape", range(4))
def test_every_move_keeps_the_shapes_and_shows_the_one_moved(four: Document, shape: int) -> None:
    for to in range(4):
        moved = arranging.move_shape(four.showing(min(shape, 2)), shape, to)
        assert sorted(order(moved.sequence)) == list("ABCD")
        assert moved.sequence.shapes[to] == FOUR.shapes[shape]
        assert FOUR.shapes[shape] in (moved.shape("source"), moved.shape("target"))


def test_times_follow_from_the_durations(four: Document) -> None:
    assert FOUR.times == (0, 0.25, 0.75, 1)
    longer = arranging.set_duration(four, 0, 5.0)
    assert longer.sequence.times == (0, 5 / 8, 7 / 8, 1)
    assert longer.step == four.step
    with pytest.raises(StarskelError):
        arranging.set_duration(four, 0, SHORTEST_DURATION / 2)


def test_two_shapes_are_a_sequence_of_one_step() -> None:
    two = Document.of(source=A, target=B, marks=AB)
    assert two.sequence == Sequence((KeyShape.of(A), KeyShape.of(B)), (Step.of(AB),))
    assert two.sequence.times == (0, 1)


def test_looking_at_another_step_is_no_edit(four: Document) -> None:
    history = History.of(four).push(four.unmark(0), "Remove mark").undo()
    seen = history.showing(2)
    assert seen.document.step == 2
    assert seen.redoes == "Remove mark"
    assert seen.redo().document.step == 1


def test_marks_that_go_are_counted_on_the_shapes_that_stay(four: Document) -> None:
    assert lost_marks(FOUR, four.delete("source", [3]).sequence) == 2  # one towards A and one towards C
    assert lost_marks(FOUR, arranging.delete_shape(four, 1).sequence) == 2
    assert lost_marks(FOUR, arranging.duplicate_shape(four, 1).sequence) == 0
    assert lost_marks(FOUR, four.unmark(0).sequence) == 0
    assert lost_marks(FOUR, four.exchanged().sequence) > 0


def test_the_shapes_of_a_step_are_exchanged_with_their_marks(four: Document) -> None:
    exchanged = four.exchanged()
    assert order(exchanged.sequence) == "ACBD"
    assert exchanged.marks == ((1, 0), (4, 3), (7, 6))
    assert set(four.marked("source")) == {0, 3, 5, 6}


SLOW, FAST = Easing((0.5, 0.0), (1.0, 1.0)), Easing((0.0, 0.5), (1.0, 1.0))


@pytest.fixture
def steered() -> Document:
    """Four shapes; the first step is eased, the second is eased and steered, the last is as usual."""
    steps = (
        replace(Step.of(AB), easing=SLOW),
        Step((Link(0, 0, BC, root=(0.5, 0.0)),), duration=2.0, easing=FAST, turns=2),
        Step.of(CD),
    )
    return Document().arranged(Sequence(SHAPES, steps), 1)


def test_how_a_step_goes_follows_the_shape_that_it_begins_at(steered: Document) -> None:
    last, rest = arranging.move_shape(steered, 1, 3).sequence, arranging.delete_shape(steered, 2).sequence
    assert order(last) == "ACDB"
    assert [step.easing for step in last.steps] == [SLOW, Easing(), Easing()]
    assert order(rest) == "ABD"
    assert [(step.easing, step.links[0].root, step.turns) for step in rest.steps] == [
        (SLOW, None, 0),
        (FAST, (0.5, 0.0), 2),
    ]


def test_a_new_shape_leaves_what_was_set_where_it_is(steered: Document) -> None:
    added, copied = arranging.add_shape(steered, 1).sequence, arranging.duplicate_shape(steered, 1).sequence
    assert [step.turns for step in added.steps] == [0, 2, 0, 0]
    assert [step.turns for step in copied.steps] == [0, 0, 2, 0]
    assert [step.easing for step in copied.steps] == [SLOW, Easing(), FAST, Easing()]


def test_a_step_turned_round_goes_back_as_it_came(steered: Document) -> None:
    way = steered.exchanged().way
    assert (way.easing, way.roots, way.turns) == (FAST.reversed, {}, -2)
    assert steered.exchanged().marks == tuple((j, i) for i, j in BC)
    assert steered.exchanged().exchanged().way.turns == 2


def test_all_steps_are_eased_alike(steered: Document) -> None:
    assert {step.easing for step in arranging.ease_alike(steered).sequence.steps} == {FAST}
