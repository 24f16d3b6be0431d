"""The part of the table of commands about files."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands.command import Command

FILES = (
    Command(
        "new",
        QT_TRANSLATE_NOOP("Command", "&New"),
        QT_TRANSLATE_NOOP("Command", "Start with two empty canvases"),
        ("Ctrl+N",),
    ),
    Command(
        "open",
        QT_TRANSLATE_NOOP("Command", "&Open…"),
        QT_TRANSLATE_NOOP("Command", "Open a project, a file of polygon pairs, or shapes of a drawing"),
        ("Ctrl+O",),
    ),
    Command(
        "import",
        QT_TRANSLATE_NOOP("Command", "&Import Shapes…"),
        QT_TRANSLATE_NOOP("Command", "Take shapes of an SVG, a map, a picture or a font onto the canvases"),
        ("Ctrl+I",),
    ),
    Command(
        "save",
        QT_TRANSLATE_NOOP("Command", "&Save"),
        QT_TRANSLATE_NOOP("Command", "Save the project"),
        ("Ctrl+S",),
    ),
    Command(
        "save-as",
        QT_TRANSLATE_NOOP("Command", "Save &As…"),
        QT_TRANSLATE_NOOP("Command", "Save the project under another name"),
        ("Ctrl+Shift+S",),
    ),
    Command(
        "recover",
        QT_TRANSLATE_NOOP("Command", "Reco&vered Documents…"),
        QT_TRANSLATE_NOOP("Command", "Open unsaved work that a crash has left behind"),
    ),
    Command(
        "export",
        QT_TRANSLATE_NOOP("Command", "&Export…"),
        QT_TRANSLATE_NOOP("Command", "Export keyframes, an animation or numbers"),
        ("Ctrl+E",),
    ),
    Command(
        "quit",
        QT_TRANSLATE_NOOP("Command", "&Quit"),
        QT_TRANSLATE_NOOP("Command", "Close the window"),
        ("Ctrl+Q",),
    ),
)
