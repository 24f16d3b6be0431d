"""Bytes from and to the disk: a file is replaced as a whole or not at all."""

import contextlib
import errno
import hashlib
import os
import re
import secrets
import shutil
import stat
import time
from collections.abc import Sequence
from pathlib import Path

from starskel.errors import InvalidFile, either, told
from starskel.limits import DOCUMENT_BYTES, check_limit

_CHUNK = 1 << 20
"""Bytes that are read at a time: of what has no end, such as a device, no more than the limit."""

_PARTIAL = ".partial"

_STALE = 600.0
"""Seconds since something was last written to a partial file, after which nobody is writing it any more."""


def read_bytes(path: Path, most: int = DOCUMENT_BYTES) -> bytes:
    """Give what a file holds, of at most so many bytes.

    Raises
    ------
    InvalidFile
        If it cannot be read or is larger, saying why.
    """
    try:
        with path.open("rb") as stream:
            _check_size(path, os.fstat(stream.fileno()).st_size, most)
            content = bytearray()
            while chunk := stream.read(_CHUNK):
                content += chunk
                _check_size(path, len(content), most)
            return bytes(content)
    except InvalidFile:
        raise
    except OSError as error:
        raise InvalidFile(
            told("{path} cannot be read: {reason}", path=path, reason=_reason(error)),
            told("give the path of a readable file"),
        ) from error
    except ValueError as error:  # a path with a zero byte
        raise InvalidFile(
            told("{path} is no path", path=repr(str(path))), told("give the path of a readable file")
        ) from error


def wrong_ending(path: Path, endings: Sequence[str]) -> InvalidFile:
    """Give the error of a file to be written whose name ends in none of these."""
    return InvalidFile(
        told('{name} ends in "{ending}"', name=path.name, ending=path.suffix),
        told("end it in {endings}", endings=either(endings)),
    )


def digest_of(path: Path) -> str | None:
    """Give a word that tells what a file holds from everything else; None where it cannot be read."""
    try:
        if not path.is_file():
            return None
        with path.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except (OSError, ValueError):
        return None


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
        if error.errno in (errno.ENOSPC, errno.EDQUOT):
            mend = told("free some space there, or choose another disk")
        else:
            mend = told("choose a folder that exists and may be written to")
        raise InvalidFile(
            told("{path} cannot be written: {reason}", path=path, reason=_reason(error)), mend
        ) from error


def clear_leftovers(folder: Path) -> None:
    """Remove what programs that were killed had begun to write into a folder, some minutes ago or earlier."""
    with contextlib.suppress(OSError):
        for left in folder.glob(f".*{_PARTIAL}"):
            old = time.time() - left.stat().st_mtime > _STALE
            if old and re.fullmatch(rf"\.[0-9a-f]{{16}}\{_PARTIAL}", left.name):
                left.unlink(missing_ok=True)


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
        mend = told("choose a folder, or a place where one may be made")
        raise InvalidFile(
            told("{path} cannot be made a folder: {reason}", path=path, reason=_reason(error)), mend
        ) from error
    return path


def room_in(folder: Path) -> int:
    """Give how many bytes can be written in a folder, 0 where it does not exist or may not be written to."""
    try:
        return shutil.disk_usage(folder).free if os.access(folder, os.W_OK) else 0
    except OSError:
        return 0


def _write_through(device: Path, content: bytes) -> None:
    """Write to what must not be replaced by a file: /dev/stdout, a named pipe."""
    with device.open("wb") as stream:
        stream.write(content)


def _replace(target: Path, content: bytes) -> None:
    temporary = target.with_name(f".{secrets.token_hex(8)}{_PARTIAL}")
    try:
        with temporary.open("xb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        if target.exists():
            temporary.chmod(stat.S_IMODE(target.stat().st_mode))
        temporary.replace(target)
        _settle(target.parent)
    except BaseException:
        with contextlib.suppress(OSError):
            temporary.unlink()
        raise


def _settle(folder: Path) -> None:
    """Have the disk know of a new name in a folder; not every file system can do that, or needs to."""
    with contextlib.suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


def _check_size(path: Path, count: int, most: int) -> None:
    check_limit(str(path), told("bytes"), count, most)


def _reason(error: OSError) -> str:
    usual = {
        errno.ENOENT: told("No such file or directory"),
        errno.EACCES: told("Permission denied"),
        errno.EISDIR: told("Is a directory"),
        errno.ENOTDIR: told("Not a directory"),
        errno.ENOSPC: told("No space left on device"),
        errno.EROFS: told("Read-only file system"),
    }
    return usual.get(error.errno or 0) or error.strerror or str(error)
