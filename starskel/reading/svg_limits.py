"""What an SVG file may hold: counted before anything is made of it, so that none takes time without end."""

import re
from itertools import islice
from typing import NamedTuple
from xml.etree import ElementTree

from starskel.errors import InvalidFile, told
from starskel.limits import (
    DEPTH,
    DRAWING_BYTES,
    DRAWING_LETTERS,
    DRAWING_NUMBERS,
    DRAWING_SHAPES,
    DRAWING_TAGS,
    check_limit,
)

_SPACE = "{http://www.w3.org/2000/svg}"
_TOKEN = re.compile(r"[A-Za-z]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_PATHS = ("d", "points")
_LINKS = ("href", "{http://www.w3.org/1999/xlink}href")

_DRAWING = {
    *(*_PATHS, *_LINKS, "id", "class", "style", "transform", "viewBox", "preserveAspectRatio", "version"),
    *("x", "y", "width", "height", "cx", "cy", "r", "rx", "ry", "x1", "y1", "x2", "y2"),
    *("fill", "fill-rule", "fill-opacity", "color", "opacity", "display", "visibility", "font-size"),
    *("stroke", "stroke-width", "stroke-opacity", "stroke-linecap", "stroke-linejoin", "vector-effect"),
}
"""The attributes that say what is drawn; elements inherit all others, too, which takes time and memory."""


def check_content(content: bytes) -> None:
    """Refuse a file too large to be parsed.

    Raises
    ------
    InvalidFile
        Naming the limit and the value.
    """
    check_limit(told("the SVG"), told("bytes"), len(content), DRAWING_BYTES)
    check_limit(told("the SVG"), told("tags"), content.count(b"<") + content.count(b"="), DRAWING_TAGS)


def check_tree(root: ElementTree.Element) -> None:
    """Refuse a drawing of too many elements, those counted too that `use` repeats, or nested too deeply.

    Raises
    ------
    InvalidFile
        Naming the limit and, where it can be told, the value.
    """
    _check_depth(root)
    named = {element.get("id"): element for element in root.iter() if element.get("id")}
    size = _size(root, named, {}, 0)
    check_limit(told("the SVG"), told("elements and subpaths"), size.elements, DRAWING_SHAPES)
    check_limit(told("the SVG"), told("letters"), size.letters, DRAWING_LETTERS)
    check_limit(told("the SVG"), told("numbers"), size.numbers, DRAWING_NUMBERS)


def without_idle_attributes(root: ElementTree.Element) -> None:
    """Leave of attributes those that say what is drawn."""
    for element in root.iter():
        for name in [name for name in element.attrib if name not in _DRAWING]:
            del element.attrib[name]


def tidy_styles(root: ElementTree.Element) -> None:
    """Leave of style sheets what is a rule: on what is none, patterns are tried without end.

    Raises
    ------
    InvalidFile
        If there are too many rules.
    """
    sheets = [(each, each.text) for each in root.iter() if _is_style(each) and each.text]
    check_limit(told("the SVG"), told("rules"), sum(text.count("{") for _, text in sheets), DRAWING_SHAPES)
    for element, text in sheets:
        rules = (rule.partition("{") for rule in text.split("}")[:-1] if rule.count("{") == 1)
        element.text = "".join(f"{who}{{{what}}}" for who, _, what in rules if who.strip() and what.strip())


def _is_style(element: ElementTree.Element) -> bool:
    return element.tag in (f"{_SPACE}style", "style")


def _check_depth(root: ElementTree.Element) -> None:
    level, depth = [root], 0
    while level:
        if depth > DEPTH:
            raise _too_deep()
        level, depth = [child for element in level for child in element], depth + 1


class _Size(NamedTuple):
    elements: int = 0
    letters: int = 0
    numbers: int = 0


def _size(
    element: ElementTree.Element,
    named: dict[str | None, ElementTree.Element],
    known: dict[ElementTree.Element, _Size],
    depth: int,
) -> _Size:
    """Give what an element comes to, with what is in it and what it uses."""
    if depth > 2 * DEPTH:  # what uses itself is deeper than all
        raise _too_deep()
    if element not in known:
        link = next((element.get(name, "") for name in _LINKS if element.get(name)), "")
        used = named.get(link.removeprefix("#")) if str(element.tag).endswith("use") else None
        inner = [*element, *([used] if used is not None else [])]
        known[element] = _sum(element, [_size(each, named, known, depth + 1) for each in inner])
    return known[element]


def _sum(element: ElementTree.Element, inner: list[_Size]) -> _Size:
    path = element.get("d", "")
    elements = sum((size.elements for size in inner), max(1, path.count("M") + path.count("m")))
    own = sum(map(len, element.attrib.values())) + (len(element.text or "") if _is_style(element) else 0)
    moves = len(element.get("transform", "")) * (elements - 1)
    return _Size(
        elements,
        sum((size.letters for size in inner), own + moves),
        sum((size.numbers for size in inner), sum(_numbers(element.get(name, "")) for name in _PATHS)),
    )


def _numbers(text: str) -> int:
    """Count numbers and commands, but not far beyond the limit."""
    return sum(1 for _ in islice(_TOKEN.finditer(text), DRAWING_NUMBERS + 1))


def _too_deep() -> InvalidFile:
    return InvalidFile(
        told("the SVG is nested too deeply, or uses itself"),
        told("nest at most {most} elements", most=DEPTH),
    )
