"""The methods side by side, all in one view so that sizes compare."""

import numpy as np
from PySide6.QtCore import QSize, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QWidget

from app.session import Session
from app.view.painting.display import Display
from app.view.panels.panel import Panel
from app.view.timeline.player import Player
from starskel.arrays import Floats

HEADING = 43
"""Height of what stands over a panel's frame, in pixels."""

NARROWEST = 140
"""Width that a short verdict needs; panels are narrower only where one row of two would be."""


def columns_for(count: int, width: float, height: float, extent: Floats) -> int:
    """Give how many panels stand side by side so that what has this extent is shown largest."""
    box = np.ptp(extent, axis=0) if len(extent) else np.ones(2)

    def scale(columns: int) -> float:
        room = np.array([width / columns, height / -(-count // columns) - HEADING])
        return float((room / np.maximum(box, np.finfo(float).tiny)).min())

    return max(range(min(count, _most_columns(width)), 0, -1), key=scale, default=1)


def _most_columns(width: float) -> int:
    return max(2, int(width // NARROWEST))


class Panels(QWidget):
    """A panel for every method that the document compares."""

    def __init__(self, session: Session, player: Player, display: Display) -> None:
        super().__init__()
        self._session = session
        self._player = player
        self._display = display
        self._panels: dict[str, Panel] = {}
        self._columns = 0
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(10, 4, 10, 0)
        self._grid.setSpacing(10)
        session.document_changed.connect(self._arrange)
        session.blends.changed.connect(self.follow)
        session.blends.busy_changed.connect(self.follow)
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
            panel.hide()  # it does not follow any more, and must not be painted until it is gone
            panel.deleteLater()
        self._panels = {m: Panel(m, self._session, self._player, self._display) for m in methods}
        self._columns = 0
        self.follow()

    def minimumSizeHint(self) -> QSize:
        """Ask for the height of as few rows as there may be, not for that of those there are.

        Before it is shown, when it has no width yet, that is one.
        """
        panels, margins = self._panels.values(), self._grid.contentsMargins()
        rows = -(-len(panels) // _most_columns(self.width())) if self.isVisible() else 1
        height = rows * max((panel.minimumSizeHint().height() for panel in panels), default=0)
        between = (rows - 1) * self._grid.verticalSpacing() + margins.top() + margins.bottom()
        return QSize(super().minimumSizeHint().width(), height + between)

    def resizeEvent(self, event: QResizeEvent) -> None:
        if event.oldSize().width() != event.size().width():
            self.updateGeometry()
        self._lay_out(self._extent())

    def _lay_out(self, extent: Floats) -> None:
        columns = columns_for(len(self._panels), self.width(), self.height(), extent)
        if columns == self._columns:
            return
        self._columns = columns
        for number, panel in enumerate(self._panels.values()):
            self._grid.addWidget(panel, *divmod(number, columns))
        for column in range(self._grid.columnCount()):
            self._grid.setColumnStretch(column, 1 if column < columns else 0)

    @Slot()
    def follow(self) -> None:
        """Show what the session has."""
        extent = self._extent()
        self._lay_out(extent)
        for panel in self._panels.values():
            panel.follow(extent)

    def _extent(self) -> Floats:
        """Give the corners of the boxes of all blends."""
        shown = self._session.blends.results.values()
        boxes = [state.result.box for state in shown if state.result is not None]
        return np.concatenate([np.empty((0, 2)), *boxes])
