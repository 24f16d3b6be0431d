"""Playback: t as a function of a monotonic clock."""

from dataclasses import dataclass, replace
from enum import Enum
from itertools import accumulate
from math import ceil, floor

from starskel.easing import EVEN, Easing

FRAMES = 100
"""So many frames apart are source and target; a blend is measured at each of them."""


class Repeat(Enum):
    """What happens at the end."""

    ONCE = "once"
    LOOP = "loop"
    PING_PONG = "ping-pong"


@dataclass(frozen=True)
class Pace:
    """How time runs over a step.

    Attributes
    ----------
    length : float
        How long the step takes, in steps of usual length.
    easing : Easing
        How t runs over it; on the way back it runs in reverse.
    """

    length: float = 1.0
    easing: Easing = EVEN


@dataclass(frozen=True)
class Playback:
    """Where on the way from the first key shape to the last we are, and how time moves us.

    The phase counts ways: it grows by one from the first shape to the last, under ping-pong by one more on
    the way back. In each step t goes from 0 to 1. All verbs take `now`, seconds of a monotonic clock.

    Attributes
    ----------
    phase : float
        The phase at the instant `since`.
    since : float or None
        The instant from which time runs, in seconds; None while paused.
    repeat : Repeat
        What happens at the end.
    speed : float
        How many times faster than `duration` says.
    duration : float
        Seconds that a step of length 1 takes at speed 1.
    paces : tuple of Pace
        How time runs over each of the steps.
    step : int
        The step that was shown last: it decides where two of them meet.
    """

    phase: float = 0.0
    since: float | None = None
    repeat: Repeat = Repeat.PING_PONG
    speed: float = 1.0
    duration: float = 3.0
    paces: tuple[Pace, ...] = (Pace(),)
    step: int = 0

    @property
    def playing(self) -> bool:
        """Whether time runs."""
        return self.since is not None

    def t(self, now: float) -> float:
        """Give t of the step that is shown, in [0, 1]."""
        return self.at(now)[1]

    def at(self, now: float) -> tuple[int, float]:
        """Give the step that is shown, and its t in [0, 1]."""
        way, bounds = self._way(now), self._bounds
        step = self.step
        if not bounds[step] <= way <= bounds[step + 1]:
            step = max(k for k in range(len(self.paces)) if bounds[k] <= way)
        start, end = bounds[step : step + 2]
        return step, self.paces[step].easing.t(min((way - start) / (end - start), 1.0))

    def _way(self, now: float) -> float:
        """Give the share of the way that time has gone, in [0, 1]."""
        phase = self._phase(now)
        if self.repeat is Repeat.ONCE:
            return min(phase, 1.0)
        if self.repeat is Repeat.LOOP:
            return phase - max(ceil(phase) - 1, 0)  # the end of a round counts as t = 1, not as t = 0
        turn = phase % 2
        return turn if turn <= 1 else 2 - turn

    def ended(self, now: float) -> bool:
        """Tell whether it has come to an end that it does not go beyond."""
        return self.repeat is Repeat.ONCE and self._phase(now) >= 1

    def play(self, now: float) -> "Playback":
        """Let time run, from the start again where the end was reached."""
        return replace(self, phase=0.0 if self.ended(now) else self._phase(now), since=now)

    def pause(self, now: float) -> "Playback":
        """Stop here."""
        return replace(self, phase=self._folded(now), since=None)

    def seek(self, t: float, now: float) -> "Playback":
        """Go to t of the step that is shown; time runs on from there if it did."""
        return self.into(self.at(now)[0], t, now)

    def into(self, step: int, t: float, now: float) -> "Playback":
        """Go to t of a step; time runs on from there if it did."""
        start, end = self._bounds[step : step + 2]
        phase = end if t >= 1 else start + self.paces[step].easing.time(t) * (end - start)
        return replace(self, phase=phase, since=now if self.playing else None, step=step)

    def over(self, paces: tuple[Pace, ...], step: int, now: float) -> "Playback":
        """Run through other steps, and go to one of them; t stays."""
        return replace(self, paces=paces, step=0).into(step, self.t(now), now)

    def at_speed(self, speed: float, now: float) -> "Playback":
        """Change the speed from now on."""
        return replace(self, phase=self._phase(now), since=now if self.playing else None, speed=speed)

    def repeating(self, repeat: Repeat, now: float) -> "Playback":
        """Change what happens at the end; t stays."""
        return replace(self, phase=self._way(now), since=now if self.playing else None, repeat=repeat)

    def advance(self, frames: int, now: float) -> "Playback":
        """Stop, and go on or back by so many of the frames that are measured, to one of them."""
        step, t = self.at(now)
        at = t * FRAMES
        near = round(at)
        whole = near if abs(at - near) < 1e-6 else (floor(at) if frames > 0 else ceil(at))
        last = FRAMES * len(self.paces)
        frame = min(max(FRAMES * step + whole + frames, 0), last)
        step = min(max((frame - (frames > 0)) // FRAMES, 0), len(self.paces) - 1)
        return replace(self, since=None).into(step, (frame - FRAMES * step) / FRAMES, now)

    @property
    def _bounds(self) -> list[float]:
        """The shares of the whole way at which steps begin and end."""
        ends = list(accumulate((pace.length for pace in self.paces), initial=0.0))
        return [end / ends[-1] for end in ends]

    def _phase(self, now: float) -> float:
        if self.since is None:
            return self.phase
        return self.phase + (now - self.since) * self.speed / (
            self.duration * sum(pace.length for pace in self.paces)
        )

    def _folded(self, now: float) -> float:
        """Give the phase without the rounds done, lest it lose digits; the direction of ping-pong stays."""
        phase = self._phase(now)
        return min(phase, 1.0) if self.repeat is Repeat.ONCE else phase % 2
