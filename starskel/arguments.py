"""What callers give, taken for what it is meant for; else an error names it, and says what to give."""

import operator
import reprlib
from collections.abc import Iterable, Mapping, Sequence
from typing import TypeVar

import numpy as np

from starskel.arrays import Floats
from starskel.errors import StarskelError, either
from starskel.predicates import LARGEST

Item = TypeVar("Item")
Key = TypeVar("Key")
Kind = TypeVar("Kind")
Raised = TypeVar("Raised", bound=StarskelError)


def refusal(given: object, what: str, mend: str, kind: type[Raised]) -> Raised:
    """Give the error that names what is given, and what it is given for."""
    short = " ".join(reprlib.repr(given).split())
    return kind(f"{short} is given for {what}", mend)


def whole_number(given: object, what: str, least: int, most: int | None = None) -> int:
    """Give a whole number, the least or more, and where there is a most no more than that.

    Raises
    ------
    StarskelError
        If it is none.
    """
    try:
        number = operator.index(given)  # type: ignore[arg-type]
    except TypeError:
        number = least - 1
    if number < least or (most is not None and number > most):
        upwards = f"{least} or more" if most is None else f"from {least} to {most}"
        raise refusal(given, what, f"give a whole number, {upwards}", StarskelError)
    return number


_NONE = np.array(np.nan)


def finite(given: object, count: int | None, what: str, kind: type[StarskelError] = StarskelError) -> Floats:
    """Give so many finite numbers, or any number of them, below `predicates.LARGEST`.

    Raises
    ------
    StarskelError
        Of this kind, if these are none, or another number of them.
    """
    try:
        numbers = np.asarray(given)
        numbers = numbers.astype(np.float64) if numbers.dtype.kind in "biufO" else _NONE
    except (TypeError, ValueError, OverflowError):
        numbers = _NONE
    listed = numbers.ndim == 1 and count in {None, len(numbers)}
    if not listed or not (np.abs(numbers) < LARGEST).all():
        raise refusal(given, what, f"give {'a list of' if count is None else count} finite numbers", kind)
    return numbers


def point(given: object, what: str, kind: type[StarskelError] = StarskelError) -> tuple[float, float]:
    """Give x and y.

    Raises
    ------
    StarskelError
        Of this kind, if these are not two finite numbers.
    """
    x, y = finite(given, 2, what, kind).tolist()
    return x, y


def truth(given: object, what: str) -> bool:
    """Give True or False.

    Raises
    ------
    StarskelError
        If it is neither.
    """
    if not isinstance(given, bool | np.bool_):
        raise refusal(given, what, "give True or False", StarskelError)
    return bool(given)


def choice(given: object, choices: Sequence[str], what: str) -> str:
    """Give one of the choices.

    Raises
    ------
    StarskelError
        If it is none.
    """
    if not isinstance(given, str) or given not in choices:
        named = either([repr(name) for name in choices])
        raise refusal(given, what, f"give {named}", StarskelError)
    return given


def instance(given: object, kind: type[Kind], what: str, mend: str) -> Kind:
    """Give an object of a kind.

    Raises
    ------
    StarskelError
        If it is none.
    """
    if not isinstance(given, kind):
        raise refusal(given, what, mend, StarskelError)
    return given


def items(
    given: Iterable[Item],
    what: str,
    mend: str,
    kind: type[StarskelError] = StarskelError,
    count: int | None = None,
) -> tuple[Item, ...]:
    """Give all items of a list, or of one with so many of them.

    Raises
    ------
    StarskelError
        Of this kind, if it is none.
    """
    try:
        found = tuple(given)
    except TypeError:
        found = None
    if found is None or count not in {None, len(found)}:
        raise refusal(given, what, mend, kind)
    return found


def mapping(
    given: Mapping[Key, Item], what: str, mend: str, kind: type[StarskelError] = StarskelError
) -> Mapping[Key, Item]:
    """Give a mapping.

    Raises
    ------
    StarskelError
        Of this kind, if it is none.
    """
    if not isinstance(given, Mapping):
        raise refusal(given, what, mend, kind)
    return given
