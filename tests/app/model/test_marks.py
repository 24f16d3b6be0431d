from app.model.marks import witness


def test_a_third_mark_shows_that_two_are_in_different_orders() -> None:
    marks = ((0, 0), (1, 2))
    assert witness(marks, (1, 2), (2, 1)) == (0, 0)
    assert witness(((0, 5), (4, 7)), (4, 7), (6, 6)) == (0, 5)


def test_two_marks_alone_are_always_in_order() -> None:
    assert witness(((1, 2),), (1, 2), (2, 1)) is None
    assert witness(((0, 0), (1, 1)), (1, 1), (2, 2)) is None
