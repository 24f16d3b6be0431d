"""For all tests: the pairs of tests/shapes as fixtures; no deadline for the examples of hypothesis."""

from pathlib import Path

import pytest
from hypothesis import settings

from starskel.files.pair_file import PairFile
from starskel.files.pairs import ShapePair, read_pairs

settings.register_profile("patient", deadline=None)  # a busy machine is no fault
settings.load_profile("patient")

FILES: dict[str, PairFile[ShapePair]] = {
    pair_id: file
    for file in map(read_pairs, sorted(Path(__file__).parent.glob("shapes/*.json")))
    for pair_id in file.ids
}


@pytest.fixture(scope="session")
def shape_pairs() -> dict[str, ShapePair]:
    """All pairs of tests/shapes, by name."""
    return {pair_id: file.pair(pair_id) for pair_id, file in FILES.items()}


@pytest.fixture(params=list(FILES))
def shape_pair(request: pytest.FixtureRequest, shape_pairs: dict[str, ShapePair]) -> ShapePair:
    """Each pair of tests/shapes in turn."""
    return shape_pairs[request.param]
