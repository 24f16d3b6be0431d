"""Files of pairs of shapes."""

import json
from pathlib import Path

import pytest

from starskel import InvalidFile
from starskel.files.multi_pairs import read_multi_pairs

MULTI = Path(__file__).parents[2] / "shapes" / "several" / "multi.json"
SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
SMALL = [[1, 1], [2, 1], [2, 2], [1, 2]]


def written(path: Path, **entry: object) -> Path:
    pair = {"id": "one", "p": [SQUARE], "q": [SQUARE], **entry}
    path.write_text(json.dumps({"format": "polygon-multi-pairs/1", "pairs": [pair]}))
    return path


def test_rings_inside_rings_are_holes():
    file = read_multi_pairs(MULTI)
    assert file.ids == ("m-i-j", "m-smile-frown", "m-Xi-identical", "m-arms-spread")
    face = file.pair("m-smile-frown")
    assert face.source.outer == face.target.outer == (-1, 0, -1, -1, -1)
    assert face.pairing == tuple((k, k) for k in range(5))
    assert len(face.marks) == 5


def test_a_pairing_and_places_may_be_given_and_else_are_proposed(tmp_path):
    given = written(
        tmp_path / "a.json",
        p=[SQUARE, SMALL],
        pairing=[[0, 0], [1, None]],
        places=[{"pair": [1, None], "at": [3, 3]}],
    )
    pair = read_multi_pairs(given).pair("one")
    assert pair.pairing == ((0, 0), (1, None))
    assert pair.places == {(1, None): (3, 3)}
    assert read_multi_pairs(written(tmp_path / "b.json", p=[SQUARE, SMALL])).pair("one").pairing == (
        (0, 0),
        (1, None),
    )


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ({"p": []}, r"source \(p\): a shape without rings"),
        ({"q": [SQUARE, SQUARE[::2] + SQUARE[1::2]]}, r"target \(q\): ring 1: edges"),
        ({"pairing": [[0, 1]]}, "pairing: the pairing names ring 1 of the target"),
    ],
)
def test_faults_are_named_with_the_file_and_the_pair(tmp_path, entry, message):
    path = written(tmp_path / "bad.json", **entry)
    with pytest.raises(InvalidFile, match=message) as caught:
        read_multi_pairs(path).pair("one")
    assert str(path) in str(caught.value)
    with pytest.raises(InvalidFile, match='has no pair "two"; choose one of one'):
        read_multi_pairs(path).pair("two")
