"""starskel blend: the keyframes of one method."""

from argparse import Namespace

import numpy as np

from starskel.command.methods import blends
from starskel.command.opening import chosen_pair
from starskel.command.output import WRITERS, ending_of, write_keyframes
from starskel.command.shapes import blend_shapes
from starskel.errors import InvalidFile
from starskel.files import multi_pairs
from starskel.files.documents import format_of
from starskel.files.frames import write_frames
from starskel.sheet.keyframe import Shown, keyframes, marked_rows


def run(arguments: Namespace) -> int:
    """Blend the pair by the method and write its keyframes."""
    ending = ending_of(arguments.output, (*WRITERS, ".json"))
    if format_of(arguments.file) == multi_pairs.FORMAT:
        return blend_shapes(arguments, ending, times_of(arguments))
    if arguments.separate:
        raise InvalidFile(f"{arguments.file} holds no shapes of several polygons", "leave out --separate")
    pair = chosen_pair(arguments.file, arguments.id, arguments.step)
    ((_, made),) = blends(pair, [arguments.method])
    times = times_of(arguments)
    if ending == ".json":
        write_frames(arguments.output, arguments.method, times, marked_rows(made.pair), made.frames(times))
    else:
        frames = keyframes(made, times, shown_of(arguments))
        write_keyframes(arguments, ending, f"{pair.id}: {arguments.method}", frames)
    return 0


def times_of(arguments: Namespace) -> list[float]:
    """Give the times asked for."""
    times: list[float] = arguments.at or np.linspace(0, 1, arguments.frames).tolist()
    return times


def shown_of(arguments: Namespace) -> Shown:
    """Give what is to be seen on the frames."""
    return Shown(arguments.marks, arguments.pieces, arguments.skeleton)
