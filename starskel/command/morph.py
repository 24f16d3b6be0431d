"""starskel morph: pictures inside shapes, as a moving picture, a row of frames or numbered files."""

from argparse import Namespace
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from starskel.command.methods import blends
from starskel.command.opening import chosen_id, opened
from starskel.command.progress import Progress
from starskel.easing import EVEN, Easing
from starskel.errors import InvalidFile, either
from starskel.export.settings import even_times
from starskel.files import image_pairs, project_file
from starskel.files.documents import check_format
from starskel.files.image_pairs import ImagePair, of_project, read_image_pairs
from starskel.files.project_file import read_project
from starskel.files.raster import MOVING, write_animation, write_image
from starskel.files.video import VIDEO, write_video
from starskel.images.morph import SOLID, ImageMorph, smooth
from starskel.images.placed import Pixels


def run(arguments: Namespace) -> int:
    """Morph the pictures of a pair and write the frames."""
    path = arguments.output
    if (ending := path.suffix.lower()) not in (known := (".png", *MOVING, VIDEO)):
        raise InvalidFile(f'{path.name} ends in "{path.suffix}"', f"end it in {either(known)}")
    pair, easing = _opened(arguments)
    ((_, made),) = blends(pair.shapes, [arguments.method])
    fade, solid = (smooth if arguments.fade == "smooth" else float), (0 if arguments.as_it_is else SOLID)
    with Progress(f"{pair.shapes.id}: pictures") as bar:
        morph = ImageMorph(made, pair.source, pair.target, fade=fade, solid=solid, progress=bar)
    times = _times(arguments, ending)
    if arguments.eased:
        times = [easing.t(time) for time in times]
    frames = _frames(morph, times, arguments, pair.shapes.id)
    if ending == ".png":
        _write_pictures(path, frames, numbered=arguments.layout == "frames" and len(times) > 1)
    else:
        write = write_video if ending == VIDEO else write_animation
        write(path, frames, [1 / arguments.rate] * len(times))
    return 0


def _opened(arguments: Namespace) -> tuple[ImagePair, Easing]:
    """Give the pair that the words mean, and how its frames follow each other."""
    path: Path = arguments.file
    if check_format(path, image_pairs.FORMAT, project_file.FORMAT) == image_pairs.FORMAT:
        if arguments.step is not None:
            raise InvalidFile(f"{path} is no project and has no steps", "choose a pair: --id ID")
        file = read_image_pairs(path)
        return file.pair(chosen_id(path, file.ids, arguments.id)), EVEN
    steps = opened(path, arguments.step)
    name = steps.pair(arguments.id or steps.ids[0]).id
    document = read_project(path)
    document = replace(document, name=document.name or path.stem)
    step = next(k for k in range(len(document.steps)) if document.step_name(k) == name)
    return of_project(path, document, step), document.steps[step].easing


def _times(arguments: Namespace, ending: str) -> list[float]:
    """Give the times of frames: those asked for, or for what moves as many as its duration needs."""
    if arguments.at:
        return list(arguments.at)
    if ending == ".png":
        return list(even_times(arguments.frames))
    times = list(even_times(max(2, round(arguments.duration * arguments.rate))))
    return [*times, *times[-2:0:-1]] if arguments.returning else times


def _frames(morph: ImageMorph, times: list[float], arguments: Namespace, name: str) -> Iterator[Pixels]:
    view = morph.view
    with Progress(f"{name}: frames") as bar:
        for number, t in enumerate(times):
            bar(number / len(times))
            frame = morph.at(t, arguments.size, view)
            yield frame if arguments.paper is None else _on(frame, arguments.paper)


def _on(frame: Pixels, paper: str) -> Pixels:
    """Put a frame on a ground of a colour."""
    alpha = frame[..., 3:] / 255
    mixed = frame[..., :3] * alpha + np.array(list(bytes.fromhex(paper[1:]))) * (1 - alpha)
    return np.concatenate([np.rint(mixed).astype(np.uint8), np.full_like(frame[..., 3:], 255)], axis=2)


def _write_pictures(path: Path, frames: Iterator[Pixels], *, numbered: bool) -> None:
    """Write a file for each, or all in a row."""
    if not numbered:
        write_image(path, np.concatenate(list(frames), axis=1))
        return
    for number, frame in enumerate(frames, start=1):
        write_image(path.with_name(f"{path.stem}-{number:04}{path.suffix}"), frame)
