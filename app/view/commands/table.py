"""The one table of all commands; menus, toolbar and shortcuts are made from it."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands import drawing, editing, files, marks, parts, playing, sequence, viewing, window
from app.view.commands.command import Command

COMMANDS = (
    *files.FILES,
    *editing.EDITING,
    *drawing.TOOLS,
    *drawing.SNAPPING,
    *drawing.CLIPBOARD,
    *drawing.SHAPE,
    *drawing.PICTURE,
    *marks.MARKS,
    *parts.PARTS,
    *sequence.SEQUENCE,
    *playing.PLAYING,
    *viewing.VIEWING,
    *window.WINDOW,
    *window.HELP,
)


def _names(commands: tuple[Command, ...]) -> tuple[str, ...]:
    return tuple(command.name for command in commands)


PALETTE = (*_names(drawing.TOOLS), "mark")
"""The tools, in the order of the bar at the left."""

LANGUAGES = ("language-system", "language-en", "language-de")

MENUS = (
    (
        QT_TRANSLATE_NOOP("Command", "&File"),
        (
            "new",
            "open",
            "recent",
            "examples",
            "import",
            "",
            "save",
            "save-as",
            "recover",
            "",
            "export",
            "",
            "quit",
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Command", "&Edit"),
        (
            "undo",
            "redo",
            "",
            *_names(drawing.CLIPBOARD),
            "",
            "select-all",
            "delete",
            "",
            "history",
            "",
            "cancel",
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Command", "&Shape"),
        (*_names(drawing.SHAPE), "", *_names(drawing.PICTURE)),
    ),
    (
        QT_TRANSLATE_NOOP("Command", "&Parts"),
        (
            *("part-add", "part-remove", "", "part-before", "part-after", "", "part-forward"),
            *("part-backward", "part-shown", "part-colour", "part-usual-colour", "", "suggest-pairing"),
            *("part-apart", "place", "usual-place", "joined", "", "parts"),
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Command", "Se&quence"),
        (
            *("shape-add", "shape-duplicate", "shape-delete", "", "shape-earlier", "shape-later"),
            *("", "step-before", "step-after", "alone"),
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Command", "&Tools"),
        (*PALETTE, "", "suggest", "marks", "", *_names(drawing.SNAPPING)),
    ),
    (
        QT_TRANSLATE_NOOP("Command", "&Blend"),
        (
            "play",
            "to-start",
            "to-end",
            "step-back",
            "step-forward",
            "next-crossing",
            "",
            "methods",
            "",
            "recompute",
        ),
    ),
    (
        QT_TRANSLATE_NOOP("Command", "&View"),
        (
            "fit",
            "zoom-in",
            "zoom-out",
            "",
            "pieces",
            "skeleton",
            "onion",
            "ways",
            "numbers",
            "pictures",
            "",
            "light",
            "dark",
            "",
            *LANGUAGES,
        ),
    ),
    (QT_TRANSLATE_NOOP("Command", "&Help"), _names(window.HELP)),
)
"""Menus in order; an empty name is a separator, and names that are no commands are submenus."""

TOOLBAR = (
    *("new", "open", "save", "", "undo", "redo", "", "suggest", "marks", ""),
    *("fit", "", "methods", "layers", "", "export"),
)
