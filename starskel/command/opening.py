"""From the name of a file to a pair of shapes."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

from starskel.errors import InvalidFile, StarskelError
from starskel.files import image_pairs, multi_pairs, pairs
from starskel.files.documents import check_format
from starskel.files.image_pairs import ImagePair, picture_of, read_image_pairs
from starskel.files.multi_pairs import read_multi_pairs
from starskel.files.pair_file import PairFile
from starskel.files.pairs import read_pairs
from starskel.files.projects import project_document
from starskel.files.projects.part_looks import part_looks
from starskel.files.projects.project import AnyPair, Project, letter
from starskel.files.projects.project_file import read_project
from starskel.files.projects.step import Step
from starskel.images.placed import PlacedImage
from starskel.reading.readers import ENDINGS
from starskel.sheet.style import PartLook

Pictures = tuple[PlacedImage | None, PlacedImage | None]


def _no_pictures(_: str) -> Pictures:
    return None, None


def _usual_looks(_: str) -> tuple[PartLook, ...]:
    return ()


@dataclass(frozen=True)
class Opened:
    """The pairs of a file; each is checked when it is asked for.

    Attributes
    ----------
    ids : tuple of str
        Their names.
    pair : callable
        Gives the pair of a name, or raises InvalidFile.
    pictures : callable
        Gives the pictures of the source and the target of a name, each where there is one.
    looks : callable
        Gives the own colours of the parts of a name, and which are hidden; nothing where all look as usual.
    name : str
        What all of them together are called, where they are the steps of one project; else "".
    steps : tuple of Step
        How these steps are gone; none where they are no steps.
    first : int
        The number of the first of these steps in the project, from 0.
    """

    ids: tuple[str, ...]
    pair: Callable[[str], AnyPair]
    pictures: Callable[[str], Pictures] = _no_pictures
    looks: Callable[[str], tuple[PartLook, ...]] = _usual_looks
    name: str = ""
    steps: tuple[Step, ...] = ()
    first: int = 0

    def step_name(self, number: int) -> str:
        """Give the letters of the two shapes of a step, "" where there is but one."""
        own = self.first + number
        return f"{letter(own)}-{letter(own + 1)}" if len(self.steps) > 1 else ""


def opened(path: Path, step: int | None = None) -> Opened:
    """Open a file of pairs, of polygons, shapes or pictures, or a project, each step of which is a pair.

    Parameters
    ----------
    path : Path
        The file.
    step : int, optional
        Only this step of a project, counted from 1.

    Raises
    ------
    InvalidFile
        If it is none of these, or cannot be read, or has no such step.
    """
    if path.suffix.lower() in ENDINGS:
        raise InvalidFile(
            f"{path} holds shapes, but does not say which becomes which",
            f"make a project of two of them: starskel convert {path} OTHER -o drawing.json",
        )
    found = check_format(path, pairs.FORMAT, multi_pairs.FORMAT, image_pairs.FORMAT, project_document.FORMAT)
    if found == project_document.FORMAT:
        return _steps(path, step)
    if step is not None:
        raise InvalidFile(f"{path} is no project and has no steps", "choose a pair: --id ID")
    if found == multi_pairs.FORMAT:
        shapes = read_multi_pairs(path)
        return Opened(shapes.ids, shapes.pair)
    if found == image_pairs.FORMAT:
        return _pictured(read_image_pairs(path))
    polygons = read_pairs(path)
    return Opened(polygons.ids, polygons.pair)


def chosen_id(path: Path, ids: Sequence[str], asked: str | None) -> str:
    """Give the name that was asked for; none has to be where there is but one.

    Raises
    ------
    InvalidFile
        If there are several and none was asked for.
    """
    if asked is None and len(ids) > 1:
        raise InvalidFile(f"{path} holds {len(ids)} pairs", f"choose one: --id {' | '.join(ids)}")
    return ids[0] if asked is None else asked


def named(error: StarskelError, pair_id: str, path: Path) -> str:
    """Give what an error says, and of which pair of which file where it does not tell."""
    text = str(error)
    return text if text.startswith(str(path)) else f'{path}: pair "{pair_id}": {text}'


def _pictured(file: PairFile[ImagePair]) -> Opened:
    def pictures(name: str) -> Pictures:
        pair = file.pair(name)
        return pair.source, pair.target

    return Opened(file.ids, lambda name: file.pair(name).shapes, pictures)


@dataclass(frozen=True)
class _Steps:
    """The steps of a project as pairs, by their names."""

    path: Path
    project: Project
    names: tuple[str, ...]

    def pair(self, name: str) -> AnyPair:
        if name not in self.names:
            raise InvalidFile(f'{self.path} has no step "{name}"', "choose one of " + ", ".join(self.names))
        try:
            return self.project.pair(self.names.index(name))
        except InvalidFile as error:
            raise error.within(self.path) from error

    def pictures(self, name: str) -> Pictures:
        step = self.names.index(name)
        source, target = (picture_of(self.path, self.project, step + k) for k in (0, 1))
        return source, target

    def looks(self, name: str) -> tuple[PartLook, ...]:
        step = self.names.index(name)
        shapes = self.project.shapes
        return part_looks(shapes[step], self.project.steps[step], shapes[step + 1])


def _steps(path: Path, step: int | None) -> Opened:
    project = read_project(path)
    if not project.name:
        project = replace(project, name=path.stem)
    names = tuple(project.step_name(k) for k in range(len(project.steps)))
    if step is not None and not 1 <= step <= len(names):
        raise InvalidFile(f"{path} has no step {step}", f"give a step from 1 to {len(names)}")
    steps = _Steps(path, project, names)
    if not any(one.parts and two.parts for one, two in pairwise(project.shapes)):
        steps.pair(names[0])  # raises: nothing in the file can be blended
    own = slice(None) if step is None else slice(step - 1, step)
    first = 0 if step is None else step - 1
    return Opened(
        names[own], steps.pair, steps.pictures, steps.looks, project.name, project.steps[own], first
    )
