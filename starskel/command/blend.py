"""starskel blend: the keyframes of one method."""

from argparse import Namespace

import numpy as np

from starskel.blending.frames import Blend
from starskel.command.methods import blends
from starskel.command.opening import chosen_pair
from starskel.command.output import WRITERS, ending_of
from starskel.files.frames import write_frames
from starskel.files.postscript import write_postscript
from starskel.sheet.keyframe import Shown, keyframes, marked_rows
from starskel.sheet.rows import page_sheets, row_sheet


def run(arguments: Namespace) -> int:
    """Blend the pair by the method and write its keyframes."""
    ending = ending_of(arguments.output, (*WRITERS, ".json"))
    pair = chosen_pair(arguments.file, arguments.id, arguments.step)
    ((_, made),) = blends(pair, [arguments.method])
    times = times_of(arguments)
    if ending == ".json":
        write_frames(arguments.output, arguments.method, times, marked_rows(made.pair), made.frames(times))
    else:
        _write_drawing(arguments, ending, pair.id, made, times)
    return 0


def times_of(arguments: Namespace) -> list[float]:
    """Give the times asked for."""
    times: list[float] = arguments.at or np.linspace(0, 1, arguments.frames).tolist()
    return times


def shown_of(arguments: Namespace) -> Shown:
    """Give what is to be seen on the frames."""
    return Shown(arguments.marks, arguments.pieces, arguments.skeleton)


def _write_drawing(arguments: Namespace, ending: str, name: str, blend: Blend, times: list[float]) -> None:
    frames = keyframes(blend, times, shown_of(arguments))
    title = f"{name}: {arguments.method}"
    captions = not arguments.plain
    if ending == ".ps":
        write_postscript(arguments.output, page_sheets(title, frames, captions))
    elif len(frames) == 1:
        WRITERS[ending](arguments.output, page_sheets(title, frames, captions)[0])
    else:
        WRITERS[ending](arguments.output, row_sheet(title, frames, captions))
