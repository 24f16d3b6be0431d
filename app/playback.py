"""Playback: t as a function of a monotonic clock."""

from dataclasses import dataclass, replace
from enum import Enum
from math import ceil, floor

from app.model.easing import Easing

EVEN = Easing()

FRAMES = 100
"""Steps from the source to the target; a blend is measured at their ends."""


class Repeat(Enum):
    """What happens at the end."""

    ONCE = "once"
    LOOP = "loop"
    PING_PONG = "ping-pong"


@dataclass(frozen=True)
class Playback:
    """Where on the way from source to target we are, and how time moves us.

    The phase counts ways: it grows by one while t goes from 0 to 1, and under ping-pong by one more on the
    way back. All verbs take `now`, seconds of a monotonic clock.

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
        Seconds from t = 0 to t = 1 at speed 1.
    easing : Easing
        How t runs over a way; on the way back it runs in reverse.
    """

    phase: float = 0.0
    since: float | None = None
    repeat: Repeat = Repeat.PING_PONG
    speed: float = 1.0
    duration: float = 3.0
    easing: Easing = EVEN

    @property
    def playing(self) -> bool:
        """Whether time runs."""
        return self.since is not None

    def t(self, now: float) -> float:
        """Give t in [0, 1]."""
        return self.easing.t(self._way(now))

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
        """Go to t; time runs on from there if it did."""
        return replace(self, phase=self.easing.time(t), since=now if self.playing else None)

    def at_speed(self, speed: float, now: float) -> "Playback":
        """Change the speed from now on."""
        return replace(self, phase=self._phase(now), since=now if self.playing else None, speed=speed)

    def repeating(self, repeat: Repeat, now: float) -> "Playback":
        """Change what happens at the end; t stays."""
        return replace(self, phase=self._way(now), since=now if self.playing else None, repeat=repeat)

    def eased(self, easing: Easing, now: float) -> "Playback":
        """Change the easing; t stays."""
        return replace(self, easing=easing).seek(self.t(now), now)

    def step(self, frames: int, now: float) -> "Playback":
        """Stop, and go on or back by so many of the frames that are measured, to one of them."""
        at = self.t(now) * FRAMES
        near = round(at)
        whole = near if abs(at - near) < 1e-6 else (floor(at) if frames > 0 else ceil(at))
        return replace(self, since=None).seek(min(max(whole + frames, 0), FRAMES) / FRAMES, now)

    def _phase(self, now: float) -> float:
        if self.since is None:
            return self.phase
        return self.phase + (now - self.since) * self.speed / self.duration

    def _folded(self, now: float) -> float:
        """Give the phase without the rounds done, lest it lose digits; the direction of ping-pong stays."""
        phase = self._phase(now)
        return min(phase, 1.0) if self.repeat is Repeat.ONCE else phase % 2
