"""Drawings meant to take time or memory without end: refused in little memory, naming limit and value."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from starskel.errors import InvalidFile
from starskel.reading.readers import read_content

Call = Callable[..., Any]

SVG = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink">{}</svg>'
PATH = '<path id="a0" d="M0 0H9V9H0Z"/>'
TEN_TIMES = '<use href="#a{}"/>' * 10
TWICE = "".join('<g id="a{}">{}</g>'.format(k, TEN_TIMES.replace("{}", str(k - 1))) for k in range(1, 12))
TANGLE = " ".join(f"{x:.3f} {y:.3f}" for x, y in np.random.default_rng(0).random((3000, 2)) * 1000)
POINTS = TANGLE.split()
CLOSED = ", ".join(map(" ".join, zip([*POINTS[::2], POINTS[0]], [*POINTS[1::2], POINTS[1]], strict=True)))
STROKED = f'<path d="M{TANGLE}" fill="none" stroke="black"/>'
NESTED = "".join(f"M-{k}-{k}H{k}V{k}H-{k}z" for k in range(1, 500))
ZIGZAG = "".join(f"L{k + 30000} 30000L{k + 1} 1" for k in range(6000))
CROSSED = "M0 0" + "".join(f"L{1000 * (k % 2)} {13 * k % 1000}" for k in range(130)) + "z"
MANY = "".join(f'<path d="{CROSSED}"/>' for _ in range(200))
BOW = "POLYGON ((" + ", ".join(f"{1000 * (k % 2)} {13 * k % 1000}" for k in range(99)) + ", 0 0))\n"
TRIANGLES = ", ".join(f"(({k} 0, {k + 1} 0, {k} 1, {k} 0))" for k in range(0, 2800, 2))
POINT = b'{"type":"Feature","geometry":{"type":"Point","coordinates":[1,2]}}'
POINTS_OF_A_MAP = b'{"type":"FeatureCollection","features":[' + b",".join([POINT] * 2001) + b"]}"


@pytest.mark.parametrize(
    ("inside", "why"),
    [
        (
            PATH + TWICE + '<use href="#a11"/>',
            "has [0-9]+ elements and subpaths; give a file with at most 2000",
        ),
        ('<g id="a"><use xlink:href="#a"/></g>', "nested too deeply, or uses itself"),
        ('<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>', "nested too deeply"),
        ("<g>" * 50_000 + PATH + "</g>" * 50_000, "nested too deeply"),
        (PATH * 11_000, "has 11002 elements and subpaths; give a file with at most 2000"),
        (PATH * 200_000, "tags; give a file with at most 500000"),
        (f'<path d="M0 0{"h1" * 160_000}"/>', "has 140001 numbers; give a file with at most 140000"),
        (f'<path d="M{TANGLE}Z"/>', "crossings; give a file with at most 5000"),
        (STROKED, "crossings; give a file with at most 5000"),
        (f'<path d="M0 0{"l1 1" * 900_000}"/>', "36[0-9]+ letters; give a file with at most 3000000"),
        (f'<path id="{"a" * 3_000_001}"/>', "30000[0-9]+ letters; give a file with at most 3000000"),
        (f'<g transform="{"scale(2)" * 900}">{PATH * 900}</g>', "letters; give a file with at most"),
        (f'<path d="{"M0 0h1v1z" * 2001}"/>', "2003 elements and subpaths; give a file with at most 2000"),
        (f'<path d="{NESTED}"/>', "overlapping parts; give a file with at most 100000"),
        (f'<path d="M0 0{ZIGZAG}L20000 -5z"/>', "edges beside each other; give a file with at most 2000000"),
        (MANY, "the file has [0-9]+ rings; give a file with at most 3000"),
        ("<style>" + "a{b:c}" * 2001 + "</style>", "2001 rules; give a file with at most 2000"),
        (" " * 20_000_001, "bytes; give a file with at most 20000000"),
        ('<path d="M0 0H1e308V1e308H-1e308Z"/>', "holds no shape"),
    ],
    ids=[str(k) for k in range(19)],
)
def test_a_drawing_beyond_a_limit_is_refused_naming_it(inside: str, why: str, in_little_memory: Call) -> None:
    with pytest.raises(InvalidFile, match=why):
        in_little_memory(read_content, SVG.format(inside).encode(), Path("a.svg"))


@pytest.mark.parametrize("style", ["a" * 300_000, "a" * 100_000 + "{}", "a{" * 1_900, "a{b" + " " * 100_000])
def test_style_sheets_on_which_patterns_would_be_tried_without_end_are_passed_over(
    style: str, in_little_memory: Call
) -> None:
    reading = in_little_memory(
        read_content, SVG.format(f"<style>{style}</style>{PATH}").encode(), Path("a.svg")
    )
    assert len(reading.shapes) == 1


def test_what_is_not_drawn_counts_for_nothing(in_little_memory: Call) -> None:
    aside = "".join(f' data-{k}="{k}"' for k in range(3000))
    inside = f"<g {aside}>{PATH}</g><text>{'a' * 4_000_000}</text>"
    picture = f'<image href="data:image/png;base64,{"A" * 4_000_000}"/>'
    reading = in_little_memory(read_content, SVG.format(inside + picture).encode(), Path("a.svg"))
    assert len(reading.shapes) == 1
    assert len(reading.notes) == 2


def test_an_unknown_encoding_is_a_damaged_file(in_little_memory: Call) -> None:
    content = b'<?xml version="1.0" encoding="rot13"?>' + SVG.format(PATH).encode()
    with pytest.raises(InvalidFile, match="damaged"):
        in_little_memory(read_content, content, Path("a.svg"))


@pytest.mark.parametrize(
    ("content", "path", "why"),
    [
        (
            b"GEOMETRYCOLLECTION(" * 100_000 + b")" * 100_000,
            "a.wkt",
            "nested brackets; give a file with at most",
        ),
        (b"POLYGON((" + b"1 1," * 300_000, "a.wkt", "300000 vertices; give a file with at most 250000"),
        (
            b"POLYGON((" + b",".join(b"%d %d" % (k, k * k) for k in range(100_002)) + b",0 0))",
            "a.wkt",
            "a ring has [0-9]+ vertices; give a file with at most 100000",
        ),
        (b'{"type":["Polygon"]}', "a.geojson", "damaged"),
        (b'{"type":"FeatureCollection","features":7}', "a.geojson", "damaged"),
        (b'{"type":"FeatureCollection","features":[' + b"0," * 800_000, "a.geojson", "values; give a file"),
        (b"A" * 14_000_000, "a.wkt", "is no WKT"),
        (b" " * 14_000_000, "a.wkt", "is no WKT"),
        (b"POINT (1 1)) " * 9, "a.wkt", "is no WKT|damaged"),
        (b"EMPTY " * 800_000, "a.wkt", "750001 words; give a file with at most 750000"),
        (b"POINT (1 1)\n" * 2001, "a.wkt", "2001 shapes; give a file with at most 2000"),
        (b"()" * 250_001, "a.wkt", "250001 brackets; give a file with at most 250000"),
        (b"GEOMETRYCOLLECTION (CIRCULARSTRING (0 0, 1 1, 2 0))", "a.wkt", "holds no shape"),
        (BOW.encode() * 900, "a.wkt", "the file has [0-9]+ crossings; give a file with at most 5000"),
        (
            f"MULTIPOLYGON ({TRIANGLES})\n".encode() * 3,
            "a.wkt",
            "the file has 4200 rings; give a file with at most",
        ),
        (POINTS_OF_A_MAP, "a.geojson", "2001 shapes; give a file with at most 2000"),
    ],
    ids=[str(k) for k in range(16)],
)
def test_maps_beyond_a_limit_or_of_other_things_are_refused(
    content: bytes, path: str, why: str, in_little_memory: Call
) -> None:
    with pytest.raises(InvalidFile, match=why):
        in_little_memory(read_content, content, Path(path))


@pytest.mark.parametrize(
    ("coordinates", "why"),
    [
        ("0 0, 1e308 0, 1e308 1e308, 0 0", "beyond all numbers"),
        ("0 0, 1e400 0, 1 1, 0 0", "beyond all numbers"),
        ("0 0, nan 0, 1 1, 0 0", "beyond all numbers"),
        ("0 0, inf -inf, 1 1, 0 0", "beyond all numbers"),
        (CLOSED, "crossings; give a file with at most 5000"),
    ],
    ids=[str(k) for k in range(5)],
)
def test_areas_beyond_all_numbers_and_tangles_are_refused(
    coordinates: str, why: str, in_little_memory: Call
) -> None:
    with pytest.raises(InvalidFile, match=why):
        in_little_memory(read_content, f"POLYGON(({coordinates}))".encode(), Path("a.wkt"))
