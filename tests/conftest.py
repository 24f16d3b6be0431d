"""For all tests: the pairs of tests/shapes; how long tests of endurance run; no deadline for hypothesis."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings

from starskel.files.pair_file import PairFile
from starskel.files.pairs import ShapePair, read_pairs
from tests.limited import Limited

settings.register_profile("patient", deadline=None)  # a busy machine is no fault
settings.load_profile("patient")

FILES: dict[str, PairFile[ShapePair]] = {
    pair_id: file
    for file in map(read_pairs, sorted(Path(__file__).parent.glob("shapes/*.json")))
    for pair_id in file.ids
}


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--endurance", action="store_true", help="run tests of endurance at full length")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "endurance(usual, long): how much of it is done, and at full length")


@pytest.fixture(scope="session")
def in_little_memory() -> Iterator[Limited]:
    """Call a function in a process that gets 128 MB for what it does."""
    limited = Limited(128 << 20)
    yield limited
    limited.end()


@pytest.fixture
def rounds(request: pytest.FixtureRequest) -> int:
    """How much a test of endurance does: what its mark says."""
    mark = request.node.get_closest_marker("endurance")
    return int(mark.kwargs["long" if request.config.getoption("--endurance") else "usual"])


@pytest.fixture(scope="session")
def shape_pairs() -> dict[str, ShapePair]:
    """All pairs of tests/shapes, by name."""
    return {pair_id: file.pair(pair_id) for pair_id, file in FILES.items()}


@pytest.fixture(params=list(FILES))
def shape_pair(request: pytest.FixtureRequest, shape_pairs: dict[str, ShapePair]) -> ShapePair:
    """Each pair of tests/shapes in turn."""
    return shape_pairs[request.param]
