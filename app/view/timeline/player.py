"""Player: the clock that moves t; whoever shows a moment listens to it."""

from dataclasses import replace
from time import monotonic

from PySide6.QtCore import QObject, Qt, QTimer, Signal, Slot

from app.playback import Pace, Playback, Repeat
from starskel.easing import Easing

TICK = 16
"""Milliseconds between frames; t comes from the clock, so a late tick leaves out frames and slows nothing."""


class Player(QObject):
    """Holds the playback state and reports every new t."""

    t_changed = Signal(float)
    step_changed = Signal(int)
    """Playing, or going frame by frame, has come into another step."""
    playing_changed = Signal(bool)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._playback = Playback()
        self._paces: tuple[Pace, ...] = (Pace(),)
        self._first = 0
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(TICK)
        self._timer.timeout.connect(self._tick)

    @property
    def step(self) -> int:
        """The step that is shown."""
        return self._first + self._playback.at(monotonic())[0]

    @property
    def alone(self) -> bool:
        """Whether only one step is played."""
        return len(self._playback.paces) < len(self._paces)

    def follow(self, paces: tuple[Pace, ...], step: int) -> None:
        """Play through these steps, and show this one now."""
        if paces != self._paces or step != self.step:
            self._run(paces, step, alone=self.alone)

    def set_alone(self, alone: bool) -> None:
        """Play the step that is shown alone, or all of them."""
        self._run(self._paces, self.step, alone=alone)

    def _run(self, paces: tuple[Pace, ...], step: int, *, alone: bool) -> None:
        self._paces = paces
        self._first = step if alone else 0
        played = paces[step : step + 1] if alone else paces
        self._become(self._playback.over(played, step - self._first, monotonic()))

    @property
    def t(self) -> float:
        """The moment of the step that is shown."""
        return self._playback.t(monotonic())

    @property
    def playing(self) -> bool:
        """Whether time runs."""
        return self._playback.playing

    @property
    def repeat(self) -> Repeat:
        """What happens at the end."""
        return self._playback.repeat

    @property
    def easing(self) -> Easing:
        """How t runs over the time of the step that is shown."""
        return self._paces[self.step].easing

    @property
    def duration(self) -> float:
        """Seconds that one way through all steps that are played takes, at the speed chosen."""
        lengths = sum(pace.length for pace in self._playback.paces)
        return self._playback.duration * lengths / self._playback.speed

    @property
    def speed(self) -> float:
        """How many times faster than usual."""
        return self._playback.speed

    @Slot()
    def toggle(self) -> None:
        """Play or pause."""
        if self.playing:
            self._become(self._playback.pause(monotonic()))
        else:
            self._become(self._playback.play(monotonic()))

    def play(self) -> None:
        if not self.playing:
            self.toggle()

    def pause(self) -> None:
        if self.playing:
            self.toggle()

    def seek(self, t: float) -> None:
        """Show this moment; a running clock runs on from there."""
        self._become(self._playback.seek(t, monotonic()))

    @Slot()
    def to_start(self) -> None:
        self.seek(0.0)

    @Slot()
    def to_end(self) -> None:
        self.seek(1.0)

    @Slot()
    def step_back(self) -> None:
        """Stop, and show the frame before."""
        self._become(self._playback.advance(-1, monotonic()))

    @Slot()
    def step_forward(self) -> None:
        """Stop, and show the next frame."""
        self._become(self._playback.advance(1, monotonic()))

    def stop_at(self, t: float) -> None:
        """Stop, and show this moment."""
        self.pause()
        self.seek(t)

    def set_repeat(self, repeat: Repeat) -> None:
        self._become(self._playback.repeating(repeat, monotonic()))

    def set_speed(self, speed: float) -> None:
        self._become(self._playback.at_speed(speed, monotonic()))

    def _become(self, playback: Playback) -> None:
        former, self._playback = self._playback, playback
        if playback.playing and not former.playing:
            self._timer.start()
        elif former.playing and not playback.playing:
            self._timer.stop()
        if playback.playing != former.playing:
            self.playing_changed.emit(playback.playing)
        if playback.step != former.step:
            self.step_changed.emit(self._first + playback.step)
        self.t_changed.emit(self.t)

    @Slot()
    def _tick(self) -> None:
        now = monotonic()
        if self._playback.ended(now):
            self._become(self._playback.pause(now))
        else:
            step = self._playback.at(now)[0]
            if step != self._playback.step:
                self._playback = replace(self._playback, step=step)
                self.step_changed.emit(self._first + step)
            self.t_changed.emit(self.t)
