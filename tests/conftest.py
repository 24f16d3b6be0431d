"""Fixtures for all tests: the pairs of tests/shapes."""

from pathlib import Path

import pytest

from starskel.files.pairs import PairsFile, ShapePair, read_pairs

FILES: dict[str, PairsFile] = {
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
