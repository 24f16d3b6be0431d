"""See to it that the system holds what the project needs from it; give the sets wanted as arguments.

    python3 system_packages.py [venv] [qt] [display] [renderers]

As root on a Debian (or a relative of it) what is missing is installed; elsewhere it is named, and the exit
status is 1.
Standard library only: this runs before the virtual environment is there.
"""

import ctypes
import importlib.util
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

FONT_FOLDERS = ("/usr/share/fonts", "/usr/local/share/fonts", "~/.local/share/fonts", "~/.fonts")


def module(name: str) -> bool:
    return importlib.util.find_spec(name) is not None


def library(name: str) -> bool:
    try:
        ctypes.CDLL(name)
    except OSError:
        return False
    return True


def program(name: str) -> bool:
    return shutil.which(name) is not None


def font(suffix: str) -> bool:
    return any(True for folder in FONT_FOLDERS for _ in Path(folder).expanduser().rglob("*" + suffix))


Need = tuple[Callable[[str], bool], str, str]

# What is looked for, rather than the package, because the package has other names elsewhere.
SETS: dict[str, list[Need]] = {
    "venv": [(module, "ensurepip", "python3-venv")],
    "qt": [
        (library, "libEGL.so.1", "libegl1"),
        (library, "libGL.so.1", "libgl1"),
        (library, "libfontconfig.so.1", "libfontconfig1"),
        (library, "libfreetype.so.6", "libfreetype6"),
        (library, "libglib-2.0.so.0", "libglib2.0-0"),
        (library, "libdbus-1.so.3", "libdbus-1-3"),
        (library, "libxkbcommon.so.0", "libxkbcommon0"),
        (library, "libX11.so.6", "libx11-6"),
        (font, ".ttf", "fonts-dejavu-core"),
    ],
    "display": [
        (library, "libX11-xcb.so.1", "libx11-xcb1"),
        (library, "libxcb-cursor.so.0", "libxcb-cursor0"),
        (library, "libxcb-icccm.so.4", "libxcb-icccm4"),
        (library, "libxcb-keysyms.so.1", "libxcb-keysyms1"),
        (library, "libxcb-randr.so.0", "libxcb-randr0"),
        (library, "libxcb-shape.so.0", "libxcb-shape0"),
        (library, "libxcb-sync.so.1", "libxcb-sync1"),
        (library, "libxcb-xfixes.so.0", "libxcb-xfixes0"),
        (library, "libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
    ],
    "renderers": [
        (program, "gs", "ghostscript"),
        (program, "rsvg-convert", "librsvg2-bin"),
        (program, "chromium", "chromium"),
        (program, "Xvfb", "xvfb"),
        (program, "xauth", "xauth"),
    ],
}


def missing(sets: list[str]) -> list[str]:
    return [package for name in sets for found, thing, package in SETS[name] if not found(thing)]


def install(packages: list[str]) -> None:
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    print("installing", *packages, flush=True)
    subprocess.run(["apt-get", "update", "-q"], check=True, env=environment, stdout=subprocess.DEVNULL)
    command = ["apt-get", "install", "-q", "-y", "--no-install-recommends", *packages]
    subprocess.run(command, check=True, env=environment, stdout=subprocess.DEVNULL)


def main(sets: list[str]) -> int:
    if not sys.platform.startswith("linux"):
        return 0  # elsewhere Python and Qt bring what they need
    packages = missing(sets)
    if not packages:
        return 0
    if os.geteuid() == 0 and program("apt-get"):
        install(packages)
        return 0
    print("System packages are missing (Debian's names). As root:", file=sys.stderr)
    print("  apt-get install --no-install-recommends", *packages, file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
