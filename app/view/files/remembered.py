"""What the program remembers from one time to the next."""

from pathlib import Path

from PySide6.QtCore import QByteArray, QSettings
from PySide6.QtWidgets import QComboBox, QMainWindow, QSplitter

RECENT = 10
"""So many files are remembered."""

_FILES = "files/recent"
_FOLDER = "files/folder"
_LAST = "files/last"
_THEME = "theme"
_SWITCHES = "switches"


def recent_files() -> tuple[Path, ...]:
    """Give the files that were open, the last one first; those that are gone are left out."""
    return tuple(path for path in _remembered_files() if path.is_file())


def remember_file(path: Path) -> None:
    """Put a file before all others, and look for the next one beside it."""
    path = path.absolute()
    remember_folder(path.parent)
    others = [each for each in _remembered_files() if each != path]
    _write_files([path, *others[: RECENT - 1]])


def forget_files() -> None:
    """Remember no file."""
    _write_files([])


def last_folder() -> Path:
    """Give the folder of the file that was chosen last; where there is none, the one the program began in."""
    kept = str(QSettings().value(_FOLDER, ""))
    return Path(kept) if kept and Path(kept).is_dir() else Path.cwd()


def remember_folder(folder: Path) -> None:
    """Look for the next file here, of whatever kind it is."""
    QSettings().setValue(_FOLDER, str(folder.absolute()))


def last_file() -> Path | None:
    """Give the project that was open when the program ended, None where that had no file."""
    path = Path(str(QSettings().value(_LAST, "")))
    return path if path.is_file() else None


def remember_last_file(path: Path | None) -> None:
    """Open this file at the next start, or none."""
    QSettings().setValue(_LAST, "" if path is None else str(path.absolute()))


def theme_name() -> str:
    """Give the theme that the user has chosen, "" where that is left to the system."""
    return str(QSettings().value(_THEME, ""))


def remember_theme(name: str) -> None:
    QSettings().setValue(_THEME, name)


def switches() -> dict[str, bool]:
    """Give the commands that are switches, and whether they were on."""
    settings = QSettings()
    settings.beginGroup(_SWITCHES)
    return {name: str(settings.value(name)).lower() == "true" for name in settings.childKeys()}


def remember_switches(states: dict[str, bool]) -> None:
    settings = QSettings()
    settings.beginGroup(_SWITCHES)
    for name, on in states.items():
        settings.setValue(name, on)


def remember_layout(window: QMainWindow) -> None:
    """Keep where the window and its parts are."""
    settings = QSettings()
    settings.setValue("window/geometry", window.saveGeometry())
    settings.setValue("window/state", window.saveState())
    for splitter in _splitters(window):
        settings.setValue(f"window/{splitter.objectName()}", splitter.saveState())


def restore_layout(window: QMainWindow) -> None:
    """Put the window and its parts where they were; without anything remembered all stays as it is."""
    for name, restore in (
        ("geometry", window.restoreGeometry),
        ("state", window.restoreState),
        *((each.objectName(), each.restoreState) for each in _splitters(window)),
    ):
        kept = QSettings().value(f"window/{name}")
        if isinstance(kept, QByteArray):
            restore(kept)


def remember_playing(window: QMainWindow) -> None:
    """Keep how fast is played, and what happens at the end."""
    for box in _playing(window):
        QSettings().setValue(f"playing/{box.objectName()}", box.currentIndex())


def restore_playing(window: QMainWindow) -> None:
    """Play as it was; without anything remembered all stays as it is."""
    for box in _playing(window):
        kept = QSettings().value(f"playing/{box.objectName()}", box.currentIndex())
        if str(kept).isdecimal() and int(str(kept)) < box.count():
            box.setCurrentIndex(int(str(kept)))


def _playing(window: QMainWindow) -> list[QComboBox]:
    return [box for box in window.findChildren(QComboBox) if box.objectName() in ("repeat", "speed")]


def _splitters(window: QMainWindow) -> list[QSplitter]:
    return [each for each in window.findChildren(QSplitter) if each.objectName()]


def _remembered_files() -> list[Path]:
    settings = QSettings()
    count = settings.beginReadArray(_FILES)
    paths = []
    for number in range(count):
        settings.setArrayIndex(number)
        paths.append(Path(str(settings.value("path"))))
    settings.endArray()
    return paths


def _write_files(paths: list[Path]) -> None:
    settings = QSettings()
    settings.remove(_FILES)
    settings.beginWriteArray(_FILES, len(paths))
    for number, path in enumerate(paths):
        settings.setArrayIndex(number)
        settings.setValue("path", str(path))
    settings.endArray()
