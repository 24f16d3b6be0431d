"""Shapes on the clipboard: with all their digits for this program, as SVG for others."""

import msgspec
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from app.model.clipping import Clipping
from app.model.svg_outline import outline_svg
from starskel.errors import InvalidFile, StarskelError, told
from starskel.shapes.shape import Shape

OWN = "application/x-starskel-shape"
SVG = ("image/svg+xml", "image/x-inkscape-svg", "image/svg")


class _Clipping(msgspec.Struct, frozen=True):
    """A clipping, each part as its outline and its holes."""

    parts: list[list[list[tuple[float, float]]]]
    whole: bool


def copy_shape(clipping: Clipping) -> None:
    """Put a shape on the clipboard."""
    shape, svg = clipping.shape, outline_svg(clipping.shape)
    rings = [ring.vertices.tolist() for ring in shape.rings]
    parts = [[rings[outline], *(rings[k] for k in shape.holes(outline))] for outline in shape.outlines]
    data = QMimeData()
    data.setData(OWN, msgspec.json.encode(_Clipping(parts, clipping.whole)))
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


def copied_shape() -> Clipping | None:
    """Give the shape that this program put on the clipboard, None where there is none that can be read."""
    data = _data()
    if not data.hasFormat(OWN):
        return None
    try:
        found = msgspec.json.decode(bytes(data.data(OWN).data()), type=_Clipping)
        return Clipping(Shape.of_parts([(outline, holes) for outline, *holes in found.parts]), found.whole)
    except (msgspec.MsgspecError, StarskelError, ValueError):
        return None  # of another version, perhaps: there is SVG besides


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
