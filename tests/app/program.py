"""The whole editor in a process of its own."""

import os
import subprocess
import sys
from pathlib import Path


def program(state: Path, code: str) -> "subprocess.CompletedProcess[str]":
    """Run the whole editor, and some code as soon as its window is there."""
    text = f"""
import sys, pathlib
from PySide6.QtCore import QSettings, QTimer
for kind in (QSettings.Format.NativeFormat, QSettings.Format.IniFormat):
    QSettings.setPath(kind, QSettings.Scope.UserScope, {str(state)!r})
from PySide6.QtWidgets import QApplication
from app.view import start
begin = start.begin
def begun(window, path):
    begin(window, path)
    def act():
{chr(10).join("        " + line for line in code.splitlines())}
    QTimer.singleShot(0, act)
start.begin = begun
sys.exit(start.run(None))
"""
    surroundings = {**os.environ, "XDG_STATE_HOME": str(state), "QT_QPA_PLATFORM": "offscreen"}
    return subprocess.run(
        [sys.executable, "-c", text],
        env=surroundings,
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
