import pytest

from starskel.files.documents import document_text


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ([[1, 2.5], [3, 4]], "[\n  [1, 2.5],\n  [3, 4]\n]"),
        (([1.0, 1e-300], (None, True)), "[\n  [1.0, 1e-300],\n  [null, true]\n]"),
        ([[1], []], "[\n  [1],\n  []\n]"),
        ([[1, [2]], 3], "[\n  [\n    1,\n    [2]\n  ],\n  3\n]"),
        ([[1, "],["], [2]], '[\n  [1, "],["],\n  [2]\n]'),
        ([[1, {}], [2]], "[\n  [\n    1,\n    {}\n  ],\n  [2]\n]"),
        ([["a", 1], ["b", 2]], '[\n  ["a", 1],\n  ["b", 2]\n]'),
        ([[[1, 2], [3, 4]], [[5, 6]]], None),
        ([1, [2, 3]], "[\n  1,\n  [2, 3]\n]"),
        ({"a": [[1, 2]], "b": []}, '{\n  "a": [\n    [1, 2]\n  ],\n  "b": []\n}'),
    ],
)
def test_rows_of_numbers_stand_on_one_line_each(value, text):
    text = text or "[\n  [\n    [1, 2],\n    [3, 4]\n  ],\n  [\n    [5, 6]\n  ]\n]"
    assert document_text(value) == text + "\n"
