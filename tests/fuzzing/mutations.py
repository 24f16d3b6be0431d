"""Broken files, made of valid ones step by step, as hypothesis chooses, which shortens them."""

import re
from collections.abc import Sequence
from random import Random

from hypothesis import strategies as st

_NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")

WORDS = (
    *(b"1e308", b"-1e308", b"1e400", b"1e-320", b"nan", b"NaN", b"Infinity", b"-0", b"0", b"9" * 40),
    *(b"null", b"true", b'""', b"[]", b"{}", b"[[[[[[", b"-1", b"4294967296", b"18446744073709551616"),
    *(b"\x00", b"\xff\xfe", b"\xed\xa0\x80", b"../../etc/passwd", b"<!--", b"]]>", b"&#0;", b"(((", b"EMPTY"),
)
"""What is put in the place of numbers, and anywhere."""

_LONGEST = 200

_KINDS = ("flip", "cut", "drop", "repeat", "copy", "word", "random", "number", "number", "number")

_step = st.tuples(
    st.sampled_from(_KINDS),
    st.floats(0, 1),
    st.floats(0, 1),
    st.integers(0, 2**16 - 1),
)


def broken(seeds: Sequence[bytes]) -> st.SearchStrategy[bytes]:
    """Give files that come from these by one to five steps."""
    return st.builds(_mutated, st.sampled_from(list(seeds)), st.lists(_step, min_size=1, max_size=5))


def broken_once(content: bytes, numbers: Random) -> bytes:
    """Change a file by one step, of random numbers."""
    step = numbers.choice(_KINDS), numbers.random(), numbers.random(), numbers.randrange(2**16)
    return _changed(content, *step)


def _mutated(content: bytes, steps: Sequence[tuple[str, float, float, int]]) -> bytes:
    for kind, place, other, value in steps:
        content = _changed(content, kind, place, other, value)
    return content


def _changed(content: bytes, kind: str, place: float, other: float, value: int) -> bytes:
    at, length = int(place * len(content)), 1 + value % _LONGEST
    before, here, after = content[:at], content[at : at + length], content[at + length :]
    if kind == "number":
        return _with_number(content, place, WORDS[value % len(WORDS)])
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
