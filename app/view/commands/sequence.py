"""The part of the table of commands that is about the sequence of key shapes."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands.command import Command

SEQUENCE = (
    Command(
        "shape-add",
        QT_TRANSLATE_NOOP("Command", "&Add Key Shape"),
        QT_TRANSLATE_NOOP("Command", "Put an empty shape behind the target, for the blend to go on to"),
        ("Ctrl+Shift+N",),
    ),
    Command(
        "shape-duplicate",
        QT_TRANSLATE_NOOP("Command", "D&uplicate Key Shape"),
        QT_TRANSLATE_NOOP("Command", "Put a copy behind the shape last worked on"),
        ("Ctrl+Shift+D",),
    ),
    Command(
        "shape-delete",
        QT_TRANSLATE_NOOP("Command", "&Delete Key Shape"),
        QT_TRANSLATE_NOOP("Command", "Take the shape last worked on out of the sequence"),
        ("Ctrl+Shift+Backspace",),
    ),
    Command(
        "shape-earlier",
        QT_TRANSLATE_NOOP("Command", "Move &Earlier"),
        QT_TRANSLATE_NOOP("Command", "Let the shape last worked on change places with the one before it"),
        ("Ctrl+Shift+PgUp",),
    ),
    Command(
        "shape-later",
        QT_TRANSLATE_NOOP("Command", "Move &Later"),
        QT_TRANSLATE_NOOP("Command", "Let the shape last worked on change places with the one behind it"),
        ("Ctrl+Shift+PgDown",),
    ),
    Command(
        "step-before",
        QT_TRANSLATE_NOOP("Command", "&Previous Step"),
        QT_TRANSLATE_NOOP("Command", "Put the pair of shapes before on the canvases"),
        ("PgUp",),
    ),
    Command(
        "step-after",
        QT_TRANSLATE_NOOP("Command", "&Next Step"),
        QT_TRANSLATE_NOOP("Command", "Put the next pair of shapes on the canvases"),
        ("PgDown",),
    ),
    Command(
        "alone",
        QT_TRANSLATE_NOOP("Command", "Play &Only This Step"),
        QT_TRANSLATE_NOOP("Command", "Play only between the two shapes on the canvases, not all shapes"),
        ("Ctrl+P",),
        "",
        True,
    ),
)
