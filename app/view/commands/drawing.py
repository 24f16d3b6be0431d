"""The part of the table of commands that is about drawing: tools, what is done to shapes, snapping."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands.command import Command

TOOLS = (
    Command(
        "select",
        QT_TRANSLATE_NOOP("Command", "&Select"),
        QT_TRANSLATE_NOOP("Command", "Select, move, scale, turn, insert and delete vertices"),
        ("S",),
        "tool",
        True,
    ),
    Command(
        "draw",
        QT_TRANSLATE_NOOP("Command", "&Draw"),
        QT_TRANSLATE_NOOP("Command", "Draw a shape vertex by vertex"),
        ("D",),
        "tool",
        True,
    ),
    Command(
        "freehand",
        QT_TRANSLATE_NOOP("Command", "&Freehand"),
        QT_TRANSLATE_NOOP("Command", "Draw a shape by hand"),
        ("H",),
        "tool",
        True,
    ),
    Command(
        "rectangle",
        QT_TRANSLATE_NOOP("Command", "&Rectangle"),
        QT_TRANSLATE_NOOP("Command", "Draw a rectangle"),
        ("R",),
        "tool",
        True,
    ),
    Command(
        "ellipse",
        QT_TRANSLATE_NOOP("Command", "&Ellipse"),
        QT_TRANSLATE_NOOP("Command", "Draw an ellipse"),
        ("E",),
        "tool",
        True,
    ),
    Command(
        "regular-polygon",
        QT_TRANSLATE_NOOP("Command", "Regular &Polygon"),
        QT_TRANSLATE_NOOP("Command", "Draw a regular polygon"),
        ("G",),
        "tool",
        True,
    ),
    Command(
        "star",
        QT_TRANSLATE_NOOP("Command", "S&tar"),
        QT_TRANSLATE_NOOP("Command", "Draw a star"),
        ("Shift+G",),
        "tool",
        True,
    ),
    Command(
        "text",
        QT_TRANSLATE_NOOP("Command", "Te&xt"),
        QT_TRANSLATE_NOOP("Command", "Set a letter or a text in outlines"),
        ("T",),
        "tool",
        True,
    ),
    Command(
        "picture",
        QT_TRANSLATE_NOOP("Command", "P&icture"),
        QT_TRANSLATE_NOOP("Command", "Place a picture behind a shape, to draw over it"),
        ("I",),
        "tool",
        True,
    ),
)

SNAPPING = (
    Command(
        "snap-vertices",
        QT_TRANSLATE_NOOP("Command", "Snap to &Vertices"),
        QT_TRANSLATE_NOOP("Command", "Let vertices catch the pointer, and their heights and sides"),
        ("Ctrl+Alt+V",),
        "",
        True,
    ),
    Command(
        "snap-edges",
        QT_TRANSLATE_NOOP("Command", "S&nap to Edges"),
        QT_TRANSLATE_NOOP("Command", "Let edges catch the pointer, and the lines that lengthen them"),
        ("Ctrl+Alt+E",),
        "",
        True,
    ),
    Command(
        "snap-angles",
        QT_TRANSLATE_NOOP("Command", "Snap to &15°"),
        QT_TRANSLATE_NOOP("Command", "Let edges catch at multiples of 15°"),
        ("Ctrl+Alt+A",),
        "",
        True,
    ),
    Command(
        "snap-grid",
        QT_TRANSLATE_NOOP("Command", "Snap to &Grid"),
        QT_TRANSLATE_NOOP("Command", "Show a grid and go from point to point of it"),
        ("Ctrl+Alt+G",),
        "",
        True,
    ),
)

CLIPBOARD = (
    Command(
        "cut",
        QT_TRANSLATE_NOOP("Command", "Cu&t Shape"),
        QT_TRANSLATE_NOOP("Command", "Take the selected parts, or the whole shape, to the clipboard"),
        ("Ctrl+X",),
    ),
    Command(
        "copy",
        QT_TRANSLATE_NOOP("Command", "&Copy Shape"),
        QT_TRANSLATE_NOOP(
            "Command", "Copy the selected parts with their holes, or the whole shape; as SVG, too"
        ),
        ("Ctrl+C",),
    ),
    Command(
        "paste",
        QT_TRANSLATE_NOOP("Command", "&Paste Shape"),
        QT_TRANSLATE_NOOP(
            "Command", "Put a copied shape in place of the one last worked on, or add copied parts"
        ),
        ("Ctrl+V",),
    ),
)

SHAPE = (
    Command(
        "copy-across",
        QT_TRANSLATE_NOOP("Command", "Copy to &Other Canvas"),
        QT_TRANSLATE_NOOP("Command", "Begin the other shape with a copy of this one, marks and all"),
        ("Ctrl+D",),
    ),
    Command(
        "exchange",
        QT_TRANSLATE_NOOP("Command", "&Reverse"),
        QT_TRANSLATE_NOOP("Command", "Exchange source and target with their marks: the blend runs backwards"),
        ("Ctrl+R",),
    ),
    Command(
        "mirror-across",
        QT_TRANSLATE_NOOP("Command", "&Mirror Left and Right"),
        QT_TRANSLATE_NOOP("Command", "Exchange left and right of the selection, or of the whole shape"),
        ("Ctrl+Shift+H",),
    ),
    Command(
        "mirror-down",
        QT_TRANSLATE_NOOP("Command", "Mirror &Up and Down"),
        QT_TRANSLATE_NOOP("Command", "Exchange above and below of the selection, or of the whole shape"),
        ("Ctrl+Shift+J",),
    ),
    Command(
        "simplify",
        QT_TRANSLATE_NOOP("Command", "&Simplify"),
        QT_TRANSLATE_NOOP("Command", "Leave out vertices that matter least; then adjust how far"),
        ("Ctrl+L",),
    ),
    Command(
        "refine",
        QT_TRANSLATE_NOOP("Command", "Re&fine"),
        QT_TRANSLATE_NOOP("Command", "Add vertices evenly; then adjust how many"),
        ("Ctrl+Shift+L",),
    ),
    Command(
        "set-first",
        QT_TRANSLATE_NOOP("Command", "Set First &Vertex"),
        QT_TRANSLATE_NOOP("Command", "Let the vertices count from the selected one on; it is drawn filled"),
        ("Ctrl+Shift+F",),
    ),
)

PICTURE = (
    Command(
        "picture-open",
        QT_TRANSLATE_NOOP("Command", "Open P&icture…"),
        QT_TRANSLATE_NOOP("Command", "Put a picture behind the shape last worked on"),
        ("Ctrl+Shift+O",),
    ),
    Command(
        "picture-trace",
        QT_TRANSLATE_NOOP("Command", "&Trace Outline…"),
        QT_TRANSLATE_NOOP("Command", "Draw the shape along the edge of what is seen in the picture"),
        ("Ctrl+Shift+E",),
    ),
    Command(
        "picture-lock",
        QT_TRANSLATE_NOOP("Command", "&Lock Picture"),
        QT_TRANSLATE_NOOP("Command", "Let the picture stay where it is"),
        (),
        "",
        True,
    ),
    Command(
        "picture-crop",
        QT_TRANSLATE_NOOP("Command", "&Crop Picture to Shape"),
        QT_TRANSLATE_NOOP("Command", "Show only what is inside the shape; blends never carry more than that"),
        (),
        "",
        True,
    ),
    Command(
        "picture-remove",
        QT_TRANSLATE_NOOP("Command", "R&emove Picture"),
        QT_TRANSLATE_NOOP("Command", "Take the picture away from behind the shape"),
    ),
)
