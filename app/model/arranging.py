"""Verbs about the order of key shapes and the steps between them: they give new documents."""

from dataclasses import replace

from app.model.document import Document


def add_shape(document: Document, after: int) -> Document:
    """Put an empty shape behind another, and show the step to it."""
    return document.arranged(document.sequence.added(after), after)


def duplicate_shape(document: Document, shape: int) -> Document:
    """Put a copy behind a shape, and show the step to it; both correspond where the shape is marked."""
    return document.arranged(document.sequence.duplicated(shape), shape)


def delete_shape(document: Document, shape: int) -> Document:
    """Take a shape out of the sequence.

    Raises
    ------
    StarskelError
        If there are but two.
    """
    rest = document.sequence.without(shape)
    return document.arranged(rest, min(max(shape - 1, 0), len(rest.steps) - 1))


def move_shape(document: Document, shape: int, to: int) -> Document:
    """Move a shape to another number in the sequence, and show a step of it."""
    step, last = to if document.shape_on("source") == shape else to - 1, len(document.sequence.steps) - 1
    return document.arranged(document.sequence.moved(shape, to), min(max(step, 0), last))


def set_duration(document: Document, step: int, duration: float) -> Document:
    """Let a step take so long.

    Raises
    ------
    StarskelError
        If that is too short to be seen.
    """
    return document.arranged(document.sequence.timed(step, duration), document.step)


def ease_alike(document: Document) -> Document:
    """Let t run over every step as over the one on the canvases."""
    steps = tuple(replace(step, easing=document.way.easing) for step in document.sequence.steps)
    return replace(document, sequence=replace(document.sequence, steps=steps))
