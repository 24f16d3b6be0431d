"""The part of the table of commands about which vertices correspond."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands.command import Command

MARKS = (
    Command(
        "mark",
        QT_TRANSLATE_NOOP("Command", "&Mark"),
        QT_TRANSLATE_NOOP("Command", "Mark vertices that correspond"),
        ("M",),
        "tool",
        True,
    ),
    Command(
        "suggest",
        QT_TRANSLATE_NOOP("Command", "S&uggest Marks"),
        QT_TRANSLATE_NOOP("Command", "Replace all marks by ones that suggest themselves"),
        ("Ctrl+M",),
    ),
    Command(
        "marks",
        QT_TRANSLATE_NOOP("Command", "Marks Ta&ble"),
        QT_TRANSLATE_NOOP("Command", "Show the marks as a table, to be edited by the keyboard"),
        ("Ctrl+T",),
        "",
        True,
    ),
)
