"""What an SVG file may hold: counted before anything is made of it, so that none takes time without end."""

import re
from xml.etree import ElementTree

from starskel.errors import InvalidFile, told
from starskel.limits import (
    DEPTH,
    DRAWING_BYTES,
    DRAWING_ELEMENTS,
    DRAWING_NUMBERS,
    DRAWING_TAGS,
    check_limit,
)

_TOKEN = re.compile(r"[A-Za-z]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_COUNTED = ("d", "points", "transform")
_LINKS = ("href", "{http://www.w3.org/1999/xlink}href")


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
    elements, numbers = _sizes(root, named, {}, 0)
    check_limit(told("the SVG"), told("elements"), elements, DRAWING_ELEMENTS)
    check_limit(told("the SVG"), told("numbers"), numbers, DRAWING_NUMBERS)


def tidy_styles(root: ElementTree.Element) -> None:
    """Leave of style sheets what is a rule: on what is none, patterns are tried without end."""
    for element in root.iter():
        if isinstance(element.tag, str) and element.tag.rpartition("}")[2] == "style" and element.text:
            rules = (rule.partition("{") for rule in element.text.split("}")[:-1] if rule.count("{") == 1)
            element.text = "".join(
                f"{who}{{{what}}}" for who, _, what in rules if who.strip() and what.strip()
            )


def _check_depth(root: ElementTree.Element) -> None:
    level, depth = [root], 0
    while level:
        if depth > DEPTH:
            raise _too_deep()
        level, depth = [child for element in level for child in element], depth + 1


def _sizes(
    element: ElementTree.Element,
    named: dict[str | None, ElementTree.Element],
    known: dict[ElementTree.Element, tuple[int, int]],
    depth: int,
) -> tuple[int, int]:
    """Give how many elements and numbers an element comes to."""
    if depth > 2 * DEPTH:  # what uses itself is deeper than all
        raise _too_deep()
    if element not in known:
        link = next((element.get(name, "") for name in _LINKS if element.get(name)), "")
        used = named.get(link.removeprefix("#")) if str(element.tag).endswith("use") else None
        inner = [
            _sizes(each, named, known, depth + 1)
            for each in (*element, *([used] if used is not None else []))
        ]
        own = sum(1 for name in _COUNTED for _ in _TOKEN.finditer(element.get(name, "")))
        known[element] = 1 + sum(size for size, _ in inner), own + sum(count for _, count in inner)
    return known[element]


def _too_deep() -> InvalidFile:
    return InvalidFile(
        told("the SVG is nested too deeply, or uses itself"),
        told("nest at most {most} elements", most=DEPTH),
    )
