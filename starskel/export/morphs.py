"""Image morphs out: the pictures alone, edge to edge, for the editor, the command and scripts."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from starskel.export import bounds
from starskel.export.pixels import check_size
from starskel.files.disk import wrong_ending
from starskel.files.raster_writing import MOVING, write_animation, write_image
from starskel.files.video import VIDEO, write_video
from starskel.images.morph import ImageMorph
from starskel.images.placed import Pixels
from starskel.sheet.drawing import Colour, channels
from starskel.task import UNWATCHED, Task

PNG = ".png"

ENDINGS = (*MOVING, VIDEO, PNG)
"""Endings of the files that can be written."""


@dataclass(frozen=True)
class MorphSettings:
    """What is wanted of an image morph.

    Attributes
    ----------
    times : sequence of float
        The t of each frame.
    size : int
        The longer side of a frame, in pixels.
    rate : float
        Frames a second, of what moves.
    paper : str or None
        What is behind, "#rrggbb"; None leaves it transparent, in video white.
    numbered : bool
        Whether of PNG each frame is a file by itself; else all are in a row.
    hidden : collection of int
        Parts of a shape that are not painted, by the numbers of their outlines among a frame's rings.

    Raises
    ------
    StarskelError
        If a number is out of its bounds.
    """

    times: Sequence[float]
    size: int = 512
    rate: float = 25.0
    paper: Colour | None = None
    numbered: bool = False
    hidden: Collection[int] = ()

    def __post_init__(self) -> None:
        bounds.PIXELS.check(self.size)
        bounds.RATE.check(self.rate)


def check_ending(path: Path) -> None:
    """See that a morph can be written into a file of this name.

    Raises
    ------
    InvalidFile
        If its ending is none of `ENDINGS`.
    """
    if path.suffix.lower() not in ENDINGS:
        raise wrong_ending(path, ENDINGS)


def write_morph(
    path: Path, morph: ImageMorph, wanted: MorphSettings, task: Task = UNWATCHED
) -> tuple[Path, ...]:
    """Write frames of an image morph, and give the files written; the ending of the name tells the format.

    Equal morphs and settings give equal bytes.

    Parameters
    ----------
    path : Path
        Where to: GIF, APNG, WebP or MP4, which move, or PNG, frames in a row or numbered files.
    morph : ImageMorph
    wanted : MorphSettings
    task : Task
        Watches it, and may stop it.

    Raises
    ------
    InvalidFile
        If the ending is another one, or a file cannot be written.
    StarskelError
        If a row would have too many pixels.
    Cancelled
        If the task is to stop; numbered files written so far stay.
    """
    check_ending(path)
    frames = _frames(morph, wanted, task)
    ending = path.suffix.lower()
    if ending == PNG:
        if wanted.numbered and len(wanted.times) > 1:
            return _write_pictures(path, frames)
        write_image(path, _row(frames, len(wanted.times)))
        return (path,)
    write = write_video if ending == VIDEO else write_animation
    write(path, frames, [1 / wanted.rate] * len(wanted.times))
    return (path,)


def _frames(morph: ImageMorph, wanted: MorphSettings, task: Task) -> Iterator[Pixels]:
    view = morph.view
    for number, t in enumerate(wanted.times):
        task.reach(number / len(wanted.times))
        frame = morph.at(t, wanted.size, view, hidden=wanted.hidden)
        yield frame if wanted.paper is None else _on(frame, wanted.paper)
    task.reach(1)


def _on(frame: Pixels, paper: Colour) -> Pixels:
    """Put a frame on a ground of a colour."""
    alpha = frame[..., 3:] / 255
    mixed = frame[..., :3] * alpha + np.array(channels(paper)) * (1 - alpha)
    return np.concatenate([np.rint(mixed).astype(np.uint8), np.full_like(frame[..., 3:], 255)], axis=2)


def _row(frames: Iterator[Pixels], count: int) -> Pixels:
    """Put so many frames beside each other."""
    first = next(frames)
    check_size(count * first.shape[1], first.shape[0])
    return np.concatenate([first, *frames], axis=1)


def _write_pictures(path: Path, frames: Iterator[Pixels]) -> tuple[Path, ...]:
    written = []
    for number, frame in enumerate(frames, start=1):
        written.append(path.with_name(f"{path.stem}-{number:04}{path.suffix}"))
        write_image(written[-1], frame)
    return tuple(written)
