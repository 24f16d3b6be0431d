"""Take the pictures of the README and of the manual anew: of the editor, and of what the command writes.

    python .ci/pictures.py [FOLDER]

They go into FOLDER, by default resources, as they lie there. Drawn without a screen, in the colours of
the light theme.
"""

import os
import sys
from collections.abc import Callable
from functools import partial
from io import BytesIO
from pathlib import Path

os.environ["QT_QPA_PLATFORM"] = "offscreen"  # before Qt is loaded

from PIL import Image
from PySide6.QtCore import QBuffer, QCoreApplication, QEvent, QEventLoop, QSize
from PySide6.QtWidgets import QApplication, QWidget

from app.model.marks import SIDES
from app.session import Session
from app.tools.tool import Pointer
from app.view.files.export.dialog import ExportDialog
from app.view.files.export.exporting import exported_steps
from app.view.files.shape_chooser import ShapeChooser
from app.view.main_window import MainWindow
from app.view.painting.display import Layers
from app.view.painting.theme import LIGHT, apply_theme
from starskel.cli import main as starskel
from starskel.reading.readers import read_content

ROOT = Path(__file__).parents[1]
EXAMPLES = ROOT / "resources" / "examples"

LARGE, SMALL = QSize(1400, 880), QSize(1160, 760)
"""The window for the README, and for the manual."""

WIDTH = 680
"""Pixels that fit into the manual's window."""

COLOURS = 256
"""A picture of the window has few; so its file is half as large."""

MANUAL = "manual/pictures/"

RENDERED = {
    "pictures/compare.svg": "render figure.json --layout sheet --frames 7",
    "pictures/figure-2.svg": "render figure-2-snake.json --layout sheet --frames 5",
    "pictures/figure-6.svg": "render figure-6-eel.json --layout sheet --frames 5",
    "pictures/figure-11.svg": "render figure-11-coil.json --layout sheet --frames 5",
    MANUAL + "row.png": "render figure-2-snake.json --frames 7 --pixels 680 --paper #ffffff",
    MANUAL + "sheet.png": "render star.json --layout sheet --frames 5 --pixels 680 --method vertex"
    " --method edge-angle --method stitched",
    MANUAL + "pieces.png": "render arm.json --frames 5 --pieces --skeleton --marks --method star-skeleton"
    " --pixels 680 --paper #ffffff",
    MANUAL + "carried.png": "render figure-10-dog.json --frames 5 --plain --pixels 680 --paper #ffffff",
    MANUAL + "letters.png": "render letters-a-r.json --frames 6 --plain --pixels 680 --paper #ffffff",
}
"""What the command writes."""

LEAVES = b"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
<path id="leaf" d="M50 95 C0 60 20 20 50 5 C80 20 100 60 50 95 Z"/>
<path id="star" d="M50 5 L61 39 H97 L68 60 79 95 50 73 21 95 32 60 3 39 H39 Z"/>
<path id="drop" d="M50 5 C60 40 85 50 85 68 A35 30 0 0 1 15 68 C15 50 40 40 50 5 Z"/>
<path id="bow" d="M5 20 L95 80 V20 L5 80 Z"/></svg>"""


def arm(window: MainWindow, layers: Layers) -> Image.Image:
    """Show an arm that bends."""
    show(window, "arm", 0.45, layers)
    return grabbed(window)


def marks(window: MainWindow) -> Image.Image:
    """Show a mark on a hand that would cross another one."""
    show(window, "hand", 0.5, Layers())
    window.session.choose_tool("mark")
    for side, vertex in zip(SIDES, (35, 15), strict=True):
        x, y = window.session.document.vertices(side)[vertex].tolist()
        for act in (window.session.move, window.session.press, window.session.release):
            act(Pointer(side, (x, y), 1.0))
    settle(window)
    return grabbed(window)


def marks_alone(window: MainWindow) -> Image.Image:
    """Show the canvases with that mark."""
    picture, canvas = marks(window), window.canvases["source"]
    top = canvas.mapTo(window, canvas.rect().topLeft()).y()
    return picture.crop((0, top, window.width(), top + canvas.height()))


def carried(window: MainWindow) -> Image.Image:
    """Show a dog's face that becomes a cat's."""
    show(window, "figure-10-dog", 0.45, Layers(pictures=True))
    return grabbed(window)


def export(window: MainWindow) -> Image.Image:
    """Show the dialog that exports an arm."""
    show(window, "arm", 0.45, Layers())
    dialog = ExportDialog(exported_steps(window.session)[0], window.player, window.display, window)
    return grabbed(dialog, shown=True)


def chooser(window: MainWindow) -> Image.Image:
    """Show the dialog that chooses shapes of a drawing."""
    drawing = Path("drawing.svg")
    dialog = ShapeChooser(drawing, read_content(LEAVES, drawing), SIDES, window, optional=False)
    return grabbed(dialog, shown=True)


TAKEN: dict[str, tuple[QSize, Callable[[MainWindow], Image.Image]]] = {
    "pictures/editor.png": (LARGE, partial(arm, layers=Layers(pieces=True, skeleton=True))),
    "pictures/editor-marks.png": (LARGE, marks),
    "pictures/editor-pictures.png": (LARGE, carried),
    MANUAL + "editor.png": (SMALL, partial(arm, layers=Layers())),
    MANUAL + "export.png": (SMALL, export),
    MANUAL + "chooser.png": (SMALL, chooser),
    MANUAL + "marks.png": (SMALL, marks_alone),
}
"""The size of the window, and what is taken of it."""


def main(folder: Path) -> None:
    for name in (*RENDERED, *TAKEN):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
    for name, words in RENDERED.items():
        verb, example, *options = words.split()
        starskel([verb, str(EXAMPLES / example), *options, "-o", str(folder / name)])
        if name.endswith(".png"):
            with Image.open(folder / name) as drawn:
                store(drawn.convert("RGB"), folder / name)
    application = QApplication([])
    apply_theme(application, LIGHT)
    window = MainWindow(Session())
    window.beginning.hide()
    window.show()
    for name, (size, take) in TAKEN.items():
        window.resize(size)
        picture = take(window)
        if name.startswith(MANUAL) and picture.width > WIDTH:
            height = round(picture.height * WIDTH / picture.width)
            picture = picture.resize((WIDTH, height), Image.Resampling.LANCZOS)
        store(picture, folder / name)
    window.session.new()
    window.close()


def show(window: MainWindow, example: str, t: float, layers: Layers) -> None:
    """Open an example, and wait until all is computed."""
    window.session.new()
    window.files.open_example(example)
    window.display.show(layers)
    window.player.stop_at(t)
    settle(window)


def settle(window: MainWindow) -> None:
    """Let the window do what there is to do."""
    while window.session.blends.busy or window.session.morphs.busy:
        QCoreApplication.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents)
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)  # panels of the example before
    QCoreApplication.processEvents()


def grabbed(widget: QWidget, *, shown: bool = False) -> Image.Image:
    """Give a picture of the window, or of a dialog, shown for it alone."""
    if shown:
        widget.show()
        QCoreApplication.processEvents()
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.ReadWrite)
    widget.grab().save(buffer, "PNG")
    if shown:
        widget.close()
        widget.deleteLater()
    return Image.open(BytesIO(buffer.data().data())).convert("RGB")


def store(picture: Image.Image, path: Path) -> None:
    few = picture.quantize(COLOURS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    few.save(path, optimize=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "resources")
