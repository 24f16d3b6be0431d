"""What of a window is kept from one start to the next: its layout, how it plays, its switches, its file."""

from dataclasses import fields
from pathlib import Path

from PySide6.QtWidgets import QMainWindow

from app.view.canvas.options.bar import SWITCHES
from app.view.commands.actions import Actions
from app.view.files.remembered import (
    remember_last_file,
    remember_layout,
    remember_playing,
    remember_switches,
    restore_layout,
    restore_playing,
    switches,
)
from app.view.painting.display import Layers

KEPT = (*SWITCHES, *(field.name for field in fields(Layers)))
"""The switches that are as they were at the next start: what the tools snap to, and what is shown."""


def restore_window(window: QMainWindow, actions: Actions) -> None:
    """Have window and switches as they were."""
    restore_layout(window)
    restore_playing(window)
    for name, on in switches().items():
        if name in KEPT and actions[name].isChecked() != on:
            actions[name].trigger()


def keep_window(window: QMainWindow, actions: Actions, path: Path | None) -> None:
    """Keep window, switches and the name of the file for the next start."""
    remember_layout(window)
    remember_playing(window)
    remember_last_file(path)
    remember_switches({name: actions[name].isChecked() for name in KEPT})
