"""The part of the table of commands about what is shown and how."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands.command import Command

VIEWING = (
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
)
