"""Broken files, made of valid ones step by step, as hypothesis chooses, which shortens them."""

import json
import re
from collections.abc import Iterator, Sequence
from random import Random
from typing import Any

from hypothesis import strategies as st

_NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")

WORDS = (
    *(b"1e308", b"-1e308", b"1e400", b"1e-320", b"nan", b"NaN", b"Infinity", b"-0", b"0", b"9" * 40),
    *(b"null", b"true", b'""', b"[]", b"{}", b"[[[[[[", b"-1", b"4294967296", b"18446744073709551616"),
    *(b"\x00", b"\xff\xfe", b"\xed\xa0\x80", b"../../etc/passwd", b"<!--", b"]]>", b"&#0;", b"(((", b"EMPTY"),
)
"""What is put in the place of numbers, and anywhere."""

VALUES = (
    *(None, True, False, "", "a", "../../x", "\0", [], {}, [[]], [None], {"": 0}, [0, 0], [[0, 0]] * 3),
    *(0, -1, 1, 2, 3, 0.25, -0.5, 2**31, 2**64, 1e-320, 1e308, -1e308),
)
"""What is put in the place of values of JSON."""

_LONGEST = 200

_ROUGH = ("flip", "cut", "drop", "repeat", "copy", "word", "random")
_FINE = ("number", "value")
"""Kinds of steps: after rough ones few files can be parsed, after fine ones most."""


def broken(seeds: Sequence[bytes]) -> st.SearchStrategy[bytes]:
    """Give files that come from these by one to five steps."""
    steps = _steps(_FINE) | _steps((*_ROUGH, *_FINE))
    return st.builds(_mutated, st.sampled_from(list(seeds)), steps)


def _steps(kinds: Sequence[str]) -> st.SearchStrategy[list[tuple[str, float, float, int]]]:
    step = st.tuples(st.sampled_from(kinds), st.floats(0, 1), st.floats(0, 1), st.integers(0, 2**16 - 1))
    return st.lists(step, min_size=1, max_size=5)


def broken_once(content: bytes, numbers: Random) -> bytes:
    """Change a file by one step, of random numbers."""
    step = numbers.choice((*_ROUGH, *_FINE * 3)), numbers.random(), numbers.random(), numbers.randrange(2**16)
    return _changed(content, *step)


def _mutated(content: bytes, steps: Sequence[tuple[str, float, float, int]]) -> bytes:
    for kind, place, other, value in steps:
        content = _changed(content, kind, place, other, value)
    return content


def _changed(content: bytes, kind: str, place: float, other: float, value: int) -> bytes:
    at, length = int(place * len(content)), 1 + value % _LONGEST
    before, here, after = content[:at], content[at : at + length], content[at + length :]
    if kind == "number":
        usual = f"{(value - 2**15) / 997:.4f}".encode()
        return _with_number(content, place, WORDS[value // 4 % len(WORDS)] if value % 4 == 0 else usual)
    if kind == "value":
        return _with_value(content, place, other, value)
    return {
        "flip": lambda: before + bytes([byte ^ 1 << value % 8 for byte in here[:1]]) + here[1:] + after,
        "cut": lambda: before,
        "drop": lambda: before + after,
        "repeat": lambda: before + here * (2 + value // _LONGEST % 60) + after,
        "copy": lambda: content[: (goal := int(other * len(content)))] + here + content[goal:],
        "word": lambda: before + WORDS[value % len(WORDS)] + content[at:],
        "random": lambda: before + value.to_bytes(2, "little") + content[at + 2 :],
    }[kind]()


def _with_number(content: bytes, place: float, word: bytes) -> bytes:
    numbers = list(_NUMBER.finditer(content))
    if not numbers:
        return content
    found = numbers[min(int(place * len(numbers)), len(numbers) - 1)]
    return content[: found.start()] + word + content[found.end() :]


def _with_value(content: bytes, place: float, other: float, value: int) -> bytes:
    """Put another value, one of the file's own by turns, in the place of a value of JSON, or leave it out."""
    try:
        document = json.loads(content)
    except (ValueError, RecursionError):
        return content
    nodes = list(_nodes(document))
    if not nodes:
        return content
    parent, key = nodes[int(place * (len(nodes) - 1))]
    giver, own = nodes[int(other * (len(nodes) - 1))]
    match value % 4:
        case 0:
            del parent[key]
        case 1:
            parent[key] = json.loads(json.dumps(giver[own]))
        case _:
            parent[key] = VALUES[value // 4 % len(VALUES)]
    return json.dumps(document).encode()


def _nodes(value: Any) -> Iterator[tuple[Any, Any]]:
    """Give all values inside a value of JSON, by what holds them and their place in it."""
    places = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in places:
        yield value, key
        yield from _nodes(inner)
