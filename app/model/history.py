"""History: the snapshots that undo and redo go through."""

from collections.abc import Hashable
from dataclasses import dataclass, field, replace

from app.model.document import Document


@dataclass(frozen=True)
class Step:
    """A document and the edit that led to it.

    Attributes
    ----------
    document : Document
        The snapshot.
    name : str
        What was done, as the menu calls it; empty for the first.
    joins : hashable or None
        Steps in a row with the same value here count as one: a held arrow key is undone at once. What is
        saved or looked at in between ends such a row.
    """

    document: Document
    name: str = ""
    joins: Hashable = None


@dataclass(frozen=True)
class History:
    """All steps since the document was opened, the one that is shown, and what is in the file.

    Snapshots share their polygons, so a step costs no more than what it changed.

    Attributes
    ----------
    steps : tuple of Step
        All of them, those undone among them.
    position : int
        Which one is shown.
    saved : Document
        What is in the file, or was there at first.
    """

    steps: tuple[Step, ...]
    position: int = 0
    saved: Document = field(default_factory=Document)

    @property
    def unsaved(self) -> bool:
        """Whether the document differs from its file; what of it is looked at makes no difference."""
        return self.document.showing(0, 0) != self.saved.showing(0, 0)

    @classmethod
    def of(cls, document: Document) -> "History":
        """Start at a document."""
        return cls((Step(document),), saved=document)

    @property
    def document(self) -> Document:
        """The document as it is now."""
        return self.steps[self.position].document

    @property
    def undoes(self) -> str | None:
        """The name of the edit that undo takes back, None at the start."""
        return self.steps[self.position].name if self.position else None

    @property
    def redoes(self) -> str | None:
        """The name of the edit that redo brings again, None at the end."""
        later = self.steps[self.position + 1 :]
        return later[0].name if later else None

    def push(self, document: Document, name: str, joins: Hashable = None) -> "History":
        """Go on to a new document; what was undone before is forgotten."""
        position = self.position
        if joins is not None and self.steps[position].joins == joins:
            position -= 1
        steps = (*self.steps[: position + 1], Step(document, name, joins))
        return replace(self, steps=steps, position=position + 1)

    def saving(self) -> "History":
        """Note that the document is in its file as it is now."""
        return replace(self._at_rest(self.document), saved=self.document)

    def showing(self, step: int, link: int | None = None) -> "History":
        """Show another step of the document, or another link of it.

        That is no edit: nothing is forgotten and nothing can be undone.
        """
        return self._at_rest(self.document.showing(step, link))

    def at(self, position: int) -> "History":
        """Go to any step."""
        return replace(self, position=position)

    def undo(self) -> "History":
        """Go one step back, where there is one."""
        return replace(self, position=max(self.position - 1, 0))

    def redo(self) -> "History":
        """Go one step forward, where there is one."""
        return replace(self, position=min(self.position + 1, len(self.steps) - 1))

    def _at_rest(self, document: Document) -> "History":
        """Let the step that is shown be one that no other joins, with this document."""
        here = replace(self.steps[self.position], document=document, joins=None)
        return replace(self, steps=(*self.steps[: self.position], here, *self.steps[self.position + 1 :]))
