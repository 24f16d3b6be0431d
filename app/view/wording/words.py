"""What the program says about the names and errors that the layers without Qt use."""

import re

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, QLocale

from app.model.document import Document
from app.model.marks import Side, witness
from app.model.parts import members
from starskel.correspondence.marks import Mark
from starskel.errors import InvalidMarks, InvalidPolygon, StarskelError, Told
from starskel.files.projects.key_shape import Part
from starskel.files.projects.project import letter

translate = QCoreApplication.translate

_LETTERS = "abcdefghijklmnopqrstuvwxyz"

# the library's names for its methods, for the translation tools to find
_METHODS = (
    QT_TRANSLATE_NOOP("Method", "vertex"),
    QT_TRANSLATE_NOOP("Method", "edge-angle"),
    QT_TRANSLATE_NOOP("Method", "star-skeleton"),
    QT_TRANSLATE_NOOP("Method", "stitched"),
    QT_TRANSLATE_NOOP("Method", "rigid"),
    QT_TRANSLATE_NOOP("Method", "certified"),
)


def figure(text: str) -> str:
    """Write numbers as the user's language does; where it has a decimal comma, lists need another sign."""
    point = QLocale().decimalPoint()
    if point == ".":
        return text
    text = "0" + text if text.startswith(".") else text
    return text.replace("...", "…").replace(", ", "; ").replace(".", point)


def step(name: str) -> str:
    """Give the name of an edit as the menu shows it."""
    return translate("Step", name)


def example(text: str) -> str:
    """Give the name or the description of an example that comes with the program."""
    return translate("Example", text) if text else ""


def hint(text: str) -> str:
    """Give what a tool says about itself."""
    return translate("Hint", text)


def catch(kind: str, angle: int) -> str:
    """Give the word for what catches the pointer."""
    return {
        "vertex": translate("Catch", "vertex"),
        "aligned": translate("Catch", "level with a vertex"),
        "edge": translate("Catch", "edge"),
        "angle": translate("Catch", "{angle}°").format(angle=angle),
        "grid": translate("Catch", "grid"),
    }[kind]


def method(name: str) -> str:
    """Give the name of a blending method."""
    return translate("Method", name)


def method_tip(name: str) -> str:
    """Say in a sentence what a blending method does."""
    return {
        "stitched": translate("MethodTip", "Turns and stretches all pieces evenly; seldom crosses itself."),
        "certified": translate("MethodTip", "Proven not to cross itself at any t; takes longer."),
        "rigid": translate("MethodTip", "Keeps the inside as rigid as possible, triangle by triangle."),
        "star-skeleton": translate("MethodTip", "Unfolds star-shaped pieces along a skeleton that bends."),
        "edge-angle": translate("MethodTip", "Changes lengths of edges and the angles between them evenly."),
        "vertex": translate("MethodTip", "Moves every vertex on a straight line."),
    }[name]


def step_letters(step: int) -> str:
    """Give a step by the letters of its shapes."""
    return f"{letter(step)} \N{RIGHTWARDS ARROW} {letter(step + 1)}"


def canvas(document: Document, side_name: Side) -> str:
    """Give the name of what is on a canvas: with the shape's letter where there are several steps."""
    if len(document.sequence.steps) == 1:
        return side(side_name)
    text = (
        translate("Side", "{letter} (source)")
        if side_name == "source"
        else translate("Side", "{letter} (target)")
    )
    return text.format(letter=letter(document.shape_on(side_name)))


def invitation(document: Document, side_name: Side) -> str:
    """Say what is to be drawn on a canvas."""
    if len(document.sequence.steps) > 1:
        return translate("Canvas", "Draw shape {letter} here").format(
            letter=letter(document.shape_on(side_name))
        )
    if side_name == "source":
        return translate("Canvas", "Draw the source shape here")
    return translate("Canvas", "Draw the target shape here")


def pictured() -> str:
    """Say what to do with a picture over which nothing has been drawn yet."""
    return translate("Canvas", "Trace the outline of the picture, in the Shape menu, or draw over it.")


def part(given: Part, number: int) -> str:
    """Give what a part is called: its name, or its number in its shape."""
    return given.name or translate("Part", "Part {number}").format(number=number + 1)


def link(document: Document, number: int) -> str:
    """Give what a part and its partner are called: a name, or numbers that no other link has."""
    source, target = document.way.links[number].ends
    given = members(document, number)[0]
    if source is None and target is not None:
        return given.name or translate("Part", "New part {number}").format(number=target + 1)
    assert source is not None
    several = sum(link.source == source for link in document.way.links) > 1
    if target is None or not several:
        return part(given, source)
    return translate("Part", "{part} to {number}").format(part=part(given, source), number=target + 1)


def no_partner(side_name: Side) -> str:
    """Say what becomes of a part that has no partner on this side."""
    return translate("Part", "from a point") if side_name == "source" else translate("Part", "to a point")


def new_part(side_name: Side) -> str:
    """Ask for a new part on a canvas that has others."""
    if side_name == "source":
        return translate("Canvas", "Draw the new part here")
    return translate("Canvas", "Draw its partner here, or leave it to grow from a point")


def growth(side_name: Side) -> str:
    """Say what a part does at its place on this side, where it has no partner."""
    return (
        translate("Part", "grows from here")
        if side_name == "source"
        else translate("Part", "shrinks to here")
    )


def side(name: Side) -> str:
    """Give the name of a canvas."""
    return translate("Side", "Source") if name == "source" else translate("Side", "Target")


def mark(index: int) -> str:
    """Give the label of a mark: a number, and letters that count along, as on the pins."""
    letters, rest = "", index
    while rest >= 0:
        letters = _LETTERS[rest % 26] + letters
        rest = rest // 26 - 1
    return f"{index + 1} {letters}"


def reason(error: Exception, document: Document) -> str:
    """Say why an edit or a blend is not possible, in the words of what is on the screen."""
    if isinstance(error, InvalidMarks) and len(error.marks) == 2:
        return _marks_reason(error.marks[0], error.marks[1], document)
    if isinstance(error, InvalidPolygon) and len(error.vertices) == 4:
        return translate("Refusal", "The red edges would cross or touch. Nothing was changed.")
    if isinstance(error, InvalidPolygon) and len(error.vertices) == 2:
        return translate("Refusal", "Two vertices would be at the same place. Nothing was changed.")
    if not isinstance(error, StarskelError):
        text = translate("Refusal", "A fault in the program, not in your shapes: {kind}: {error}")
        return text.format(kind=type(error).__name__, error=error)
    return sentences(error, " ")


def sentences(error: StarskelError, between: str) -> str:
    """Give what is wrong and how to mend it, a sentence each."""
    return between.join(sentence(text) for text in (error.what, error.mend) if text)


def sentence(text: object) -> str:
    """Give a text of the library as a sentence in the user's language; a name that it begins with stays."""
    said = str(retold(text))
    return f"{said if _begins_with_a_name(text) else _capitalised(said)}."


def _begins_with_a_name(text: object) -> bool:
    if not isinstance(text, Told):
        return False
    first = re.match(r"\{(\w+)", translate("", text.template))
    if first is None:
        return False
    value = text.values[first[1]]
    return _begins_with_a_name(value) if isinstance(value, Told) else True


def retold(text: object) -> object:
    """Give a text of the library in the user's language, as far as it remembers its template."""
    if not isinstance(text, Told):
        return text
    values = {name: retold(value) for name, value in text.values.items()}
    return translate("", text.template).format(**values)


def _marks_reason(first: Mark, second: Mark, document: Document) -> str:
    if first[0] == second[0] or first[1] == second[1]:
        text = translate(
            "Refusal", "This vertex already has {first}. Remove that pin first, or take another vertex."
        )
    else:
        text = _order_reason(witness(document.marks, first, second), document)
    return _capitalised(text.format(first=_named(first, document), second=_named(second, document)))


def _order_reason(third: Mark | None, document: Document) -> str:
    if third is None:
        return translate(
            "Refusal",
            "{second} would cross {first}: going round, they come in different orders on the two shapes.",
        )
    text = translate(
        "Refusal",
        "{{second}} would cross {{first}}: going round from {third}, one of them comes first on the source, "
        "the other on the target.",
    )
    return text.format(third=_named(third, document))


def _named(pair: Mark, document: Document) -> str:
    if pair in document.marks:
        return translate("Refusal", "mark {label}").format(label=mark(document.marks.index(pair)))
    for index, (source, target) in enumerate(document.marks):
        if source == pair[0] or target == pair[1]:  # it has kept its other end
            return translate("Refusal", "mark {label}, moved there,").format(label=mark(index))
    return translate("Refusal", "the new mark {label}").format(label=mark(len(document.marks)))


def _capitalised(text: str) -> str:
    return text[:1].upper() + text[1:]
