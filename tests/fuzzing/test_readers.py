"""Broken files of every kind: only errors of the library's own come of them, and no warning."""

import contextlib
import re
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from starskel import InvalidFile, StarskelError
from tests.fuzzing.mutations import broken
from tests.fuzzing.readers import READERS, ROOT, Reader


@pytest.mark.parametrize("reader", READERS.values(), ids=READERS)
def test_valid_files_are_read(reader: Reader) -> None:
    seeds = reader.seeds()
    assert seeds
    assert all(reader.read(seed) is not None for seed in seeds)


@pytest.mark.parametrize("reader", READERS.values(), ids=READERS)
@settings(max_examples=40, derandomize=True, database=None, suppress_health_check=[HealthCheck.too_slow])
@given(data=st.data())
def test_broken_files_are_read_or_refused(reader: Reader, data: st.DataObject) -> None:
    with contextlib.suppress(StarskelError):
        reader.read(data.draw(broken(reader.seeds())))


@pytest.mark.parametrize("reader", READERS.values(), ids=READERS)
def test_files_cut_off_anywhere_are_read_or_refused(reader: Reader) -> None:
    refused = 0
    for seed in map(bytes, reader.seeds()):
        for end in range(0, len(seed), 37):
            try:
                reader.read(seed[:end])
            except StarskelError as error:
                assert isinstance(error, InvalidFile), error  # noqa: PT017 (not all of them raise)
                refused += 1
    assert refused


FOUND = sorted((ROOT / "tests" / "files" / "broken").iterdir())


@pytest.mark.parametrize("path", FOUND, ids=[path.name for path in FOUND])
def test_what_was_found_stays_mended(path: Path) -> None:
    with contextlib.suppress(StarskelError):
        READERS[path.suffix.removeprefix(".")].read(path.read_bytes())


def test_fuzzing_tells_what_came_of_the_inputs() -> None:
    command = [sys.executable, "-m", "tests.fuzzing", "wkt", "--examples", "30"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    told = re.fullmatch(r"wkt: (\d+) read, (\d+) refused, longest .* s, peak .* MB\n", done.stdout)
    assert told, done.stdout
    assert sum(map(int, told.groups())) == 30
