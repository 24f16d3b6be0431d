"""What every method offers: the in-between polygons of a pair, the frames."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from starskel.arguments import finite
from starskel.arrays import Flags, Floats
from starskel.correspondence import Correspondence
from starskel.decomposition.pieces import Decomposition
from starskel.errors import StarskelError
from starskel.skeleton import Skeleton
from starskel.task import Progress, ShouldStop, Task

_BATCH = 1 << 17
"""So many points are computed together: what they need stays in the processor's cache."""


class Blend(ABC):
    """A blend of two polygons: a polygon of as many vertices for every t in [0, 1].

    What it shares with `ShapeBlend` can be used without telling them apart: `pair`, `method`, `rings`,
    `negative_lengths`, `key_times`, `how`, `settled` and `improvements`.

    Attributes
    ----------
    pair : Correspondence
        The source, which is the frame at t = 0, and the target, at t = 1.
    method : str
        One of `starskel.METHODS`.
    decomposition : Decomposition or None
        The star pieces, where the method has them.
    skeleton : Skeleton or None
        The skeleton, where the method has one.
    key_times : (k,) array or None
        The times between which every vertex moves evenly on a straight line, 0 and 1 included; None where
        vertices move otherwise.
    how : str or None
        How the frames came about, where the method has several ways; None elsewhere.
    settled : bool
        Whether `improvements` has no better blend to come.

    Examples
    --------
    >>> import starskel
    >>> square, kite = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (3, 2), (1, 5), (-1, 2)]
    >>> blend = starskel.blend(square, kite, marks=[(0, 0)])
    >>> blend.at(1).tolist()
    [[1.0, 0.0], [3.0, 2.0], [1.0, 5.0], [-1.0, 2.0]]
    >>> blend.frames([0, 0.25, 0.5]).shape
    (3, 4, 2)
    >>> len(blend.decomposition.pieces)
    1
    """

    method: ClassVar[str]
    key_times: Floats | None = None
    how: str | None = None
    decomposition: Decomposition | None = None
    skeleton: Skeleton | None = None
    settled: bool = True

    def __init__(self, pair: Correspondence) -> None:
        self.pair = pair

    def at(self, t: float) -> Floats:
        """Give the frame at t, an (n, 2) array.

        Raises
        ------
        StarskelError
            Where t is not a number from 0 to 1.
        """
        frame: Floats = self.frames([t])[0]
        return frame

    def frames(self, ts: ArrayLike) -> Floats:
        """Give the frames at each of k times, a (k, n, 2) array.

        Parameters
        ----------
        ts : (k,) array-like
            Numbers from 0 to 1, in any order.

        Raises
        ------
        StarskelError
            Where a time is not a number from 0 to 1.
        """
        times = checked_times(ts)
        step = max(1, _BATCH // len(self.pair))
        parts = [self._frames(times[k : k + step]) for k in range(0, len(times), step)]
        return np.concatenate(parts) if parts else np.empty((0, len(self.pair), 2))

    def rings(self, ts: ArrayLike) -> list[Floats]:
        """Give each ring, here the only one, at all of k times `ts`, a (k, n, 2) array for each."""
        return [self.frames(ts)]

    def negative_lengths(self, ts: ArrayLike) -> Flags:
        """Tell at which of the times `ts` the method had to give some edge a negative length."""
        return np.zeros(len(checked_times(ts)), dtype=np.bool_)

    def improvements(
        self, *, progress: Progress | None = None, should_stop: ShouldStop | None = None
    ) -> Iterator["Blend"]:
        """Give ever better blends: fewer frames cross themselves than of the one made at once and all before.

        The last is settled. Where nothing better is found it is the blend itself but for that; a blend that
        is settled gives none.

        Parameters
        ----------
        progress : callable, optional
            Called with the fraction done.
        should_stop : callable, optional
            Asked often whether to stop.

        Raises
        ------
        Cancelled
            If ``should_stop`` answered True.
        """
        return self._improvements(Task(progress, should_stop))

    def _improvements(self, task: Task) -> Iterator["Blend"]:
        """Give better blends, if the method has them, the last of which is settled."""
        return iter(())

    @abstractmethod
    def _frames(self, ts: Floats) -> Floats:
        """Give the frames at checked times."""


def checked_times(ts: ArrayLike) -> Floats:
    """Give the times as an array.

    Raises
    ------
    StarskelError
        Where one is not a number from 0 to 1.
    """
    times = finite(ts, None, "the times")
    outside = times[~((times >= 0) & (times <= 1))]
    if len(outside):
        raise StarskelError(f"t = {outside[0]:g} is outside [0, 1]", "give numbers from 0 to 1")
    return times


def placed(frames: Floats, ts: Floats, pair: Correspondence) -> Floats:
    """Move (k, m, 2) frames so that the outline's centre of mass goes straight from source to target.

    Points behind those of the pair move along.

    The masses are those of the edges, at the mean of their lengths: they do not depend on how densely an
    outline is sampled, and not on t.
    """
    weights = row_masses(pair)
    start, end = weights @ pair.source, weights @ pair.target
    centres = (1 - ts)[:, None] * start + ts[:, None] * end
    moves = centres - np.einsum("n,knc->kc", weights, frames[:, : len(pair)])
    return np.asarray(frames + moves[:, None, :])


def row_masses(pair: Correspondence) -> Floats:
    """Give the (n,) masses of rows, together 1: half those of both edges that end there, by their lengths."""
    steps = [ring[pair.following] - ring for ring in (pair.source, pair.target)]
    lengths = [np.hypot(step[:, 0], step[:, 1]) for step in steps]
    shares = [length / length.sum() for length in lengths if length.any()]
    masses = np.sum(shares, axis=0)
    weights = masses.copy()
    weights[pair.following] += masses
    return np.asarray(weights / (2 * len(shares)))


def with_exact_ends(frames: Floats, ts: Floats, errors: Floats) -> Floats:
    """Take away what rounding left between the frames and the pair at the ends, in proportion to the time.

    Parameters
    ----------
    frames : (k, n, 2) array
    ts : (k,) array
    errors : (2, n, 2) array
        The frames at 0 and 1, less the source and the target.
    """
    t = ts[:, None, None]
    return np.asarray(frames - (1 - t) * errors[0] - t * errors[1])
