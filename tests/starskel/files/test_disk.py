import os
import stat
from pathlib import Path

import pytest

from starskel.errors import InvalidFile
from starskel.files.disk import digest_of, read_bytes, write_bytes


def test_what_is_written_is_read(tmp_path):
    write_bytes(tmp_path / "a", b"one")
    write_bytes(tmp_path / "a", b"two")
    assert read_bytes(tmp_path / "a") == b"two"
    assert [path.name for path in tmp_path.iterdir()] == ["a"]


def test_a_failure_leaves_the_old_file_and_nothing_else(tmp_path, monkeypatch):
    write_bytes(tmp_path / "a", b"old")

    def full(descriptor):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(InvalidFile, match=r"a cannot be written: No space left on device.*free some space"):
        write_bytes(tmp_path / "a", b"new")
    assert read_bytes(tmp_path / "a") == b"old"
    assert [path.name for path in tmp_path.iterdir()] == ["a"]


def test_an_interruption_leaves_the_old_file_and_nothing_else(tmp_path, monkeypatch):
    write_bytes(tmp_path / "a", b"old")

    def interrupted(descriptor):
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_bytes(tmp_path / "a", b"new")
    assert read_bytes(tmp_path / "a") == b"old"
    assert [path.name for path in tmp_path.iterdir()] == ["a"]


def test_a_symbolic_link_goes_on_pointing_to_the_file(tmp_path):
    (tmp_path / "real").write_bytes(b"old")
    (tmp_path / "link").symlink_to("real")
    write_bytes(tmp_path / "link", b"new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_bytes() == b"new"


def test_the_permissions_of_a_file_stay(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"old")
    path.chmod(0o640)
    write_bytes(path, b"new")
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


def test_a_device_is_written_to_and_not_replaced(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reading = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    write_bytes(pipe, b"through")
    assert os.read(reading, 100) == b"through"
    os.close(reading)
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_a_missing_folder_is_named(tmp_path):
    with pytest.raises(
        InvalidFile, match="gone/a cannot be written: No such file or directory; choose a folder"
    ):
        write_bytes(tmp_path / "gone" / "a", b"")


@pytest.mark.parametrize(
    ("path", "reason"),
    [("gone", "No such file"), ("", "Is a directory"), ("a\0b", "is no path"), ("a" * 300, "name too long")],
)
def test_what_cannot_be_read_is_an_invalid_file(tmp_path, path, reason):
    with pytest.raises(InvalidFile, match=reason):
        read_bytes(Path(tmp_path / path))


def test_what_is_larger_than_the_limit_is_not_read(tmp_path):
    path = tmp_path / "sparse"
    with path.open("wb") as stream:
        stream.truncate(10**12)  # takes no room on the disk
    with pytest.raises(
        InvalidFile, match="sparse has 1000000000000 bytes; give a file with at most 200000000 bytes"
    ):
        read_bytes(path)


def test_of_what_never_ends_no_more_than_the_limit_is_read():
    with pytest.raises(InvalidFile, match=r"/dev/zero has .* at most 3000000 bytes"):
        read_bytes(Path("/dev/zero"), 3_000_000)


def test_file_and_folder_are_on_the_disk_before_saving_ends(tmp_path, monkeypatch):
    settled = []
    fsync = os.fsync

    def note(descriptor):
        settled.append(
            (stat.S_ISDIR(os.fstat(descriptor).st_mode), sorted(p.name for p in tmp_path.iterdir()))
        )
        fsync(descriptor)

    monkeypatch.setattr(os, "fsync", note)
    write_bytes(tmp_path / "a", b"content")
    (first_is_folder, before), (second_is_folder, after) = settled
    assert (first_is_folder, second_is_folder) == (False, True)
    assert "a" not in before
    assert after == ["a"]


def test_a_digest_tells_whether_a_file_is_the_same(tmp_path):
    path = tmp_path / "a"
    assert digest_of(path) is digest_of(tmp_path) is None
    path.write_bytes(b"one")
    first = digest_of(path)
    path.write_bytes(b"two")
    assert digest_of(path) not in (first, None)
    path.write_bytes(b"one")
    assert digest_of(path) == first
