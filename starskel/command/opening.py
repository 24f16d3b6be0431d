"""From the name of a file to a pair of shapes."""

from collections.abc import Callable
from dataclasses import dataclass
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
    """

    ids: tuple[str, ...]
    pair: Callable[[str], ShapePair]


def opened(path: Path) -> Opened:
    """Open a file of pairs or a project, which holds one.

    Raises
    ------
    InvalidFile
        If it is neither, or cannot be read.
    """
    if check_format(path, pairs.FORMAT, project.FORMAT) == pairs.FORMAT:
        file = read_pairs(path)
        return Opened(file.ids, file.pair)
    pair = _project_pair(path)
    return Opened((pair.id,), lambda _: pair)


def chosen_pair(path: Path, pair_id: str | None) -> ShapePair:
    """Open a file and give one of its pairs; none has to be named where there is but one.

    Raises
    ------
    InvalidFile
        If the file is invalid, or the name is missing or unknown.
    """
    file = opened(path)
    if pair_id is None:
        if len(file.ids) > 1:
            raise InvalidFile(
                f"{path} holds {len(file.ids)} pairs", f"choose one: --id {' | '.join(file.ids)}"
            )
        pair_id = file.ids[0]
    return file.pair(pair_id)


def named(error: StarskelError, pair_id: str, path: Path) -> str:
    """Give what an error says, and of which pair of which file where it does not tell."""
    text = str(error)
    return text if text.startswith(str(path)) else f'{path}: pair "{pair_id}": {text}'


def _project_pair(path: Path) -> ShapePair:
    document = read_project(path)
    if document.source is None or document.target is None:
        missing = "target" if document.target is None else "source"
        raise InvalidFile(f"{path} has no {missing} yet", "draw both shapes in the editor and save")
    name = document.name or path.stem
    return ShapePair(name, document.source, document.target, document.marks, description=document.description)
