"""Each reader as a function of a file's content, with small valid files to begin from."""

import base64
import io
import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import reportlab
import uharfbuzz
from PIL import Image

from app.model.filing import Filed
from app.recovery.record import Record, read_record, write_record
from starskel.files.documents import document_text
from starskel.files.image_pairs import read_image_pairs
from starskel.files.multi_pairs import read_multi_pairs
from starskel.files.pairs import read_pairs
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.picture import Picture
from starskel.files.projects.project import Project
from starskel.files.projects.project_file import project_content, read_project
from starskel.files.projects.step import Link, Step
from starskel.files.raster import image_of
from starskel.files.raster_writing import png_of
from starskel.polygon import Polygon
from starskel.reading.readers import read_content

ROOT = Path(__file__).parents[2]
FONT = Path(reportlab.__file__).parent / "fonts" / "Vera.ttf"
"""It comes with a library that the project stands on, so it is there wherever the tests run."""


PICTURE = "picture.png"
"""It lies beside each file."""


@dataclass(frozen=True)
class Reader:
    """A reader.

    Attributes
    ----------
    name : str
    seeds : callable
        Gives valid files, small ones.
    read : callable
        Reads all that there is in a file of this content.
    """

    name: str
    seeds: Callable[[], Sequence[bytes]]
    read: Callable[[bytes], object]


def _from_file(read: Callable[[Path], object], content: bytes) -> object:
    with TemporaryDirectory() as folder:
        path = Path(folder, "input.bin")
        path.write_bytes(content)
        path.with_name(PICTURE).write_bytes(png_of(_pixels()))
        return read(path)


def _all_pairs(read: Callable[[Path], object], path: Path) -> list[object]:
    file = read(path)
    return [file.pair(name) for name in file.ids]


def _projects() -> list[bytes]:
    examples = [ROOT / "resources" / "examples" / name for name in ("star.json", "letters-i-j.json")]
    old = [ROOT / "tests" / "files" / f"project-version-{number}.json" for number in (1, 2)]
    return [*(path.read_bytes() for path in (*examples, *old)), document_text(_drawn()).encode()]


def _drawn() -> dict[str, Any]:
    """Give a project with a picture and a hole, as it is written now."""
    outline, hole = Polygon([(0, 0), (9, 0), (9, 9), (0, 9)]), Polygon([(1, 1), (2, 1), (2, 2)])
    shape = KeyShape.of(outline, hole)
    drawn = replace(shape, picture=Picture(png_of(_pixels()), (4.0, 4.0), (24.0, 16.0)))
    return project_content(Project("drawn", (drawn, shape), (Step((Link(0, 0, ((0, 0),)), Link(1, 1))),)))


def _records() -> list[bytes]:
    with TemporaryDirectory() as folder:
        project = read_project(ROOT / "resources" / "examples" / "star.json")
        paths = [Path(folder, name) for name in ("a.json", "b.json")]
        write_record(paths[0], Record(project))
        write_record(paths[1], Record(project, Filed(Path(folder, "star.json"), "0" * 64)))
        return [path.read_bytes() for path in paths]


def _pairs() -> list[bytes]:
    square, other = [[0, 0], [4, 0], [4, 4], [0, 4]], [[0.5, 0], [4, 1e-3], [3, 3], [2, 2], [0, 4]]
    entries = [
        {"id": "one", "p": square, "q": other, "marks": [[0, 0], [2, 2]]},
        {"id": "two", "source": "drawn", "tags": ["a"], "p": other, "q": square, "marks": []},
    ]
    return [json.dumps({"format": "polygon-pairs/1", "pairs": entries[:count]}).encode() for count in (1, 2)]


def _multi_pairs() -> list[bytes]:
    square, small = [[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [2, 1], [2, 2], [1, 2]]
    entry = {
        "id": "one",
        "p": [square, small],
        "q": [square],
        "pairing": [[0, 0], [1, None]],
        "places": [{"pair": [1, None], "at": [3, 3]}],
    }
    return [json.dumps({"format": "polygon-multi-pairs/1", "pairs": [entry]}).encode()]


def _image_pairs() -> list[bytes]:
    side = {"image": PICTURE, "outline": [[5, 5], [5, 25], [25, 25], [25, 5]], "name": "a"}
    entry = {"id": "one", "p": side, "q": side, "marks": [[0, 0], [2, 2]]}
    return [json.dumps({"format": "image-pairs/1", "pairs": [entry]}).encode()]


def _drawings() -> list[bytes]:
    icons = sorted((ROOT / "tests" / "files" / "icons").rglob("*.svg"))[:6]
    styled = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10" width="2cm">
        <style>.a{fill:none;stroke:#f00;stroke-width:2}</style>
        <defs><symbol id="s"><circle r="3"/></symbol><path id="p" d="M0 0h5v5z"/></defs>
        <g transform="rotate(10) scale(2 -1)"><use href="#p" x="3"/><use href="#s"/>
        <path class="a" stroke-linejoin="round" d="M1 1C2 3 4 5 6 1S9 9 3 3Q1 2 3 4T7 7A3 2 10 1 0 8 8Z"/>
        <polygon points="0,0 4,0 4,4" fill-rule="evenodd"/><rect width="4" height="3" rx="1"/>
        <ellipse rx="4" ry="2"/><polyline points="1 1 2 2 3 1" stroke="blue"/></g></svg>"""
    return [*(icon.read_bytes() for icon in icons), styled.encode()]


def _maps() -> list[bytes]:
    ring, hole = [[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 1]]
    shapes = [
        {"type": "Polygon", "coordinates": [ring, hole]},
        {"type": "MultiPolygon", "coordinates": [[ring], [[[x + 20, y] for x, y in ring]]]},
        {"type": "LineString", "coordinates": ring},
        {"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [1, 2]}]},
    ]
    features = [{"type": "Feature", "properties": {"name": "a"}, "geometry": shape} for shape in shapes]
    return [
        json.dumps({"type": "FeatureCollection", "features": features}).encode(),
        json.dumps(shapes[0]).encode(),
    ]


def _texts() -> list[bytes]:
    return [
        b"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 1))",
        b"SRID=4326;MULTIPOLYGON (((0 0, 4 0, 4 4, 0 0)), ((10 0, 14 0, 14 4, 10 0)))\nPOINT EMPTY",
        b"LINESTRING Z (0 0 1, 3.5e0 0 1, 3 3 1)\nGEOMETRYCOLLECTION (POINT (1 1), POLYGON EMPTY)",
    ]


@cache
def _fonts() -> list[bytes]:
    wanted = uharfbuzz.SubsetInput()
    wanted.sets(uharfbuzz.SubsetInputSets.UNICODE).set(set(map(ord, "B8&il")))
    return [bytes(uharfbuzz.subset(uharfbuzz.Face(uharfbuzz.Blob(FONT.read_bytes())), wanted).blob.data)]


def _pixels() -> np.ndarray:
    x, y = np.meshgrid(np.arange(24), np.arange(16))
    seen = ((x - 12) ** 2 + (y - 8) ** 2 < 36) * 255
    return np.stack([255 - seen + x, 255 - seen, 255 - seen // 2, seen], axis=2).astype(np.uint8)


def _pictures() -> list[bytes]:
    image = Image.fromarray(_pixels())
    opaque = image.convert("RGB")
    kinds = {"PNG": image, "JPEG": opaque, "GIF": opaque.convert("P"), "WEBP": image, "BMP": opaque}
    deep = _saved(Image.fromarray(np.asarray(opaque.convert("L"), dtype=np.uint16) * 257), "PNG")
    return [deep, *(_saved(picture, kind) for kind, picture in kinds.items()), *_moving()]


def _moving() -> list[bytes]:
    frames = [Image.fromarray(np.roll(_pixels(), k, axis=1)) for k in range(3)]
    return [
        _saved(frames[0], kind, save_all=True, append_images=frames[1:]) for kind in ("GIF", "PNG", "WEBP")
    ]


def _saved(image: Image.Image, kind: str, **options: object) -> bytes:
    stream = io.BytesIO()
    image.save(stream, kind, **options)
    return stream.getvalue()


def _base64(content: bytes) -> str:
    return base64.b64encode(content).decode()


READERS = {
    reader.name: reader
    for reader in (
        Reader("project", _projects, partial(_from_file, read_project)),
        Reader("record", _records, partial(_from_file, read_record)),
        Reader("pairs", _pairs, partial(_from_file, partial(_all_pairs, read_pairs))),
        Reader("multi-pairs", _multi_pairs, partial(_from_file, partial(_all_pairs, read_multi_pairs))),
        Reader("image-pairs", _image_pairs, partial(_from_file, partial(_all_pairs, read_image_pairs))),
        Reader("svg", _drawings, partial(read_content, path=Path("input.svg"))),
        Reader("geojson", _maps, partial(read_content, path=Path("input.geojson"))),
        Reader("wkt", _texts, partial(read_content, path=Path("input.wkt"))),
        Reader("font", _fonts, partial(read_content, path=Path("input.ttf"))),
        Reader("silhouette", _pictures, partial(read_content, path=Path("input.png"))),
        Reader("picture", _pictures, image_of),
    )
}
"""By their names."""
