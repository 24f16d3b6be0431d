"""Take the pictures of the editor anew that the README and the manual show.

    python .ci/pictures.py [FOLDER]

They go into FOLDER, by default resources, as they lie there. Drawn without a screen, in the colours of
the light theme.
"""

import os
import sys
from collections.abc import Callable
from io import BytesIO
from pathlib import Path

os.environ["QT_QPA_PLATFORM"] = "offscreen"  # before Qt is loaded

from PIL import Image
from PySide6.QtCore import QBuffer, QCoreApplication, QEvent, QEventLoop
from PySide6.QtWidgets import QApplication, QWidget

from app.model.marks import Side
from app.session import Session
from app.tools.tool import Pointer
from app.view.files.export.dialog import ExportDialog
from app.view.files.export.exporting import exported_steps
from app.view.main_window import MainWindow
from app.view.painting.display import Layers
from app.view.painting.theme import LIGHT, apply_theme

ROOT = Path(__file__).parents[1]
SIZE = (1400, 880)
COLOURS = 256
"""A picture of the window has few; so its file is half as large."""


def editor(window: MainWindow) -> None:
    """Show an arm that bends, with its star pieces and skeletons."""
    show(window, "arm", 0.45, Layers(pieces=True, skeleton=True))


def editor_marks(window: MainWindow) -> None:
    """Show a mark on a hand that would cross another one."""
    show(window, "hand", 0.5, Layers())
    window.session.choose_tool("mark")
    ends: tuple[tuple[Side, int], ...] = (("source", 35), ("target", 15))
    for side, vertex in ends:
        x, y = window.session.document.vertices(side)[vertex].tolist()
        window.session.move(Pointer(side, (x, y), 1.0))
        window.session.press(Pointer(side, (x, y), 1.0))
        window.session.release(Pointer(side, (x, y), 1.0))


def editor_pictures(window: MainWindow) -> None:
    """Show a dog's face that becomes a cat's."""
    show(window, "figure-10-dog", 0.45, Layers(pictures=True))


def export(window: MainWindow) -> QWidget:
    """Show the dialog that exports an arm."""
    show(window, "arm", 0.45, Layers())
    dialog = ExportDialog(exported_steps(window.session)[0], window.player, window.display, window)
    dialog.resize(dialog.sizeHint())
    return dialog


PICTURES: dict[str, Callable[[MainWindow], QWidget | None]] = {
    "pictures/editor.png": editor,
    "pictures/editor-marks.png": editor_marks,
    "pictures/editor-pictures.png": editor_pictures,
    "manual/pictures/export.png": export,
}
"""What shows each: the window, or what is given."""


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


def main(folder: Path) -> None:
    application = QApplication([])
    apply_theme(application, LIGHT)
    window = MainWindow(Session())
    window.beginning.hide()
    window.resize(*SIZE)
    window.show()
    for name, prepare in PICTURES.items():
        shown = prepare(window) or window
        settle(window)
        store(shown, folder / name)
    window.session.new()
    window.close()


def store(widget: QWidget, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.ReadWrite)
    widget.grab().save(buffer, "PNG")
    with Image.open(BytesIO(buffer.data().data())) as picture:
        few = picture.convert("RGB").quantize(COLOURS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
        few.save(path, optimize=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "resources")
