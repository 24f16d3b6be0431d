"""What went wrong, written down in the state folder: faults that Python caught, and crashes of Qt."""

import contextlib
import faulthandler
import logging
import os
from collections.abc import Iterator
from datetime import datetime
from io import FileIO
from pathlib import Path

from app.recovery.places import state_folder

FAULTS = "faults.log"
CRASHES = "crashes.log"

MOST = 1_000_000
"""Bytes of a log; a longer one begins anew, and the old one stays beside it until the next time."""


def log_fault(text: str) -> Path | None:
    """Write a fault down; give the file, or None where that is not possible."""
    try:
        path = _log(FAULTS)
        with path.open("a", encoding="utf-8") as stream:
            stream.write(f"{_now()}, process {os.getpid()}\n{text}\n")
    except OSError:
        return None
    return path


class _Journal(logging.Handler):
    """Writes down what is told to the log of the program."""

    def emit(self, record: logging.LogRecord) -> None:
        log_fault(self.format(record))


@contextlib.contextmanager
def faults_logged() -> Iterator[None]:
    """Have faults that were caught where they are shown in passing be printed and written down."""
    log, handlers = logging.getLogger("app"), (logging.StreamHandler(), _Journal())
    for handler in handlers:
        log.addHandler(handler)
    try:
        yield
    finally:
        for handler in handlers:
            log.removeHandler(handler)


@contextlib.contextmanager
def crashes_logged() -> Iterator[None]:
    """Have crashes of Qt and the like leave the calls of all threads in a file; without a disk, nowhere."""
    try:
        stream = _log(CRASHES).open("ab", buffering=0)
    except OSError:
        yield
        return
    with stream:
        _note(stream, "begins; what follows without an end is a crash")
        faulthandler.enable(stream)
        try:
            yield
        finally:
            faulthandler.disable()
            _note(stream, "ends")


def _note(stream: FileIO, what: str) -> None:
    """Write down what the program does, where the disk has room for it."""
    with contextlib.suppress(OSError):
        stream.write(f"{_now()}, process {os.getpid()} {what}\n".encode())


def _log(name: str) -> Path:
    folder = state_folder()
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / name
    if path.exists() and path.stat().st_size > MOST:
        path.replace(path.with_suffix(".old.log"))
    return path


def _now() -> str:
    return datetime.now().astimezone().isoformat(timespec="seconds")
