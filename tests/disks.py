"""Disks that are full or read-only, the real thing: mounted for one test."""

import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest


@contextmanager
def small_disk(place: Path, options: str = "size=64k") -> Iterator[Path]:
    """Mount a disk in memory; skip the test where that is not allowed."""
    place.mkdir()
    mounted = os.geteuid() == 0 and not _run("mount", "-t", "tmpfs", "-o", options, "none", str(place))
    if not mounted:
        pytest.skip("mounting a disk needs the rights of root")
    try:
        yield place
    finally:
        assert not _run("umount", "--lazy", str(place))


@contextmanager
def filled(disk: Path) -> Iterator[None]:
    """Fill a disk, until not a byte more has room."""
    filling = disk / "filling"
    with filling.open("wb", buffering=0) as stream, suppress(OSError):
        while True:
            stream.write(bytes(4096))
    yield
    filling.unlink()


def read_only(disk: Path) -> None:
    """Let nothing more be written to a disk."""
    assert not _run("mount", "-o", "remount,ro", str(disk))


def _run(*command: str) -> int:
    return subprocess.run(command, capture_output=True, check=False).returncode
