"""The part of the table of commands about time and computing."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

from app.view.commands.command import Command

PLAYING = (
    Command(
        "play",
        QT_TRANSLATE_NOOP("Command", "&Play"),
        QT_TRANSLATE_NOOP("Command", "Play or pause; so does a tap of Space"),
        ("P",),
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
)
