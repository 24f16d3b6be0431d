"""From the name of a file to what is to be drawn of it: the ways of all methods through its steps."""

from argparse import Namespace
from collections.abc import Sequence

from starskel.command.methods import blends
from starskel.command.opening import Opened, chosen_id, opened
from starskel.command.shapes import shape_tracks
from starskel.errors import InvalidFile
from starskel.export.film import Scene, Track
from starskel.files import multi_pairs
from starskel.files.documents import format_of
from starskel.quality import measure


def opened_film(
    arguments: Namespace, methods: Sequence[str], *, measured: bool
) -> tuple[str, tuple[Track, ...]]:
    """Blend what the file holds by each of the methods, and measure it where that is wanted.

    Of a project these are all its steps, or the one that was asked for.

    Returns
    -------
    name : str
        What is blended.
    tracks : tuple of Track

    Raises
    ------
    StarskelError
        If the file is invalid, or holds no such pair, or it cannot be blended.
    """
    if format_of(arguments.file) == multi_pairs.FORMAT:
        return shape_tracks(arguments, methods, measured=measured)
    if arguments.separate:
        raise InvalidFile(f"{arguments.file} holds no shapes of several polygons", "leave out --separate")
    file = opened(arguments.file, arguments.step)
    if file.steps and arguments.id is None:
        return file.name if len(file.ids) > 1 else file.ids[0], _tracks(file, file.ids, methods, measured)
    pair_id = chosen_id(arguments.file, file.ids, arguments.id)
    return pair_id, _tracks(file, [pair_id], methods, measured)


def _tracks(file: Opened, ids: Sequence[str], methods: Sequence[str], measured: bool) -> tuple[Track, ...]:
    scenes: dict[str, list[Scene]] = {method: [] for method in methods}
    for pair_id in ids:
        for method, blend in blends(file.pair(pair_id), methods):
            report = measure(blend) if measured else None
            scenes[method].append(_scene(file, pair_id, Scene(blend, report)))
    return tuple(Track(method, tuple(own)) for method, own in scenes.items())


def _scene(file: Opened, pair_id: str, scene: Scene) -> Scene:
    if not file.steps:
        return scene
    number = file.ids.index(pair_id)
    step = file.steps[number]
    return Scene(scene.blend, scene.report, step.duration, step.easing, name=file.step_name(number))
