"""Documents and pictures meant to take memory without end: refused in little memory, naming the limit."""

import io
import json
import struct
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from starskel.errors import InvalidFile
from starskel.files.projects.project_file import read_project
from starskel.files.raster import image_of, read_image
from tests.fuzzing.readers import READERS

Call = Callable[..., Any]

TRIANGLE = [[0, 0], [1, 0], [0, 1]]
PART = {"name": "", "colour": "", "visible": True}
STEP = {"duration": 1.0, "easing": [[0.3, 0.3], [0.6, 0.6]], "turns": 0, "joined": True, "links": []}
ZIGZAG = [[0, 0], *([x, y] for k in range(1900) for x, y in ((k + 30000, 30000), (k + 1, 1))), [60000, -5]]


def project(*parts: list[list[float]]) -> dict[str, Any]:
    shapes = [{"picture": None, "parts": [PART | {"ring": ring} for ring in parts]}]
    about = {"format": "starskel-project", "version": 4, "name": "", "methods": [], "steps": [STEP]}
    return about | {"shapes": [*shapes, {"picture": None, "parts": []}]}


def pairs(*rings: object, kind: str = "polygon-pairs/1") -> dict[str, Any]:
    return {"format": kind, "pairs": [{"id": "a", "p": rings[0], "q": rings[-1]}]}


MANY = [[[3 * k, 0], [3 * k + 1, 0], [3 * k, 1]] for k in range(20_001)]
LONG = [[k, 0] for k in range(100_001)]
DOCUMENTS = [
    ("project", project(*MANY), "has 20001 rings; give a file with at most 20000 rings"),
    ("project", project(LONG), "shape A has 100001 vertices; give a file with at most 100000"),
    ("project", project(ZIGZAG), "edges beside each other; give a file with at most 2000000"),
    ("pairs", pairs(LONG, TRIANGLE), r"source \(p\) has 100001 vertices; give a file with at most"),
    ("pairs", pairs(TRIANGLE, ZIGZAG), "edges beside each other; give a file with at most"),
    (
        "multi-pairs",
        pairs(MANY, [TRIANGLE], kind="polygon-multi-pairs/1"),
        "20002 rings; give a file with at most 20000",
    ),
    (
        "multi-pairs",
        pairs([ZIGZAG], [TRIANGLE], kind="polygon-multi-pairs/1"),
        "edges beside each other; give a file",
    ),
]


@pytest.mark.parametrize(("kind", "document", "why"), DOCUMENTS, ids=[str(k) for k in range(len(DOCUMENTS))])
def test_documents_beyond_a_limit_are_refused_naming_it(
    kind: str, document: dict[str, Any], why: str, in_little_memory: Call
) -> None:
    with pytest.raises(InvalidFile, match=why):
        in_little_memory(READERS[kind].read, json.dumps(document).encode())


@pytest.mark.parametrize("kind", ["project", "pairs", "multi-pairs"])
@pytest.mark.parametrize(
    ("content", "why"),
    [
        ('{"a":' + "[" * 1_000_000, "damaged: maximum recursion depth exceeded"),
        ('{"format":"","a":' + '{"a":' * 400_000 + "0" + "}" * 400_001, "maximum recursion depth exceeded"),
        ("[" + "0," * 3_000_000 + "0]", "has 3000001 values; give a file with at most 3000000 values"),
        ('{"format":"' + "a" * 30_000_000 + '"}', 'has the format "a{500} … a{500}"; give a file'),
    ],
    ids=["deep", "deep objects", "wide", "long"],
)
def test_documents_without_end_are_refused(kind: str, content: str, why: str, in_little_memory: Call) -> None:
    with pytest.raises(InvalidFile, match=why):
        in_little_memory(READERS[kind].read, content.encode())


def chunk(name: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))


def png(width: int, height: int, *chunks: bytes, pixels: bytes = b"") -> bytes:
    head = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
    return b"\x89PNG\r\n\x1a\n" + head + b"".join(chunks) + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")


def saved(width: int, height: int, kind: str) -> bytes:
    stream = io.BytesIO()
    Image.new("1", (width, height)).save(stream, kind)
    return stream.getvalue()


def with_size(content: bytes, old: bytes, new: bytes) -> bytes:
    assert content.count(old) == 1
    return content.replace(old, new)


SMALL = {kind: saved(1234, 2345, kind) for kind in ("GIF", "BMP", "JPEG")}
BOMB = zlib.compress(bytes(300_000_000), 9)
PICTURES = {
    "png of 100,000 a side": (png(100_000, 100_000), "too many pixels: 10000000000"),
    "png that swells": (
        saved(16_000, 16_000, "PNG"),
        "too many pixels: 256000000; .*at most [0-9]+ pixels",
    ),
    "png with a text that swells": (png(9, 9, chunk(b"zTXt", b"a\0\0" + BOMB)), "damaged"),
    "png with a profile that swells": (png(9, 9, chunk(b"iCCP", b"a\0\0" + BOMB)), "damaged"),
    "gif": (
        with_size(SMALL["GIF"], b"GIF87a" + struct.pack("<HH", 1234, 2345), b"GIF87a" + b"\xff" * 4),
        "too many pixels: 4294836225",
    ),
    "jpeg": (
        with_size(SMALL["JPEG"], struct.pack(">HH", 2345, 1234), b"\xff\xdc" * 2),
        "too many pixels: 4290250000",
    ),
    "bmp": (
        with_size(SMALL["BMP"], struct.pack("<ii", 1234, 2345), struct.pack("<ii", 100_000, 100_000)),
        "too many pixels: 10000000000",
    ),
    "much too wide": (png(16_385, 1), "too many pixels: 16385 × 1; .*16384 a side"),
}


@pytest.mark.parametrize(("content", "why"), PICTURES.values(), ids=PICTURES)
def test_pictures_that_swell_are_refused(content: bytes, why: str, in_little_memory: Call) -> None:
    with pytest.raises(InvalidFile, match=why):
        in_little_memory(image_of, content)


def test_a_file_without_end_is_refused(in_little_memory: Call, tmp_path: Path) -> None:
    sparse = tmp_path / "sparse.json"
    with sparse.open("wb") as stream:
        stream.truncate(1 << 40)
    for read in (read_project, read_image):
        with pytest.raises(InvalidFile, match="has 1099511627776 bytes; give a file with at most 200000000"):
            in_little_memory(read, sparse)


def test_what_takes_more_fails_there_and_the_next_does_not(in_little_memory: Call) -> None:
    with pytest.raises(MemoryError):
        in_little_memory(bytes, 200_000_000)
    assert in_little_memory(len, b"ab") == 2
