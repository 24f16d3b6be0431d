"""A program that edits and saves without end, to be killed: victim.py FILE SEED.

It says each edit after it was done and each save after it has succeeded, as "time kind number".
"""

import sys
import time
from pathlib import Path
from random import Random

from PySide6.QtCore import QCoreApplication, QTimer

from app.model.filing import stored
from app.recovery.keeper import Keeper
from app.session import Session
from starskel import Polygon

CORNERS = 400
"""Of what is drawn, so that a file takes a while to write."""


class Victim:
    """Draws shape after shape; the first vertex of each tells its number."""

    def __init__(self, path: Path, seed: int) -> None:
        self._path = path
        self._random = Random(seed)
        self._share = self._random.choice([0.0, 0.05, 0.8])  # of edits after which it saves
        self._session = Session()
        self._keeper = Keeper(self._session)
        self._number = 0

    def act(self) -> None:
        """Edit once, save at times, and go on in a moment."""
        self._number += 1
        document = self._session.document.draw("source", drawn(self._number))
        self._session.store(document, "Draw")
        self._say("edit")
        if self._random.random() < self._share:
            document = self._session.document
            self._session.note_saved(document, stored(document, self._path))
            self._say("save")
        QTimer.singleShot(self._random.choice([0, 10, 50, 200]), self.act)

    def _say(self, kind: str) -> None:
        print(time.monotonic(), kind, self._number, flush=True)


def drawn(number: int) -> Polygon:
    """Give a comb whose first vertex tells its number."""
    teeth = [(k, 1 + k % 2) for k in range(CORNERS, 0, -1)]
    return Polygon([(-number, 0), (CORNERS + 1, 0), *teeth])


def number_of(shape: Polygon) -> int:
    """Give the number of what was drawn."""
    return round(-float(shape.vertices[:, 0].min()))


if __name__ == "__main__":
    application = QCoreApplication([])
    victim = Victim(Path(sys.argv[1]), int(sys.argv[2]))
    victim.act()
    application.exec()
