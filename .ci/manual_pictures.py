"""Take the pictures of the manual anew: of the editor, and of what it writes.

    python .ci/manual_pictures.py [FOLDER]

They go into FOLDER, by default resources/manual/pictures.
"""

import os
import sys
from io import BytesIO
from pathlib import Path

os.environ["QT_QPA_PLATFORM"] = "offscreen"  # before Qt is loaded

from PIL import Image
from PySide6.QtCore import QBuffer, QCoreApplication, QEvent, QEventLoop
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
WIDTH = 680
"""Pixels that fit into the manual's window."""

COLOURS = 128

LEAVES = b"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">
<path id="leaf" d="M50 95 C0 60 20 20 50 5 C80 20 100 60 50 95 Z"/>
<path id="star" d="M50 5 L61 39 H97 L68 60 79 95 50 73 21 95 32 60 3 39 H39 Z"/>
<path id="drop" d="M50 5 C60 40 85 50 85 68 A35 30 0 0 1 15 68 C15 50 40 40 50 5 Z"/>
<path id="bow" d="M5 20 L95 80 V20 L5 80 Z"/></svg>"""

RENDERED = {
    "row.png": "render figure-2-snake.json --frames 7 --pixels 680 --paper #ffffff",
    "sheet.png": "render star.json --layout sheet --frames 5 --pixels 680 --method vertex"
    " --method edge-angle --method stitched",
    "pieces.png": "render arm.json --frames 5 --pieces --skeleton --marks --method star-skeleton"
    " --pixels 680 --paper #ffffff",
    "carried.png": "render figure-10-dog.json --frames 5 --plain --pixels 680 --paper #ffffff",
    "letters.png": "render letters-a-r.json --frames 6 --plain --pixels 680 --paper #ffffff",
}


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, words in RENDERED.items():
        verb, example, *options = words.split()
        starskel([verb, str(EXAMPLES / example), *options, "-o", str(folder / name)])
        with Image.open(folder / name) as picture:
            store(picture.convert("RGB"), folder / name)
    application = QApplication([])
    apply_theme(application, LIGHT)
    window = MainWindow(Session())
    window.beginning.hide()
    window.resize(1160, 760)
    window.show()
    take_editor(window, folder)
    window.session.new()
    window.close()


def take_editor(window: MainWindow, folder: Path) -> None:
    open_example(window, "arm", 0.45)
    store(grabbed(window), folder / "editor.png")
    export = ExportDialog(exported_steps(window.session)[0], window.player, window.display, window)
    take_dialog(export, folder / "export.png")
    drawing = Path("drawing.svg")
    chooser = ShapeChooser(drawing, read_content(LEAVES, drawing), SIDES, window, optional=False)
    take_dialog(chooser, folder / "chooser.png")
    open_example(window, "hand", 0.5)
    window.session.choose_tool("mark")
    for side, vertex in zip(SIDES, (35, 15), strict=True):
        x, y = window.session.document.vertices(side)[vertex].tolist()
        for act in (window.session.move, window.session.press, window.session.release):
            act(Pointer(side, (x, y), 1.0))
    settle(window)
    canvas = window.canvases["source"]
    top = canvas.mapTo(window, canvas.rect().topLeft())
    box = (top.x(), top.y(), window.width(), top.y() + canvas.height())
    store(grabbed(window).crop(box), folder / "marks.png")


def open_example(window: MainWindow, example: str, t: float) -> None:
    window.files.open_example(example)
    window.display.show(Layers())
    window.player.stop_at(t)
    settle(window)


def settle(window: MainWindow) -> None:
    """Let the window do what there is to do."""
    while window.session.blends.busy or window.session.morphs.busy:
        QCoreApplication.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents)
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    QCoreApplication.processEvents()


def take_dialog(dialog: QWidget, path: Path) -> None:
    dialog.show()
    QCoreApplication.processEvents()
    store(grabbed(dialog), path)
    dialog.close()
    dialog.deleteLater()


def grabbed(widget: QWidget) -> Image.Image:
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.ReadWrite)
    widget.grab().save(buffer, "PNG")
    return Image.open(BytesIO(buffer.data().data())).convert("RGB")


def store(picture: Image.Image, path: Path) -> None:
    if picture.width > WIDTH:
        size = WIDTH, round(picture.height * WIDTH / picture.width)
        picture = picture.resize(size, Image.Resampling.LANCZOS)
    few = picture.quantize(COLOURS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    few.save(path, optimize=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "resources" / "manual" / "pictures")
