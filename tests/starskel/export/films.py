"""Films to be written and read back."""

from itertools import pairwise

import numpy as np

import starskel
from starskel.easing import Easing
from starskel.export.film import Film, Scene, Track
from starskel.export.settings import Settings
from starskel.files.projects.examples import example
from starskel.images.placed import PlacedImage

SLOW_START = Easing((0.5, 0.0), (1.0, 1.0))
RIM = np.array([[0, 0], [9, 0], [9, 9], [0, 9]], dtype=float)


def arm(method="stitched", **options):
    """An arm that bends."""
    pair = example("arm").pair(0)
    blend = starskel.blend(pair.source, pair.target, pair.marks, method)
    return Film("Arm", (Track(method, (Scene(blend),)),), Settings("animation", **options))


def ring(**options):
    """A square with a hole that turns and grows, and a part that comes out of a point."""
    source = starskel.Shape([RIM, RIM[:3] * 0.3 + 2])
    target = starskel.Shape([RIM * 1.5, np.array([[3, 3], [7, 4], [5, 8]]), RIM * 0.4 + 20])
    pair = starskel.match(source, target, pairing=[(0, 0), (1, 1), (None, 2)], places={(None, 2): (12, 12)})
    return Film(
        "Ring", (Track("stitched", (Scene(starskel.blend(pair)),)),), Settings("animation", **options)
    )


def steps(**options):
    """A film of two steps, the second twice as long, with other counts of vertices."""
    shapes = [RIM, np.array([[0, 0], [6, 0], [3, 7]]), np.vstack([RIM, [[-3, 4]]]) * 1.2]
    blends = [starskel.blend(a, b, marks=[(0, 0)], method="vertex") for a, b in pairwise(shapes)]
    scenes = (Scene(blends[0], name="A-B"), Scene(blends[1], length=2.0, easing=SLOW_START, name="B-C"))
    return Film("Steps", (Track("vertex", scenes),), Settings("animation", **options))


def box_side(frames):
    points = np.concatenate(frames)
    return np.ptp(points, axis=0).max()


def straying(known, seen):
    """How far points that were seen are from those known, as a part of the box of all frames that are known.

    Both are lists of frames; the first frame tells where the user's plane lies on paper, y down.
    """
    a, b = known[0], seen[0] * [1, -1]
    scale = np.linalg.norm(np.ptp(b, axis=0)) / np.linalg.norm(np.ptp(a, axis=0))
    offset = b.min(axis=0) - scale * a.min(axis=0)
    away = [(own * [1, -1] - offset) / scale - frame for frame, own in zip(known, seen, strict=True)]
    return max(np.hypot(*errors.T).max() for errors in away) / box_side(known)


def pictured(**options):
    """A square that becomes a wider one; its picture is red to the left and blue to the right."""
    made = starskel.blend(RIM, RIM * [2, 1], marks=[(0, 0), (1, 1)], method="vertex")
    pixels = np.zeros((9, 9, 3), dtype=np.uint8)
    pixels[:, :4, 0], pixels[:, 4:, 2] = 255, 255
    picture = PlacedImage(pixels), None
    return Film(
        "Two colours", (Track("vertex", (Scene(made, pictures=lambda: picture),)),), Settings(**options)
    )
