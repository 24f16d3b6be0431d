import pickle
from importlib import import_module

import pytest

from starskel.errors import (
    Cancelled,
    InvalidFile,
    InvalidMarks,
    InvalidPolygon,
    NewerFile,
    NoDecomposition,
    StarskelError,
    UnknownMethod,
    told,
)

ERRORS = [
    StarskelError("no picture"),
    InvalidPolygon("too few points", "give more", vertices=(1, 2), place=(0.5, 1.5)),
    InvalidMarks("marks cross", "remove one", marks=[(0, 1)]),
    NoDecomposition("there is none", "allow Steiner vertices"),
    UnknownMethod("no such method", "choose another"),
    InvalidFile("it is damaged", "give another"),
    NewerFile("it is of version 1000", "open it with a newer program"),
    Cancelled(),
]


@pytest.mark.parametrize("error", ERRORS, ids=lambda error: type(error).__name__)
def test_errors_reach_other_processes_as_they_are(error: StarskelError) -> None:
    sent = pickle.loads(pickle.dumps(error))
    assert type(sent) is type(error)
    assert str(sent) == str(error)
    assert vars(sent) == vars(error)


@pytest.mark.parametrize("error", ERRORS, ids=lambda error: type(error).__name__)
def test_an_error_within_something_is_the_same_but_for_its_place(error: StarskelError) -> None:
    import_module("distributed")  # changes how errors are copied
    before = dict(vars(error))
    within = error.within(told("ring {number}", number=2))
    assert vars(error) == before
    assert type(within) is type(error)
    assert within.what == f"ring 2: {error.what}"
    assert vars(within) == {**vars(error), "what": within.what}
    assert str(within) == f"ring 2: {error}"


def test_what_a_file_holds_is_told_as_a_fault_of_the_file() -> None:
    error = InvalidFile.holding(ERRORS[1], "drawing.svg")
    assert str(error) == "drawing.svg: too few points; give more"
