"""Named shape: a shape as a file holds it, under its name, and what was mended."""

from dataclasses import dataclass, replace

from starskel.shapes.shape import Shape


@dataclass(frozen=True)
class NamedShape:
    """A shape of a file.

    Attributes
    ----------
    name : str
        What the file calls it, else what it is and its number; unique in the file.
    shape : Shape
        In the file's units, y up.
    repairs : tuple of str
        What was changed so that it is a shape, a sentence each; none where nothing was.
    """

    name: str
    shape: Shape
    repairs: tuple[str, ...] = ()


@dataclass(frozen=True)
class Reading:
    """What a file holds.

    Attributes
    ----------
    shapes : tuple of NamedShape
        In the file's order.
    notes : tuple of str
        What could not become a shape, a sentence each.
    """

    shapes: tuple[NamedShape, ...]
    notes: tuple[str, ...] = ()

    @property
    def repairs(self) -> tuple[str, ...]:
        """What was mended, each with the name of its shape."""
        return tuple(f"{found.name}: {repair}" for found in self.shapes for repair in found.repairs)


def uniquely_named(shapes: list[NamedShape]) -> tuple[NamedShape, ...]:
    """Give shapes names that differ: "leaf", "leaf 2", "leaf 3"."""
    taken: set[str] = set()
    numbers: dict[str, int] = {}
    named = []
    for found in shapes:
        name = found.name
        while name in taken:
            numbers[found.name] = numbers.get(found.name, 1) + 1
            name = f"{found.name} {numbers[found.name]}"
        taken.add(name)
        named.append(replace(found, name=name))
    return tuple(named)
