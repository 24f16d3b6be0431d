"""Where following frames leads, moment by moment."""

from dataclasses import dataclass

import numpy as np

from starskel.arrays import Floats, Indices


@dataclass(frozen=True, eq=False)
class TrackedFrames:
    """Where following led.

    Attributes
    ----------
    frames : list of (n, 2) arrays
        From the start on, each linked safely to the next.
    arrivals : (k,) array of int
        For each moment the last of these frames.
    """

    frames: list[Floats]
    arrivals: Indices

    @property
    def places(self) -> Floats:
        """The frame of each moment, (k, n, 2)."""
        return np.stack([self.frames[at] for at in self.arrivals])

    @property
    def ways(self) -> Floats:
        """How far it is to each moment's frame, (k,), each step the root mean square over the vertices."""
        steps = np.diff(np.stack(self.frames), axis=0)
        return np.concatenate([[0.0], np.cumsum(np.sqrt((steps**2).mean(axis=(1, 2))))])[self.arrivals]

    def until(self, moment: int) -> list[Floats]:
        """Give the frames up to that of a moment."""
        return self.frames[: self.arrivals[moment] + 1]

    def moments(self, moment: int) -> Indices:
        """Give for each of these the moment that it was made for."""
        return np.searchsorted(self.arrivals, np.arange(self.arrivals[moment] + 1))
