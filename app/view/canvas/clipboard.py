"""Shapes on the clipboard: with all their digits for this program, as SVG for others."""

import msgspec
import numpy as np
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from app.model.svg_outline import outline_svg, outlines_of
from starskel.errors import InvalidFile, told
from starskel.predicates import Floats

OWN = "application/x-starskel-shape"
SVG = ("image/svg+xml", "image/x-inkscape-svg", "image/svg")


def copy_ring(ring: Floats) -> None:
    """Put a ring on the clipboard."""
    svg = outline_svg(ring)
    data = QMimeData()
    data.setData(OWN, msgspec.json.encode(ring.tolist()))
    data.setData(SVG[0], svg.encode())
    data.setText(svg)
    QGuiApplication.clipboard().setMimeData(data)


def leave_clipboard() -> None:
    """Leave what was copied as text; to be called before the program ends.

    What else is on the clipboard is data of Python, which Qt would ask for when Python has ended.
    """
    clipboard = QGuiApplication.clipboard()
    data = clipboard.mimeData()
    if data is not None and data.hasFormat(OWN):
        clipboard.setText(data.text())


def copied_ring() -> Floats:
    """Give the outline on the clipboard, of several the largest.

    Raises
    ------
    InvalidFile
        If there is none, or what is there is damaged.
    """
    data = QGuiApplication.clipboard().mimeData() or QMimeData()  # some systems have none at first
    if data.hasFormat(OWN):
        rows = msgspec.json.decode(bytes(data.data(OWN).data()), type=list[tuple[float, float]])
        return np.array(rows)
    found = outlines_of(_svg(data))
    if not found:
        raise InvalidFile(
            told("there is no outline on the clipboard"),
            told("copy a shape here, or a path in another program"),
        )
    return found[0]


def _svg(data: QMimeData) -> str:
    """Give the SVG on the clipboard, an empty drawing where there is none."""
    for kind in SVG:
        if data.hasFormat(kind):
            return bytes(data.data(kind).data()).decode(errors="replace")
    text = data.text().strip()
    return text if text.startswith("<") and "<svg" in text else "<svg/>"
