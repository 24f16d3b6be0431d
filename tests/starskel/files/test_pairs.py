import json

import pytest

from starskel.errors import InvalidFile, InvalidPolygon, StarskelError
from starskel.files.pairs import read_pairs, write_pairs

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
ENTRY = {"id": "one", "p": SQUARE, "q": SQUARE, "marks": [[0, 1]]}


def written(path, *entries, **header):
    path.write_text(json.dumps({"format": "polygon-pairs/1", "pairs": list(entries), **header}))
    return path


@pytest.fixture
def path(tmp_path):
    return tmp_path / "pairs.json"


def test_every_pair_comes_back_as_it_was_written(path, shape_pairs):
    write_pairs(path, shape_pairs.values())
    file = read_pairs(path)
    assert [file.pair(pair_id) for pair_id in file.ids] == list(shape_pairs.values())


def test_marks_follow_a_ring_that_is_turned_round(path):
    clockwise = SQUARE[::-1]
    pair = read_pairs(written(path, {**ENTRY, "p": clockwise, "marks": [[1, 2], [3, 0]]})).pair("one")
    for (i, j), (given_i, given_j) in zip(pair.marks, [[1, 2], [3, 0]], strict=True):
        assert pair.source.vertices[i].tolist() == clockwise[given_i]
        assert pair.source.vertex_of(i) == i  # also where the mark is taken for a row of the polygon given
        assert pair.target.vertices[j].tolist() == SQUARE[given_j]


def test_a_bad_pair_spoils_no_other(path):
    file = read_pairs(written(path, {**ENTRY, "id": "bad", "p": [[0, 0], [4, 4], [4, 0], [0, 4]]}, ENTRY))
    assert len(file.pair("one").source) == 4
    with pytest.raises(
        InvalidFile, match=r'pair "bad": source \(p\): edges 0-1 and 2-3 cross .* at \(2, 2\)'
    ) as caught:
        file.pair("bad")
    assert isinstance(caught.value.__cause__, InvalidPolygon)
    assert caught.value.__cause__.place == (2.0, 2.0)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"q": SQUARE[:2]}, r"target \(q\): a polygon of 2 points"),
        ({"p": [*SQUARE, [4, 4]]}, r"source \(p\): vertices 2 and 4 are both at"),
        (
            {"marks": [[0, 0], [4, 1]]},
            "mark 1 names vertex 4 of the source, which has 4; give a vertex from 0 to 3",
        ),
        ({"marks": [[0, 0], [0, 1]]}, "marks 0 and 1 both name vertex 0 of the source; remove one of them"),
        ({"marks": [[0, 0], [1, 2], [2, 1]]}, r"marks 0 .* come in one order round the source"),
        ({"marks": [[0, -1]]}, "mark 0 names vertex -1 of the target"),
    ],
)
def test_a_fault_in_a_pair_is_named_with_its_place(path, change, message):
    with pytest.raises(InvalidFile, match=f'pairs.json: pair "one": {message}'):
        read_pairs(written(path, {**ENTRY, **change})).pair("one")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"p": "square"}, r"Expected `array`, got `str` - at `\$.pairs\[0\].p`"),
        ({"p": [[0, 0, 0]]}, r"length 2 - at `\$.pairs\[0\].p\[0\]`"),
        ({"p": [[0, None]]}, r"got `null` - at `\$.pairs\[0\].p\[0\]\[1\]`"),
        ({"marks": [[0, 0.5]]}, r"Expected `int`, got `float` - at `\$.pairs\[0\].marks\[0\]\[1\]`"),
        ({"id": 7}, r"Expected `str`, got `int` - at `\$.pairs\[0\].id`"),
    ],
)
def test_wrong_types_are_named_with_their_place(path, change, message):
    with pytest.raises(InvalidFile, match=message):
        read_pairs(written(path, {**ENTRY, **change}))


@pytest.mark.parametrize("key", ["id", "p", "q"])
def test_a_missing_key_is_named(path, key):
    entry = {name: value for name, value in ENTRY.items() if name != key}
    with pytest.raises(InvalidFile, match=f"missing required field `{key}`"):
        read_pairs(written(path, entry))


def test_another_format_is_named(path):
    with pytest.raises(
        InvalidFile, match=r'has the format "polygon-multi-pairs/1"; give .* "polygon-pairs/1"'
    ):
        read_pairs(written(path, ENTRY, format="polygon-multi-pairs/1"))


def test_a_file_without_pairs_is_refused(path):
    with pytest.raises(InvalidFile, match="holds no pair"):
        read_pairs(written(path))


def test_two_pairs_of_one_name_are_refused(path):
    with pytest.raises(InvalidFile, match='two pairs "one"'):
        read_pairs(written(path, ENTRY, ENTRY))


def test_a_byte_order_mark_is_no_damage(path):
    written(path, ENTRY)
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())
    assert read_pairs(path).ids == ("one",)


@pytest.mark.parametrize(
    ("asked", "offered"),
    [("Arm", "arm-straight"), ("arm-strait", "arm-straight"), ("qqq", "one, arm-straight")],
)
def test_an_unknown_name_is_answered_with_near_ones(path, asked, offered):
    file = read_pairs(written(path, ENTRY, {**ENTRY, "id": "arm-straight"}))
    with pytest.raises(InvalidFile, match=f'has no pair "{asked}"; choose one of {offered}'):
        file.pair(asked)


def read_all(path):
    file = read_pairs(path)
    return [file.pair(pair_id) for pair_id in file.ids]


def test_a_truncated_file_is_an_invalid_file(path):
    whole = written(path, ENTRY).read_bytes()
    for length in range(len(whole)):
        path.write_bytes(whole[:length])
        with pytest.raises(InvalidFile):
            read_all(path)


def test_a_flipped_bit_is_harmless_or_an_invalid_file(path):
    whole = written(path, ENTRY).read_bytes()
    refused = 0
    for bit in range(8 * len(whole)):
        flipped = bytearray(whole)
        flipped[bit // 8] ^= 1 << bit % 8
        path.write_bytes(flipped)
        try:
            read_all(path)
        except StarskelError as error:
            assert type(error) is InvalidFile  # noqa: PT017 (most flips raise, but not all)
            refused += 1
    assert refused > 4 * len(whole)
