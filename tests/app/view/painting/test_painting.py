import numpy as np
import pytest

from app.view.painting.drawing import CELL, FEW, ring_of


def test_a_ring_of_very_many_vertices_is_painted_with_those_that_can_be_told_apart() -> None:
    angles = np.linspace(0, 2 * np.pi, 100_000, endpoint=False)
    ring = 50 + 40 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    painted = np.array([point.toTuple() for point in ring_of(ring)])
    assert len(painted) < 10_000
    assert painted[0] == pytest.approx(ring[0])
    assert np.abs(np.hypot(*(painted - 50).T) - 40).max() < 1e-9, "vertices are left out, not moved"
    gaps = np.hypot(*(np.roll(painted, -1, axis=0) - painted).T)
    assert gaps.max() < 2 * CELL


@pytest.mark.parametrize("count", [0, 3, FEW])
def test_a_ring_of_few_vertices_is_painted_whole(count: int) -> None:
    ring = np.full((count, 2), 7.0)
    assert ring_of(ring).size() == count
