"""What menus and keys do to what is watched: zoom, layers, and the moment that is shown."""

from collections.abc import Callable, Mapping
from dataclasses import fields

from PySide6.QtCore import QObject, Slot
from PySide6.QtWidgets import QWidget

from app.model.marks import Side
from app.session import Session
from app.view.canvas.canvas import NOTCH, Canvas
from app.view.commands.actions import Actions
from app.view.painting.display import Display, Layers
from app.view.painting.icons import icon
from app.view.timeline.player import Player
from app.view.wording.verdicts import next_crossing

LAYERS = tuple(field.name for field in fields(Layers))
"""Switches of what is shown, which have the names of their commands."""


class Watching(QObject):
    """The commands of the blend menu, and those of the view menu that are about shapes.

    Parameters
    ----------
    parent : QWidget
        The window, whose palette colours the icons.
    session, player, display
        What is watched.
    canvases : mapping of Side to Canvas
        They zoom together.
    """

    def __init__(
        self,
        parent: QWidget,
        session: Session,
        player: Player,
        display: Display,
        canvases: Mapping[Side, Canvas],
    ) -> None:
        super().__init__(parent)
        self._window = parent
        self._session = session
        self._player = player
        self._display = display
        self._canvases = canvases

    def handlers(self) -> dict[str, Callable[[], object]]:
        """Give for each command what it does."""
        player = self._player
        return {
            "fit": self._fit,
            "zoom-in": self._zoom_in,
            "zoom-out": self._zoom_out,
            **dict.fromkeys(LAYERS, self._switch_layers),
            "play": player.toggle,
            "to-start": player.to_start,
            "to-end": player.to_end,
            "step-back": player.step_back,
            "step-forward": player.step_forward,
            "next-crossing": self._show_next_crossing,
            "recompute": self._session.blends.recompute,
        }

    def begin(self, actions: Actions) -> None:
        """Let the commands tell from now on what is shown."""
        self._actions = actions
        for name in LAYERS:
            actions[name].setChecked(getattr(self._display.layers, name))
        self._session.blends.changed.connect(self._follow_results)
        self._player.playing_changed.connect(self.dress)
        for canvas in self._canvases.values():
            canvas.tapped.connect(actions["play"].trigger)
        self._follow_results()
        self.dress()

    @Slot()
    def dress(self) -> None:
        """Say on the command that plays what it does next, with an icon in the colours of the window."""
        playing = self._player.playing
        action = self._actions["play"]
        action.setText(self.tr("&Pause") if playing else self.tr("&Play"))
        action.setIcon(icon("pause" if playing else "play", self._window.palette()))

    @Slot()
    def _follow_results(self) -> None:
        document = self._session.document
        step = document.sequence.drawn_step(document.step)
        self._actions["export"].setEnabled(bool(self._session.blends.fresh_of(step)))

    @Slot()
    def _fit(self) -> None:
        for canvas in self._canvases.values():
            canvas.fit()
        self._display.fit()

    @Slot()
    def _zoom_in(self) -> None:
        self._zoom(NOTCH)

    @Slot()
    def _zoom_out(self) -> None:
        self._zoom(1 / NOTCH)

    def _zoom(self, factor: float) -> None:
        for canvas in self._canvases.values():
            canvas.zoom(factor)

    @Slot()
    def _switch_layers(self) -> None:
        self._display.show(Layers(**{name: self._actions[name].isChecked() for name in LAYERS}))

    @Slot()
    def _show_next_crossing(self) -> None:
        reports = [result.report for result in self._session.blends.fresh]
        if (t := next_crossing(reports, self._player.t)) is not None:
            self._player.stop_at(t)
