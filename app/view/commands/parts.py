"""The part of the table of commands that is about the parts of shapes."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands.command import Command

PARTS = (
    Command(
        "part-add",
        QT_TRANSLATE_NOOP("Command", "&Add Part"),
        QT_TRANSLATE_NOOP("Command", "Draw one more polygon of the shape; inside another one it is a hole"),
        ("Ctrl+Shift+A",),
    ),
    Command(
        "part-remove",
        QT_TRANSLATE_NOOP("Command", "&Remove Part"),
        QT_TRANSLATE_NOOP("Command", "Take the part worked on away from both shapes"),
        ("Shift+Del",),
    ),
    Command(
        "part-before",
        QT_TRANSLATE_NOOP("Command", "Pre&vious Part"),
        QT_TRANSLATE_NOOP("Command", "Work on the part before in the list"),
        ("Shift+PgUp",),
    ),
    Command(
        "part-after",
        QT_TRANSLATE_NOOP("Command", "Ne&xt Part"),
        QT_TRANSLATE_NOOP("Command", "Work on the next part of the list"),
        ("Shift+PgDown",),
    ),
    Command(
        "part-forward",
        QT_TRANSLATE_NOOP("Command", "Bring &Forward"),
        QT_TRANSLATE_NOOP("Command", "Paint the part over the next one"),
        ("Ctrl+Shift+Up",),
    ),
    Command(
        "part-backward",
        QT_TRANSLATE_NOOP("Command", "Send &Backward"),
        QT_TRANSLATE_NOOP("Command", "Paint the part under the one before"),
        ("Ctrl+Shift+Down",),
    ),
    Command(
        "part-shown",
        QT_TRANSLATE_NOOP("Command", "&Show Part"),
        QT_TRANSLATE_NOOP("Command", "Show the part or hide it, on the canvases and in the frames"),
        ("Ctrl+Shift+V",),
        "",
        True,
    ),
    Command(
        "part-colour",
        QT_TRANSLATE_NOOP("Command", "&Colour of Part…"),
        QT_TRANSLATE_NOOP("Command", "Choose a colour for the part"),
        ("Ctrl+Shift+C",),
    ),
    Command(
        "part-usual-colour",
        QT_TRANSLATE_NOOP("Command", "&Usual Colour"),
        QT_TRANSLATE_NOOP("Command", "Give the part the colour that shapes usually have"),
    ),
    Command(
        "part-apart",
        QT_TRANSLATE_NOOP("Command", "Leave Wit&hout Partner"),
        QT_TRANSLATE_NOOP("Command", "Let the part shrink to a point, and its partner grow from one"),
        ("Ctrl+Shift+B",),
    ),
    Command(
        "place",
        QT_TRANSLATE_NOOP("Command", "&Place of Growth"),
        QT_TRANSLATE_NOOP("Command", "Choose where a part without a partner grows from, or shrinks to"),
        ("Ctrl+Shift+G",),
        "tool",
        True,
    ),
    Command(
        "usual-place",
        QT_TRANSLATE_NOOP("Command", "Usual Place of Gro&wth"),
        QT_TRANSLATE_NOOP("Command", "Leave it to the program where the part grows from, or shrinks to"),
    ),
    Command(
        "suggest-pairing",
        QT_TRANSLATE_NOOP("Command", "Suggest Pairin&g"),
        QT_TRANSLATE_NOOP("Command", "Let parts become those that fit them best in size and place"),
        ("Ctrl+Shift+M",),
    ),
    Command(
        "joined",
        QT_TRANSLATE_NOOP("Command", "Move &Together"),
        QT_TRANSLATE_NOOP("Command", "Let the parts move together, instead of each by itself"),
        (),
        "",
        True,
    ),
    Command(
        "parts",
        QT_TRANSLATE_NOOP("Command", "Parts &List"),
        QT_TRANSLATE_NOOP("Command", "Show the list of parts and what becomes of them"),
        ("Ctrl+Shift+T",),
        "",
        True,
    ),
)
