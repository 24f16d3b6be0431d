"""What must be there before a window can open; without it Qt would end the program with a signal."""

import ctypes
import os
import sys
from collections.abc import Mapping
from pathlib import Path

LIBRARIES = ("libEGL.so.1", "libGL.so.1", "libfontconfig.so.1", "libdbus-1.so.3", "libxkbcommon.so.0")
X_LIBRARIES = ("libX11-xcb.so.1", "libxcb-cursor.so.0", "libxcb-icccm.so.4", "libxkbcommon-x11.so.0")

NO_DISPLAY = (
    "there is no display to open a window on; start it on a desktop, or give it one "
    '(DISPLAY or WAYLAND_DISPLAY), for instance: xvfb-run -s "-screen 0 1440x900x24" starskel-editor'
)


def what_is_missing(environment: Mapping[str, str] = os.environ) -> str:
    """Say what is missing and how to mend it; "" where nothing is."""
    if not sys.platform.startswith("linux"):
        return ""
    asked_for = environment.get("QT_QPA_PLATFORM", "")
    screenless = asked_for != "" and not asked_for.startswith(("xcb", "wayland"))
    wayland = "WAYLAND_DISPLAY" in environment
    libraries = LIBRARIES if screenless or wayland else LIBRARIES + X_LIBRARIES
    absent = [name for name in libraries if not _loads(name)]
    if absent:
        return f"Qt needs system libraries that are not there: {', '.join(absent)}; install their packages"
    if screenless or (wayland and _wayland_answers(environment)) or _x_answers(environment):
        return ""
    return NO_DISPLAY


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def _wayland_answers(environment: Mapping[str, str]) -> bool:
    folder = Path(environment.get("XDG_RUNTIME_DIR", "/nowhere"))
    return (folder / environment["WAYLAND_DISPLAY"]).exists()


def _x_answers(environment: Mapping[str, str]) -> bool:
    """Try to connect, as the variable alone may name a server that has gone."""
    display = environment.get("DISPLAY", "")
    if not display:
        return False
    xcb = ctypes.CDLL("libxcb.so.1")
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connect.argtypes = [ctypes.c_char_p, ctypes.c_void_p]
    xcb.xcb_connection_has_error.argtypes = [ctypes.c_void_p]
    xcb.xcb_disconnect.argtypes = [ctypes.c_void_p]
    connection = xcb.xcb_connect(display.encode(), None)
    answers = xcb.xcb_connection_has_error(connection) == 0
    xcb.xcb_disconnect(connection)
    return bool(answers)
