"""The command that opens the editor."""

import sys
from pathlib import Path

import pytest

from app.__main__ import main
from app.view import start


def test_a_file_is_named_as_a_whole_so_that_what_is_said_of_it_can_be_understood(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    given: list[Path | None] = []
    monkeypatch.setattr(start, "run", given.append)
    monkeypatch.chdir(tmp_path)
    for arguments in (["a/../b.json"], []):
        monkeypatch.setattr(sys, "argv", ["starskel-editor", *arguments])
        main()
    assert given == [tmp_path / "b.json", None]
