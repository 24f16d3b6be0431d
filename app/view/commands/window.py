"""The part of the table of commands that is about the window and the program."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands.command import Command

WINDOW = (
    Command(
        "history",
        QT_TRANSLATE_NOOP("Command", "Histor&y"),
        QT_TRANSLATE_NOOP("Command", "Show the list of edits, to go back to any of them"),
        ("Ctrl+H",),
        "",
        True,
    ),
)

HELP = (
    Command(
        "begin",
        QT_TRANSLATE_NOOP("Command", "How to &Begin"),
        QT_TRANSLATE_NOOP("Command", "Show in five lines how to begin"),
        (),
        "",
        True,
    ),
    Command(
        "manual",
        QT_TRANSLATE_NOOP("Command", "&Manual"),
        QT_TRANSLATE_NOOP("Command", "Read how it is done: blends, marks, exports, scripts"),
        ("F1",),
    ),
    Command(
        "find-command",
        QT_TRANSLATE_NOOP("Command", "&Find Command…"),
        QT_TRANSLATE_NOOP("Command", "Find a command by a part of its name"),
        ("Ctrl+K", "Ctrl+Shift+P"),
    ),
    Command(
        "shortcuts",
        QT_TRANSLATE_NOOP("Command", "&Keyboard Shortcuts…"),
        QT_TRANSLATE_NOOP("Command", "See and change the keys of all commands"),
    ),
    Command(
        "about",
        QT_TRANSLATE_NOOP("Command", "&About starskel…"),
        QT_TRANSLATE_NOOP("Command", "What the program is, and its versions"),
    ),
)
