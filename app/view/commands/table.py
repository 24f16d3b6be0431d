"""The one table of all commands; menus, toolbar and shortcuts are made from it."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands import drawing, parts, sequence, window
from app.view.commands.command import Command

COMMANDS = (
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
        QT_TRANSLATE_NOOP("Command", "Select all vertices of the shape last worked on"),
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
    *drawing.TOOLS,
    *drawing.SNAPPING,
    *drawing.CLIPBOARD,
    *drawing.SHAPE,
    *parts.PARTS,
    *sequence.SEQUENCE,
    *window.WINDOW,
    *window.HELP,
    *drawing.PICTURE,
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
    Command(
        "fit",
        QT_TRANSLATE_NOOP("Command", "&Fit"),
        QT_TRANSLATE_NOOP("Command", "Show both shapes whole"),
        ("F",),
    ),
    Command(
        "zoom-in",
        QT_TRANSLATE_NOOP("Command", "Zoom &In"),
        QT_TRANSLATE_NOOP("Command", "Show both shapes larger"),
        ("Ctrl++", "Ctrl+="),
    ),
    Command(
        "zoom-out",
        QT_TRANSLATE_NOOP("Command", "Zoom &Out"),
        QT_TRANSLATE_NOOP("Command", "Show both shapes smaller"),
        ("Ctrl+-",),
    ),
    Command(
        "pieces",
        QT_TRANSLATE_NOOP("Command", "Star &Pieces"),
        QT_TRANSLATE_NOOP("Command", "Show the star pieces in the frames"),
        ("Ctrl+1",),
        "",
        True,
    ),
    Command(
        "skeleton",
        QT_TRANSLATE_NOOP("Command", "S&keleton"),
        QT_TRANSLATE_NOOP("Command", "Show the skeleton in the frames"),
        ("Ctrl+2",),
        "",
        True,
    ),
    Command(
        "onion",
        QT_TRANSLATE_NOOP("Command", "Onion &Skin"),
        QT_TRANSLATE_NOOP("Command", "Show frames before and after as faint outlines"),
        ("Ctrl+3",),
        "",
        True,
    ),
    Command(
        "ways",
        QT_TRANSLATE_NOOP("Command", "Pat&hs"),
        QT_TRANSLATE_NOOP("Command", "Show the paths of the vertices through time"),
        ("Ctrl+4",),
        "",
        True,
    ),
    Command(
        "numbers",
        QT_TRANSLATE_NOOP("Command", "Vertex &Numbers"),
        QT_TRANSLATE_NOOP("Command", "Show the numbers of the vertices, as the table of marks uses them"),
        ("Ctrl+5",),
        "",
        True,
    ),
    Command(
        "pictures",
        QT_TRANSLATE_NOOP("Command", "Pi&ctures in the Shapes"),
        QT_TRANSLATE_NOOP("Command", "Show the pictures in the frames, the one fading into the other"),
        ("Ctrl+6",),
        "",
        True,
    ),
    Command(
        "light",
        QT_TRANSLATE_NOOP("Command", "&Light"),
        QT_TRANSLATE_NOOP("Command", "Dark writing on light ground"),
        (),
        "theme",
        True,
    ),
    Command(
        "dark",
        QT_TRANSLATE_NOOP("Command", "&Dark"),
        QT_TRANSLATE_NOOP("Command", "Light writing on dark ground"),
        (),
        "theme",
        True,
    ),
    Command(
        "language-system",
        QT_TRANSLATE_NOOP("Command", "Language of the S&ystem"),
        QT_TRANSLATE_NOOP("Command", "Speak the language of the system, from the next start on"),
        (),
        "language",
        True,
    ),
    Command(
        "language-en",
        QT_TRANSLATE_NOOP("Command", "&English"),
        QT_TRANSLATE_NOOP("Command", "Speak English, from the next start on"),
        (),
        "language",
        True,
    ),
    Command(
        "language-de",
        QT_TRANSLATE_NOOP("Command", "De&utsch"),
        QT_TRANSLATE_NOOP("Command", "Speak German, from the next start on"),
        (),
        "language",
        True,
    ),
    Command(
        "play", QT_TRANSLATE_NOOP("Command", "&Play"), QT_TRANSLATE_NOOP("Command", "Play or pause"), ("P",)
    ),
    Command(
        "to-start",
        QT_TRANSLATE_NOOP("Command", "Go to &Source"),
        QT_TRANSLATE_NOOP("Command", "Show the source, t = 0"),
        ("Home",),
    ),
    Command(
        "to-end",
        QT_TRANSLATE_NOOP("Command", "Go to &Target"),
        QT_TRANSLATE_NOOP("Command", "Show the target, t = 1"),
        ("End",),
    ),
    Command(
        "step-back",
        QT_TRANSLATE_NOOP("Command", "Frame &Back"),
        QT_TRANSLATE_NOOP("Command", "Stop, and show the frame before"),
        (",",),
    ),
    Command(
        "step-forward",
        QT_TRANSLATE_NOOP("Command", "Frame For&ward"),
        QT_TRANSLATE_NOOP("Command", "Stop, and show the next frame"),
        (".",),
    ),
    Command(
        "next-crossing",
        QT_TRANSLATE_NOOP("Command", "Ne&xt Crossing"),
        QT_TRANSLATE_NOOP("Command", "Stop where the next of the blends shown crosses itself"),
        ("X",),
    ),
    Command(
        "recompute",
        QT_TRANSLATE_NOOP("Command", "&Compute Again"),
        QT_TRANSLATE_NOOP("Command", "Compute all blends anew"),
        ("F5",),
    ),
    Command(
        "begin",
        QT_TRANSLATE_NOOP("Command", "How to &Begin"),
        QT_TRANSLATE_NOOP("Command", "Show in five lines how to begin"),
        (),
        "",
        True,
    ),
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
    (QT_TRANSLATE_NOOP("Command", "&Help"), ("begin", "", *_names(window.HELP))),
)
"""Menus in order; an empty name is a separator, and names that are no commands are submenus."""

TOOLBAR = (
    *("new", "open", "save", "", "undo", "redo", "", "suggest", "marks", ""),
    *("fit", "", "methods", "layers", "", "export"),
)
