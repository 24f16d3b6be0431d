"""The methods side by side, all in one view so that sizes compare."""

import numpy as np
from PySide6.QtCore import Slot
from PySide6.QtWidgets import QGridLayout, QWidget

from app.session import Session
from app.view.display import Display
from app.view.panel import Panel
from app.view.player import Player
from starskel.predicates import Floats

LONGEST_ROW = 4


class Panels(QWidget):
    """A panel for every method that the document compares."""

    def __init__(self, session: Session, player: Player, display: Display) -> None:
        super().__init__()
        self._session = session
        self._player = player
        self._display = display
        self._panels: dict[str, Panel] = {}
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(10, 4, 10, 0)
        self._grid.setSpacing(10)
        session.document_changed.connect(self._arrange)
        session.results_changed.connect(self.follow)
        session.busy_changed.connect(self.follow)
        self._arrange()

    def panel(self, method: str) -> Panel:
        """Give the panel of a method."""
        return self._panels[method]

    @Slot()
    def _arrange(self) -> None:
        methods = self._session.document.methods
        if tuple(self._panels) == methods:
            return
        for panel in self._panels.values():
            self._grid.removeWidget(panel)
            panel.deleteLater()
        self._panels = {m: Panel(m, self._session, self._player, self._display) for m in methods}
        columns = len(methods) if len(methods) <= LONGEST_ROW else -(-len(methods) // 2)
        for number, panel in enumerate(self._panels.values()):
            self._grid.addWidget(panel, *divmod(number, columns))
        for column in range(self._grid.columnCount()):
            self._grid.setColumnStretch(column, 1 if column < columns else 0)
        self.follow()

    @Slot()
    def follow(self) -> None:
        """Show what the session has."""
        extent = self._extent()
        for panel in self._panels.values():
            panel.follow(extent)

    def _extent(self) -> Floats:
        """Give the corners of the boxes of all blends."""
        shown = self._session.results.values()
        boxes = [state.result.box for state in shown if state.result is not None]
        return np.concatenate([np.empty((0, 2)), *boxes])
