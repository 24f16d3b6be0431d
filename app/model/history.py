"""History: the snapshots that undo and redo go through."""

from collections.abc import Hashable
from dataclasses import dataclass, field, replace

from app.model.document import Document


@dataclass(frozen=True)
class Snapshot:
    """A document and the edit that led to it.

    Attributes
    ----------
    document : Document
        As it was then.
    name : str
        What was done, as the menu calls it; empty for the first.
    joins : hashable or None
        Snapshots in a row with the same value here count as one: a held arrow key is undone at once. What is
        saved or looked at in between ends such a row.
    """

    document: Document
    name: str = ""
    joins: Hashable = None


@dataclass(frozen=True)
class History:
    """All snapshots since the document was opened, the one that is shown, and what is in the file.

    They share their polygons, so one costs no more than what it changed.

    Attributes
    ----------
    snapshots : tuple of Snapshot
        All of them, those undone among them.
    position : int
        Which one is shown.
    saved : Document
        What is in the file, or was there at first.
    """

    snapshots: tuple[Snapshot, ...]
    position: int = 0
    saved: Document = field(default_factory=Document)

    @property
    def unsaved(self) -> bool:
        """Whether the document differs from its file; what of it is looked at makes no difference."""
        return self.document.showing(0, 0) != self.saved.showing(0, 0)

    @classmethod
    def of(cls, document: Document) -> "History":
        """Start at a document."""
        return cls((Snapshot(document),), saved=document)

    @property
    def document(self) -> Document:
        """The document as it is now."""
        return self.snapshots[self.position].document

    @property
    def undoes(self) -> str | None:
        """The name of the edit that undo takes back, None at the start."""
        return self.snapshots[self.position].name if self.position else None

    @property
    def redoes(self) -> str | None:
        """The name of the edit that redo brings again, None at the end."""
        later = self.snapshots[self.position + 1 :]
        return later[0].name if later else None

    def push(self, document: Document, name: str, joins: Hashable = None) -> "History":
        """Go on to a new document; what was undone before is forgotten."""
        position = self.position
        if joins is not None and self.snapshots[position].joins == joins:
            position -= 1
        snapshots = (*self.snapshots[: position + 1], Snapshot(document, name, joins))
        return replace(self, snapshots=snapshots, position=position + 1)

    def saving(self, saved: Document) -> "History":
        """Note what of the document is in its file; nothing joins the snapshot that is shown any more."""
        return replace(self._at_rest(self.document), saved=saved)

    def showing(self, step: int, link: int | None = None) -> "History":
        """Show another step of the document, or another link of it.

        That is no edit: nothing is forgotten and nothing can be undone.
        """
        return self._at_rest(self.document.showing(step, link))

    def at(self, position: int) -> "History":
        """Go to any snapshot."""
        return replace(self, position=position)

    def undo(self) -> "History":
        """Go one snapshot back, where there is one."""
        return replace(self, position=max(self.position - 1, 0))

    def redo(self) -> "History":
        """Go one snapshot forward, where there is one."""
        return replace(self, position=min(self.position + 1, len(self.snapshots) - 1))

    def _at_rest(self, document: Document) -> "History":
        """Let the snapshot that is shown be one that no other joins, with this document."""
        here = replace(self.snapshots[self.position], document=document, joins=None)
        before, later = self.snapshots[: self.position], self.snapshots[self.position + 1 :]
        return replace(self, snapshots=(*before, here, *later))
