"""Shapes on the clipboard: with all their digits for this program, as SVG for others."""

import msgspec
import numpy as np
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from app.model.svg_outline import outline_svg
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


def copied_ring() -> Floats | None:
    """Give the ring that this program put on the clipboard, None where there is none."""
    data = _data()
    if not data.hasFormat(OWN):
        return None
    return np.array(msgspec.json.decode(bytes(data.data(OWN).data()), type=list[tuple[float, float]]))


def copied_svg() -> bytes:
    """Give the SVG that is on the clipboard.

    Raises
    ------
    InvalidFile
        If there is none.
    """
    data = _data()
    for kind in SVG:
        if data.hasFormat(kind):
            return bytes(data.data(kind).data())
    text = data.text().strip()
    if text.startswith("<") and "<svg" in text:
        return text.encode()
    raise InvalidFile(
        told("there is no outline on the clipboard"),
        told("copy a shape here, or a path in another program"),
    )


def _data() -> QMimeData:
    return QGuiApplication.clipboard().mimeData() or QMimeData()  # some systems have none at first
