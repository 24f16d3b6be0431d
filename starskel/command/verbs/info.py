"""starskel info: what a file holds."""

import sys
from argparse import Namespace
from pathlib import Path

import msgspec

from starskel.command import FAILED
from starskel.command.holdings import check_texts, holdings
from starskel.errors import StarskelError
from starskel.files.documents import document_text
from starskel.reading.named_shape import NamedShape
from starskel.sheet.words import counted

FORMAT = "starskel-info/1"


class Held(msgspec.Struct, frozen=True):
    """A shape of a file; box is left, bottom, right, top."""

    name: str
    parts: int
    holes: int
    vertices: int
    area: float
    box: list[float]
    repairs: list[str]

    @classmethod
    def of(cls, named: NamedShape) -> "Held":
        """Take over what can be written as numbers."""
        shape = named.shape
        points = [ring.vertices for ring in shape.rings]
        low = [min(float(ring[:, axis].min()) for ring in points) for axis in (0, 1)]
        high = [max(float(ring[:, axis].max()) for ring in points) for axis in (0, 1)]
        parts, count = len(shape.outlines), sum(map(len, shape.rings))
        return cls(named.name, parts, len(shape) - parts, count, shape.area, low + high, list(named.repairs))


class _File(msgspec.Struct, frozen=True):
    path: str
    kind: str
    shapes: list[Held]
    notes: list[str]


class _Failure(msgspec.Struct, frozen=True):
    path: str
    error: str


class _Document(msgspec.Struct, frozen=True):
    format: str
    files: list[_File]
    failures: list[_Failure]


def run(arguments: Namespace) -> int:
    """Say what each file holds; those that cannot be read are named, the others go on."""
    check_texts(arguments.files, arguments.text)
    files: list[_File] = []
    failures: list[_Failure] = []
    for path in arguments.files:
        try:
            files.append(_file(path, arguments.text))
        except StarskelError as error:
            print(f"starskel: {error}", file=sys.stderr)
            failures.append(_Failure(str(path), str(error)))
            continue
        if not arguments.json:
            _print(files[-1])
    if arguments.json:
        print(document_text(_Document(FORMAT, files, failures)), end="")
    return FAILED if failures else 0


def _file(path: Path, texts: list[str]) -> _File:
    held = holdings(path, texts=texts)
    return _File(str(path), held.kind, [Held.of(named) for named in held.shapes], list(held.notes))


def _print(file: _File) -> None:
    print(f"{file.path}: {file.kind}, {counted(len(file.shapes), 'shape')}")
    width = max((len(held.name) for held in file.shapes), default=0)
    for held in file.shapes:
        holes = f", {counted(held.holes, 'hole')}" if held.holes else ""
        parts = f"{counted(held.parts, 'part')}, " if held.parts > 1 else ""
        left, bottom, right, top = held.box
        size = f"{right - left:.4g} x {top - bottom:.4g}"
        print(f"  {held.name:{width}}  {parts}{held.vertices} vertices{holes}, {size}, area {held.area:.4g}")
        for repair in held.repairs:
            print(f"  {'':{width}}  mended: {repair}")
    for note in file.notes:
        print(f"  {note}")
