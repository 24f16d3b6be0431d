import numpy as np
import pytest

from app.model.document import Document, lost_marks
from app.model.history import History
from app.model.sequence import SHORTEST, Sequence
from starskel.easing import Easing
from starskel.errors import InvalidMarks, StarskelError
from starskel.files.step import Step
from starskel.polygon import Polygon


def ring(count: int) -> Polygon:
    angles = np.arange(count) * 2 * np.pi / count
    return Polygon(np.stack([np.cos(angles), np.sin(angles)], axis=1))


A, B, C, D = ring(6), ring(7), ring(8), ring(9)
AB = ((0, 0), (2, 3), (4, 5))
BC = ((0, 1), (3, 4), (6, 7))
CD = ((1, 0), (4, 4))
FOUR = Sequence((A, B, C, D), (Step(AB), Step(BC, 2.0), Step(CD)))


@pytest.fixture
def four() -> Document:
    return Document(name="four").arranged(FOUR, 1)


@pytest.mark.parametrize("step", range(3))
def test_any_step_can_be_shown_and_the_sequence_stays(four: Document, step: int) -> None:
    shown = four.showing(step)
    assert (shown.source, shown.target, shown.marks) == (
        FOUR.shapes[step],
        FOUR.shapes[step + 1],
        FOUR.marks[step],
    )
    assert shown.sequence == FOUR
    assert shown.showing(1) == four


def test_an_edit_of_a_shape_keeps_the_marks_of_both_its_steps_on_their_vertices(four: Document) -> None:
    """B is the source of the step shown, and the target of the one before."""
    x, y = (B.vertices[0] + B.vertices[1]) / 2
    longer = four.insert("source", 0, (1.2 * x, 1.2 * y)).sequence
    assert longer.marks == (((0, 0), (2, 4), (4, 6)), ((0, 1), (4, 4), (7, 7)), CD)
    shorter = four.delete("source", [3]).sequence
    assert shorter.marks == (((0, 0), (4, 4)), ((0, 1), (5, 7)), CD)
    redrawn = four.draw("target", A).sequence
    assert redrawn.marks == (AB, (), ())


def test_a_shape_turned_inside_out_takes_the_marks_of_both_its_steps_along() -> None:
    triangle = Polygon([(0, 0), (10, 0), (0, 10)])
    identity = ((0, 0), (1, 1))
    three = Sequence((triangle,) * 3, (Step(identity), Step(identity)))
    moved = Document().arranged(three, 0).move("target", [0], (20, 20)).sequence
    corner = [20, 20]
    assert moved.shapes[1] is not None
    assert moved.shapes[1].vertices[moved.marks[0][0][1]].tolist() == corner
    assert moved.shapes[1].vertices[moved.marks[1][0][0]].tolist() == corner


def test_marks_of_a_neighbouring_step_that_would_cross_refuse_the_edit() -> None:
    triangle = Polygon([(0, 0), (10, 0), (0, 10)])
    all_three = ((0, 0), (1, 1), (2, 2))
    three = Sequence((triangle,) * 3, (Step(), Step(all_three)))
    with pytest.raises(InvalidMarks):
        Document().arranged(three, 0).move("target", [0], (20, 20))


def test_an_added_shape_is_empty_and_the_step_to_it_is_shown(four: Document) -> None:
    added = four.add_shape(3)
    assert (added.step, added.source, added.target, added.marks) == (3, D, None, ())
    assert added.sequence.durations == (1, 2, 1, 1)
    between = four.add_shape(1)
    assert between.sequence.shapes == (A, B, None, C, D)
    assert between.sequence.marks == (AB, (), (), CD)


def test_a_copy_corresponds_to_its_original_where_that_is_marked(four: Document) -> None:
    copied = four.duplicate_shape(1)
    assert copied.sequence.shapes == (A, B, B, C, D)
    assert copied.sequence.marks == (AB, ((0, 0), (3, 3), (5, 5), (6, 6)), BC, CD)
    assert copied.step == 1


def test_where_a_shape_is_deleted_the_marks_that_lead_through_it_are_kept(four: Document) -> None:
    rest = four.delete_shape(1)
    assert rest.sequence.shapes == (A, C, D)
    assert rest.sequence.marks == (((0, 1), (2, 4)), CD)
    assert rest.sequence.durations == (2, 1)
    assert four.delete_shape(0).sequence.marks == (BC, CD)
    assert four.delete_shape(3).step == 1


def test_two_shapes_are_the_least() -> None:
    with pytest.raises(StarskelError, match="keep two"):
        Document().delete_shape(0)


def test_a_moved_shape_keeps_the_marks_that_can_be_kept(four: Document) -> None:
    moved = four.move_shape(1, 2)
    assert moved.sequence.shapes == (A, C, B, D)
    backwards = ((1, 0), (4, 3), (7, 6))
    assert moved.sequence.marks == (((0, 1), (2, 4)), backwards, ((0, 0), (3, 4)))
    assert moved.sequence.durations == FOUR.durations
    assert moved.source == B
    assert four.move_shape(1, 0).move_shape(0, 1).sequence.shapes == FOUR.shapes


@pytest.mark.parametrize("shape", range(4))
def test_every_move_keeps_the_shapes_and_shows_the_one_moved(four: Document, shape: int) -> None:
    for to in range(4):
        moved = four.showing(min(shape, 2)).move_shape(shape, to)
        assert set(moved.sequence.shapes) == set(FOUR.shapes)
        assert moved.sequence.shapes[to] == FOUR.shapes[shape]
        assert FOUR.shapes[shape] in (moved.source, moved.target)


def test_times_follow_from_the_durations(four: Document) -> None:
    assert FOUR.times == (0, 0.25, 0.75, 1)
    longer = four.set_duration(0, 5.0)
    assert longer.sequence.times == (0, 5 / 8, 7 / 8, 1)
    assert longer.step == four.step
    with pytest.raises(StarskelError):
        four.set_duration(0, SHORTEST / 2)


def test_two_shapes_are_a_sequence_of_one_step() -> None:
    two = Document.of(source=A, target=B, marks=AB)
    assert two.sequence == Sequence((A, B), (Step(AB),))
    assert two.sequence.times == (0, 1)


def test_looking_at_another_step_is_no_edit(four: Document) -> None:
    history = History.of(four).push(four.unmark(0), "Remove mark").undo()
    seen = history.showing(2)
    assert seen.document.step == 2
    assert seen.redoes == "Remove mark"
    assert seen.redo().document.step == 1


def test_marks_that_go_are_counted_on_the_shapes_that_stay(four: Document) -> None:
    assert lost_marks(four, four.delete("source", [3])) == 2  # one towards A and one towards C
    assert lost_marks(four, four.delete_shape(1)) == 2
    assert lost_marks(four, four.duplicate_shape(1)) == 0
    assert lost_marks(four, four.unmark(0)) == 0
    assert lost_marks(four, four.exchanged()) > 0


def test_the_shapes_of_a_step_are_exchanged_with_their_marks(four: Document) -> None:
    exchanged = four.exchanged()
    assert exchanged.sequence.shapes == (A, C, B, D)
    assert exchanged.marks == ((1, 0), (4, 3), (7, 6))
    assert set(four.marked("source")) == {0, 3, 5, 6}


SLOW, FAST = Easing((0.5, 0.0), (1.0, 1.0)), Easing((0.0, 0.5), (1.0, 1.0))


@pytest.fixture
def steered() -> Document:
    """Four shapes; the first step is eased, the second is eased and steered, the last is as usual."""
    steps = (Step(AB, easing=SLOW), Step(BC, 2.0, FAST, (0.5, 0.0), 2), Step(CD))
    return Document().arranged(Sequence((A, B, C, D), steps), 1)


def test_how_a_step_goes_follows_the_shape_that_it_begins_at(steered: Document) -> None:
    last, rest = steered.move_shape(1, 3).sequence, steered.delete_shape(2).sequence
    assert last.shapes == (A, C, D, B)
    assert [step.easing for step in last.steps] == [SLOW, Easing(), Easing()]
    assert rest.shapes == (A, B, D)
    assert [(step.easing, step.root, step.turns) for step in rest.steps] == [
        (SLOW, None, 0),
        (FAST, (0.5, 0.0), 2),
    ]


def test_a_new_shape_leaves_what_was_set_where_it_is(steered: Document) -> None:
    added, copied = steered.add_shape(1).sequence, steered.duplicate_shape(1).sequence
    assert [step.turns for step in added.steps] == [0, 2, 0, 0]
    assert [step.turns for step in copied.steps] == [0, 0, 2, 0]
    assert [step.easing for step in copied.steps] == [SLOW, Easing(), FAST, Easing()]


def test_a_step_turned_round_goes_back_as_it_came(steered: Document) -> None:
    way = steered.exchanged().way
    assert (way.easing, way.root, way.turns) == (FAST.reversed, None, -2)
    assert way.marks == tuple((j, i) for i, j in BC)
    assert steered.exchanged().exchanged().way.turns == 2


def test_all_steps_are_eased_alike(steered: Document) -> None:
    assert {step.easing for step in steered.ease_alike().sequence.steps} == {FAST}
