"""What a function opens: to be called in a process of its own, for who watches cannot look away again."""

import sys
from collections.abc import Callable

_KINDS = ("open", "os.", "shutil.", "socket.", "subprocess.", "urllib.", "ctypes.", "glob.", "pathlib.")
_HARMLESS = ("os.putenv",)


def opened_by(function: Callable[..., object], *arguments: object) -> list[str]:
    """Call a function twice, so that all is loaded; give the files and the like that it then asks for."""
    seen: list[str] = []
    watching = False

    def watch(event: str, given: tuple[object, ...]) -> None:
        if watching and event.startswith(_KINDS) and event not in _HARMLESS:
            seen.append(f"{event} {given[:1]}")

    sys.addaudithook(watch)
    for watching in (False, True):
        try:
            function(*arguments)
        except ValueError as error:
            seen += [] if watching else [f"refused: {error}"]
    watching = False
    return seen
