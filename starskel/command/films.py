"""From the name of a file to what is to be drawn of it: by all methods, through its steps."""

from argparse import Namespace
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from starskel.command.opening import Opened, chosen_id, opened
from starskel.command.variants import blends_of, variants_of
from starskel.export.film import Scene, Track
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
    file = opened(arguments.file, arguments.step)
    if file.steps and arguments.id is None:
        name = file.name if len(file.ids) > 1 else file.ids[0]
        return name, _tracks(arguments, file, file.ids, methods, measured)
    pair_id = chosen_id(arguments.file, file.ids, arguments.id)
    return pair_id, _tracks(arguments, file, [pair_id], methods, measured)


def _tracks(
    arguments: Namespace, file: Opened, ids: Sequence[str], methods: Sequence[str], measured: bool
) -> tuple[Track, ...]:
    pairs = {pair_id: file.pair(pair_id) for pair_id in ids}
    variants = variants_of(arguments, list(pairs.values()), methods, measured=measured)
    scenes: dict[str, list[Scene]] = {variant.name: [] for variant in variants}
    for pair_id, pair in pairs.items():
        for name, blend in blends_of(pair, variants):
            report = measure(blend) if measured else None
            scenes[name].append(_scene(file, pair_id, Scene(blend, report)))
    return tuple(Track(name, tuple(own)) for name, own in scenes.items())


def _scene(file: Opened, pair_id: str, scene: Scene) -> Scene:
    scene = replace(scene, pictures=partial(file.pictures, pair_id), looks=file.looks(pair_id))
    if not file.steps:
        return scene
    number = file.ids.index(pair_id)
    step = file.steps[number]
    return replace(scene, length=step.duration, easing=step.easing, name=file.step_name(number))
