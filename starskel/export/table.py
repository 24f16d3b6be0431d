"""Frames out as a table, for spreadsheets and statistics: CSV, a line for each vertex of each frame.

Coordinates are in the user's units, to the last bit. Holes name the ring that they are a hole of, others -1.
"""

import csv
import io
from collections.abc import Iterator

from starskel.export.film import Film
from starskel.task import Task

HEAD = ("method", "step", "time", "t", "ring", "outer", "vertex", "x", "y")


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give the frames of all methods as one table."""
    text = io.StringIO()
    table = csv.writer(text)
    table.writerow(HEAD)
    for row in _rows(film, task):
        table.writerow(row)
    yield text.getvalue().encode()


def _rows(film: Film, task: Task) -> Iterator[tuple[object, ...]]:
    for track in film.tracks:
        for time in film.settings.times:
            task.reach(0)
            step, t = track.at(time, film.settings.eased)
            blend = track.scenes[step].blend
            for number, (ring, outer) in enumerate(zip(blend.rings([t]), blend.pair.outer, strict=True)):
                for vertex, (x, y) in enumerate(ring[0].tolist()):
                    yield track.name, step + 1, time, t, number, outer, vertex, x, y
