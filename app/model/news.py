"""News: what an edit brought with it that is not seen at once."""

from dataclasses import dataclass

from app.model.document import Document
from app.model.sequence import lost_marks


@dataclass(frozen=True)
class News:
    """What is to be told of an edit.

    Attributes
    ----------
    lost : int
        How many marks it took along.
    filled : int
        How many holes are parts by themselves now, as they no longer lie inside their outline.
    opened : int
        How many parts are holes now, as they lie inside another one.
    """

    lost: int = 0
    filled: int = 0
    opened: int = 0

    def __bool__(self) -> bool:
        return self != NONE


NONE = News()
"""Nothing to tell."""


def news_of(former: Document, later: Document) -> News:
    """Give what an edit brought with it; parts that are not in both documents tell nothing."""
    filled = opened = 0
    for before, after in zip(former.sequence.shapes, later.sequence.shapes, strict=False):
        if before is not after and 0 < len(before) <= len(after):  # added parts come last
            changes = list(zip(before.shape.outer, after.shape.outer, strict=False))
            filled += sum(old >= 0 > new for old, new in changes)
            opened += sum(new >= 0 > old for old, new in changes)
    return News(lost_marks(former.sequence, later.sequence), filled, opened)
