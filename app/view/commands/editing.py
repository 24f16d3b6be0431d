"""The part of the table of commands that takes edits back and chooses what they are about."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands.command import Command

EDITING = (
    Command(
        "undo",
        QT_TRANSLATE_NOOP("Command", "&Undo"),
        QT_TRANSLATE_NOOP("Command", "Take back the last edit"),
        ("Ctrl+Z",),
    ),
    Command(
        "redo",
        QT_TRANSLATE_NOOP("Command", "&Redo"),
        QT_TRANSLATE_NOOP("Command", "Bring back what was undone"),
        ("Ctrl+Shift+Z", "Ctrl+Y"),
    ),
    Command(
        "select-all",
        QT_TRANSLATE_NOOP("Command", "Select &All"),
        QT_TRANSLATE_NOOP("Command", "Select the part last worked on; once more, all parts of its shape"),
        ("Ctrl+A",),
    ),
    Command(
        "delete",
        QT_TRANSLATE_NOOP("Command", "&Delete"),
        QT_TRANSLATE_NOOP("Command", "Delete the selected vertices"),
        ("Del",),
    ),
    Command(
        "cancel",
        QT_TRANSLATE_NOOP("Command", "Ca&ncel"),
        QT_TRANSLATE_NOOP("Command", "Give up the gesture or the computation under way"),
        ("Esc",),
    ),
)
