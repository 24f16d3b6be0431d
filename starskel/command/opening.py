"""From the name of a file to a pair of shapes."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

from starskel.errors import InvalidFile, StarskelError
from starskel.files import pairs, project
from starskel.files.documents import check_format
from starskel.files.pairs import ShapePair, read_pairs
from starskel.files.project import read_project


@dataclass(frozen=True)
class Opened:
    """The pairs of a file; each is checked when it is asked for.

    Attributes
    ----------
    ids : tuple of str
        Their names.
    pair : callable
        Gives the pair of a name, or raises InvalidFile.
    in_order : bool
        Whether they are the steps of one project, the first of which is the one to begin with.
    """

    ids: tuple[str, ...]
    pair: Callable[[str], ShapePair]
    in_order: bool = False


def opened(path: Path, step: int | None = None) -> Opened:
    """Open a file of pairs or a project, each step of which is a pair.

    Parameters
    ----------
    path : Path
        The file.
    step : int, optional
        Only this step of a project, counted from 1.

    Raises
    ------
    InvalidFile
        If it is neither, or cannot be read, or has no such step.
    """
    if check_format(path, pairs.FORMAT, project.FORMAT) == project.FORMAT:
        return _steps(path, step)
    if step is not None:
        raise InvalidFile(f"{path} is no project and has no steps", "choose a pair: --id ID")
    file = read_pairs(path)
    return Opened(file.ids, file.pair)


def chosen_pair(path: Path, pair_id: str | None, step: int | None = None) -> ShapePair:
    """Open a file and give one of its pairs; none has to be named where there is but one.

    Of a project this is the step of that number, the first where none is given.

    Raises
    ------
    InvalidFile
        If the file is invalid, or the name is missing or unknown.
    """
    file = opened(path, step)
    if pair_id is None:
        if len(file.ids) > 1 and not file.in_order:
            raise InvalidFile(
                f"{path} holds {len(file.ids)} pairs", f"choose one: --id {' | '.join(file.ids)}"
            )
        pair_id = file.ids[0]
    return file.pair(pair_id)


def named(error: StarskelError, pair_id: str, path: Path) -> str:
    """Give what an error says, and of which pair of which file where it does not tell."""
    text = str(error)
    return text if text.startswith(str(path)) else f'{path}: pair "{pair_id}": {text}'


def _steps(path: Path, step: int | None) -> Opened:
    document = read_project(path)
    if not document.name:
        document = replace(document, name=path.stem)
    names = [document.step_name(k) for k in range(len(document.steps))]
    if step is not None and not 1 <= step <= len(names):
        raise InvalidFile(f"{path} has no step {step}", f"give a step from 1 to {len(names)}")

    def pair(name: str) -> ShapePair:
        if name not in names:
            raise InvalidFile(f'{path} has no step "{name}"', "choose one of " + ", ".join(names))
        try:
            return document.pair(names.index(name))
        except InvalidFile as error:
            raise InvalidFile(f"{path}: {error.what}", error.mend) from error

    if all(None in shapes for shapes in pairwise(document.shapes)):
        pair(names[0])  # raises: nothing in the file can be blended
    return Opened(tuple(names if step is None else names[step - 1 : step]), pair, in_order=True)
