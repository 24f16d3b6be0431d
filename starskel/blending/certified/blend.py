"""The certified blend: no frame crosses itself, for any t; near the stitched blend, or the same."""

from functools import cached_property

import numpy as np

from starskel.arrays import Floats, read_only
from starskel.blending.certified.keys import Key, between
from starskel.blending.certified.path import Way, path
from starskel.blending.frames import Blend
from starskel.blending.stitched import StitchedBlend
from starskel.clearance import clearance
from starskel.decomposition.canonical import canonical
from starskel.decomposition.pieces import Decomposition
from starskel.task import UNWATCHED, Task


class CertifiedBlend(Blend):
    """Keyframes that every vertex moves evenly between, each such motion proven not to touch itself.

    The proof is exact (`starskel.certificate`) for the keyframes as they are, over all moments; a frame that
    is asked for is rounded to floats besides. Exchanging source and target gives the same frames backwards.

    Parameters
    ----------
    decomposition : Decomposition
    root : int, optional
        As for the stitched blend.
    task : Task, optional
        Watches the preparation.

    Attributes
    ----------
    how : Way
        Whether these are frames of the stitched blend, or what was done to them.
    key_times : (k,) array
        When the keyframes are, from 0 to 1.
    keys : (k, n, 2) array
        The keyframes; the first is the source and the last the target, to the bit.
    """

    method = "certified"

    key_times: Floats
    how: Way

    def __init__(self, decomposition: Decomposition, root: int | None = None, task: Task = UNWATCHED) -> None:
        super().__init__(decomposition.pair)
        self.decomposition = decomposition
        stitched = StitchedBlend(decomposition, root, task.part(0, 0.4))
        rest = task.part(0.4, 1)
        if canonical(self.pair).swapped:
            keys, self.how = path(decomposition.exchanged, lambda ts: stitched.frames(1 - ts), rest)
            keys = [Key(1 - key.t, key.frame) for key in keys[::-1]]
        else:
            keys, self.how = path(decomposition, stitched.frames, rest)
        self.key_times = read_only(np.array([key.t for key in keys]))
        self.keys = read_only(np.stack([key.frame for key in keys]))

    @cached_property
    def clearance(self) -> float:
        """The distance that every vertex keeps from every edge that it is no end of, at all times.

        A lower bound, short of the true distance by a tenth at most. Repairs keep a thousandth of the size
        where the source, the target and the way between them leave so much, and are widened towards five
        thousandths where that is to be had.
        """
        return clearance(self.keys)

    def _frames(self, ts: Floats) -> Floats:
        return between(self.key_times, self.keys, ts)
