"""What can go wrong, in words: every error says what is wrong, where, and how to mend it."""

from collections.abc import Sequence
from functools import reduce
from typing import Self

_LONGEST = 1000
"""Letters of a value that errors show."""


class Told(str):
    """A text made of a template and values, which it remembers: so it can be told again in another language.

    Attributes
    ----------
    template : str
        The text with names in braces, as `str.format` takes them.
    values : dict of str to object
        What was put in their places; texts among them may have been told too.
    """

    __slots__ = ("template", "values")

    template: str
    values: dict[str, object]


def told(template: str, **values: object) -> Told:
    """Fill a template. The translation tools look for calls of this name.

    Of long values the middle is left out: what files hold may be of any length.
    """
    shown = {name: _shortened(value) for name, value in values.items()}
    text = Told(template.format(**shown))
    text.template = template
    text.values = shown
    return text


def _shortened(value: object) -> object:
    if isinstance(value, Told) or not isinstance(value, str | Exception):
        return value
    words = str(value)
    return words if len(words) <= _LONGEST else f"{words[: _LONGEST // 2]} … {words[-_LONGEST // 2 :]}"


def either(names: Sequence[str]) -> str:
    """Give names as a choice: "a or b or c"."""
    return reduce(lambda first, second: told("{first} or {second}", first=first, second=second), names)


class StarskelError(ValueError):
    """The base of all errors that the library raises on purpose.

    Parameters
    ----------
    what : str
        What is wrong, and where.
    mend : str
        How to mend it.

    Examples
    --------
    >>> import starskel
    >>> try:
    ...     starskel.Polygon([(0, 0), (1, 0)])
    ... except starskel.StarskelError as error:
    ...     print(error.what)
    ...     print(error.mend)
    a polygon of 2 points
    give at least 3 vertices
    """

    def __init__(self, what: str, mend: str = "") -> None:
        super().__init__(what, mend)
        self.what = what
        self.mend = mend

    def __str__(self) -> str:
        return f"{self.what}; {self.mend}" if self.mend else self.what

    def within(self, where: object) -> Self:
        """Give the same error, with `where` it is put in front: "ring 2: a polygon of 2 points"."""
        # not by copy: where distributed is loaded, copies of errors share their attributes
        error = type(self).__new__(type(self), *self.args)
        vars(error).update(vars(self), what=told("{where}: {what}", where=where, what=self.what))
        return error


class InvalidPolygon(StarskelError):
    """The points do not form a simple polygon.

    Attributes
    ----------
    vertices : tuple of int
        The vertices concerned, as indices of the points given.
    place : tuple of float or None
        Coordinates of the fault, where it has a place.

    Examples
    --------
    >>> import starskel
    >>> try:
    ...     starskel.Polygon([(0, 0), (2, 2), (2, 0), (0, 2)])
    ... except starskel.InvalidPolygon as error:
    ...     print(error.vertices, error.place)
    (0, 1, 2, 3) (1.0, 1.0)
    """

    def __init__(
        self,
        what: str,
        mend: str,
        vertices: Sequence[int] = (),
        place: tuple[float, float] | None = None,
    ) -> None:
        super().__init__(what, mend)
        self.vertices = tuple(vertices)
        self.place = place


class InvalidMarks(StarskelError):
    """Marks that name missing vertices, repeat one, or go round the shapes in different orders.

    Attributes
    ----------
    marks : tuple of (int, int)
        The marks in conflict, as given.

    Examples
    --------
    >>> import starskel
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> try:
    ...     starskel.match(square, square, marks=[(0, 0), (1, 2), (2, 1)])
    ... except starskel.InvalidMarks as error:
    ...     print(error.marks)
    ((0, 0), (2, 1))
    """

    def __init__(self, what: str, mend: str, marks: Sequence[tuple[int, int]] = ()) -> None:
        super().__init__(what, mend)
        self.marks = tuple(marks)


class NoDecomposition(StarskelError):
    """The pair has no compatible star decomposition without Steiner vertices.

    Examples
    --------
    >>> import starskel
    >>> hook = [(0, 0), (6, 0), (6, 5), (3, 5), (3, 4), (5, 4), (5, 1), (0, 1)]
    >>> pair = starskel.match(hook, hook, marks=[(0, 1), (4, 5)])
    >>> try:
    ...     starskel.decompose(pair, steiner=False)
    ... except starskel.NoDecomposition as error:
    ...     print(error.mend)
    allow Steiner vertices, or change the marks
    """


class UnknownMethod(StarskelError):
    """There is no blending method of that name.

    Examples
    --------
    >>> import starskel
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> try:
    ...     starskel.blend(square, square, method="morph")
    ... except starskel.UnknownMethod as error:
    ...     print(error.what)
    there is no method "morph"
    """


class InvalidFile(StarskelError):
    """A file cannot be read, is damaged, or does not hold what was asked of it.

    Examples
    --------
    >>> from pathlib import Path
    >>> from starskel.reading.readers import read_shapes
    >>> read_shapes(Path("notes.txt"))  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    starskel.errors.InvalidFile: notes.txt ends in ".txt"; give a file that ends in .svg or .geojson or ...
    """

    @classmethod
    def holding(cls, error: StarskelError, where: object) -> "InvalidFile":
        """Give the `error` of what a file holds as one of the file, or of the place in it, `where` it is."""
        return cls(error.within(where).what, error.mend)


class NewerFile(InvalidFile):
    """A file that a newer program has written: nothing is wrong with it, but it cannot be read here."""


class Cancelled(StarskelError):
    """The caller's ``should_stop`` answered True.

    Examples
    --------
    >>> import starskel
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> starskel.blend(square, square, should_stop=lambda: True)
    Traceback (most recent call last):
    starskel.errors.Cancelled: cancelled
    """

    def __init__(self, what: str = "cancelled", mend: str = "") -> None:
        super().__init__(what, mend)
