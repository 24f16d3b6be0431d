"""Files of pairs of pictures, format image-pairs/1: outlines in pixels, y down, and PNG files beside them."""

import os
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path, PureWindowsPath

import msgspec

from starskel.correspondence.marks import Mark
from starskel.errors import InvalidFile, told
from starskel.files.disk import read_bytes
from starskel.files.documents import check_format, read_document
from starskel.files.pair_file import IMAGE_PAIRS, PairFile
from starskel.files.pairs import ShapePair
from starskel.files.projects.picture import Picture
from starskel.files.projects.project import Project, letter
from starskel.files.raster import decoded, image_of
from starskel.files.shapes import Row, marked_shapes, polygon_of
from starskel.images.placed import PlacedImage
from starskel.limits import PICTURE_BYTES, Tally
from starskel.polygon import Polygon

FORMAT = IMAGE_PAIRS


class _Side(msgspec.Struct, frozen=True):
    image: str
    outline: list[Row]
    name: str = ""


class _Entry(msgspec.Struct, frozen=True, kw_only=True):
    id: str
    p: _Side
    q: _Side
    marks: list[Mark] = []


class _Document(msgspec.Struct, frozen=True):
    format: str
    pairs: list[_Entry]


@dataclass(frozen=True, eq=False)
class ImagePair:
    """Two shapes with their marks, and the pictures in them.

    Attributes
    ----------
    shapes : ShapePair
    source, target : PlacedImage
    contents : (bytes, bytes)
        The files of these pictures.
    """

    shapes: ShapePair
    source: PlacedImage
    target: PlacedImage
    contents: tuple[bytes, bytes]

    @property
    def project(self) -> Project:
        """The pair as a project of one step, the pictures behind its shapes."""
        project = Project.of(self.shapes)
        sides = zip(project.shapes, (self.source, self.target), self.contents, strict=True)
        shapes = tuple(replace(shape, picture=_picture(image, content)) for shape, image, content in sides)
        return replace(project, shapes=shapes)


def read_image_pairs(path: Path) -> PairFile[ImagePair]:
    """Read a file of pairs of pictures.

    Raises
    ------
    InvalidFile
        If it cannot be read, is no such file, or has no pair or two pairs of one name.
    """
    check_format(path, FORMAT)
    return PairFile(path, read_document(path, _Document).pairs, partial(_checked, path))


def _checked(path: Path, entry: _Entry) -> ImagePair:
    """Make a pair: a pixel is a unit, the origin is the lower left corner of each picture."""
    where = told('{path}: pair "{name}"', path=path, name=entry.id)
    first = _side(path, entry.p, told("{where}: {what}", where=where, what=told("source (p)")))
    second = _side(path, entry.q, told("{where}: {what}", where=where, what=told("target (q)")))
    source, target, marks = marked_shapes(first[1], second[1], entry.marks, where)
    contents = first[2], second[2]
    return ImagePair(ShapePair(entry.id, source, target, marks), first[0], second[0], contents)


def _side(path: Path, side: _Side, where: str) -> tuple[PlacedImage, Polygon, bytes]:
    beside = _beside(path, side.image, where)
    content = read_bytes(beside, PICTURE_BYTES)
    found = decoded(content, str(beside))
    rows = [(x, found.size[1] - y) for x, y in side.outline]
    return found.placed, polygon_of(rows, where, Tally(where)), content


def _beside(path: Path, name: str, where: str) -> Path:
    """Give the picture of this name; a link may lead to another place in the folder, but not out of it."""
    folder, beside = path.parent.resolve(), path.parent / name
    windows = PureWindowsPath(name)  # its names mean something else there
    if "\0" in name or windows.anchor or ".." in windows.parts or "\\" in name:
        raise _outside(name, where)
    if not beside.resolve().is_relative_to(folder):
        raise _outside(name, where)
    if os.path.exists(beside) and not os.path.isfile(beside):  # a pipe would let everybody wait
        raise InvalidFile(
            told('{where}: "{name}" is no file', where=where, name=name), told("give the name of a picture")
        )
    return beside


def _outside(name: str, where: str) -> InvalidFile:
    return InvalidFile(
        told('{where}: the picture "{name}" is not in the folder of the file', where=where, name=name),
        told("put it beside the file and give its name alone"),
    )


def _picture(image: PlacedImage, content: bytes) -> Picture:
    right, up = image.to_document((image.pixels.shape[1], 0)).tolist()
    return Picture(content, (right / 2, up / 2), (right, up))


def picture_of(path: Path, project: Project, shape: int) -> PlacedImage | None:
    """Give the picture behind a key shape of a project, by its number; None where there is none.

    Raises
    ------
    InvalidFile
        If it is damaged or too large.
    """
    picture = project.shapes[shape].picture
    if picture is None:
        return None
    return placed_image(
        picture, told("{path}: the picture of shape {letter}", path=path, letter=letter(shape))
    )


def placed_image(picture: Picture, name: str = "the picture") -> PlacedImage:
    """Give a picture of a project as pixels in their place.

    Raises
    ------
    InvalidFile
        If it is damaged or too large; `name` is what errors call it.
    """
    pixels = image_of(picture.content, name)
    return PlacedImage.in_box(pixels, picture.middle, picture.size, picture.rotation)
