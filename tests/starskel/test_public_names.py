import subprocess
import sys

import pytest

import starskel

NAMES = {
    "Polygon",
    "Correspondence",
    "match",
    "suggest_marks",
    "decompose",
    "Decomposition",
    "blend",
    "METHODS",
    "measure",
    "Report",
    "StarskelError",
    "InvalidPolygon",
    "InvalidMarks",
    "NoDecomposition",
    "UnknownMethod",
    "InvalidFile",
    "Cancelled",
}


def test_the_public_names_are_there():
    assert set(starskel.__all__) >= NAMES
    for name in starskel.__all__:
        assert getattr(starskel, name) is not None
    assert dir(starskel) == sorted(starskel.__all__)


def test_other_names_are_missing():
    with pytest.raises(AttributeError, match="no attribute 'morph'"):
        starskel.morph  # noqa: B018 -- asking for it is the test


def test_importing_the_package_and_naming_the_methods_loads_no_numpy():
    code = "import sys, starskel; starskel.METHODS; print(*{'numpy', 'shapely'} & set(sys.modules))"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.strip() == ""


def test_the_whole_way_from_points_to_a_report():
    square, kite = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (3, 2), (1, 5), (0, 2)]
    pair = starskel.match(square, kite, marks=[(0, 0)])
    decomposition = starskel.decompose(pair)
    blend = starskel.blend(pair, method="stitched", decomposition=decomposition)
    assert blend.at(0.5).shape == (len(pair), 2)
    assert blend.frames([0, 0.5, 1]).shape == (3, len(pair), 2)
    assert blend.pair is pair
    assert blend.decomposition is decomposition
    assert starskel.measure(blend, frames=11).simple
