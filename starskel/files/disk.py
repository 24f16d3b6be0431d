"""Bytes from and to the disk: a file is replaced as a whole or not at all."""

import contextlib
import os
import secrets
import stat
from pathlib import Path

from starskel.errors import InvalidFile


def read_bytes(path: Path) -> bytes:
    """Give what a file holds.

    Raises
    ------
    InvalidFile
        If it cannot be read, saying why.
    """
    try:
        return path.read_bytes()
    except OSError as error:
        raise InvalidFile(
            f"{path} cannot be read: {_reason(error)}", "give the path of a readable file"
        ) from error
    except ValueError as error:  # a path with a zero byte
        raise InvalidFile(f"{str(path)!r} is no path", "give the path of a readable file") from error


def write_bytes(path: Path, content: bytes) -> None:
    """Put a file in place, whole: after a failure, of the power too, the old one is still there.

    Raises
    ------
    InvalidFile
        If it cannot be written, saying why.
    """
    try:
        if path.exists() and not path.is_file():
            _write_through(path, content)
        else:
            _replace(path.resolve(), content)  # a symbolic link goes on pointing to the file
    except BrokenPipeError:
        raise
    except OSError as error:
        mend = "choose a folder that exists and may be written to"
        raise InvalidFile(f"{path} cannot be written: {_reason(error)}", mend) from error


def made_folder(path: Path) -> Path:
    """Make a folder, and those above it, where there is none; give it.

    Raises
    ------
    InvalidFile
        If it cannot be made, saying why.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        mend = "choose a folder, or a place where one may be made"
        raise InvalidFile(f"{path} cannot be made a folder: {_reason(error)}", mend) from error
    return path


def _write_through(device: Path, content: bytes) -> None:
    """Write to what must not be replaced by a file: /dev/stdout, a named pipe."""
    with device.open("wb") as stream:
        stream.write(content)


def _replace(target: Path, content: bytes) -> None:
    temporary = target.with_name(f".{secrets.token_hex(8)}.partial")
    try:
        with temporary.open("xb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        if target.exists():
            temporary.chmod(stat.S_IMODE(target.stat().st_mode))
        temporary.replace(target)
    except BaseException:
        with contextlib.suppress(OSError):
            temporary.unlink()
        raise


def _reason(error: OSError) -> str:
    return error.strerror or str(error)
