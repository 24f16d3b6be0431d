"""Project: key shapes in order and the steps between them, under a name."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeAlias

from starskel.correspondence.marks import Mark
from starskel.errors import InvalidFile, told
from starskel.files.multi_pairs import MultiPair
from starskel.files.pairs import ShapePair
from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.step import Link, Step
from starskel.polygon import Polygon
from starskel.shapes.shape import Shape

AnyPair: TypeAlias = ShapePair | MultiPair
"""Two polygons, or two shapes of several."""


@dataclass(frozen=True)
class Project:
    """Key shapes in order, on the way to a blend.

    Attributes
    ----------
    name : str
        What the user calls it.
    shapes : tuple of KeyShape
        At least two, without parts where nothing has been drawn yet.
    steps : tuple of Step
        Step k leads from shape k to shape k + 1.
    methods : tuple of str
        The blending methods shown, in order.
    description : str
        A sentence about it; empty where nobody wrote one.
    """

    name: str
    shapes: tuple[KeyShape, ...] = (KeyShape(), KeyShape())
    steps: tuple[Step, ...] = (Step(),)
    methods: tuple[str, ...] = ()
    description: str = ""

    @classmethod
    def of(cls, pair: AnyPair) -> "Project":
        """Give a pair as a project of one step."""
        if isinstance(pair, MultiPair):
            shapes = _own(pair.source), _own(pair.target)
            step = Step(_links(pair), turns=pair.turns, joined=pair.joined)
            return cls(pair.id, shapes, (step,), description=pair.description)
        shapes = KeyShape.of(pair.source), KeyShape.of(pair.target)
        step = Step((Link(0, 0, pair.marks, root=pair.root),), turns=pair.turns)
        return cls(pair.id, shapes, (step,), description=pair.description)

    def pair(self, step: int) -> AnyPair:
        """Give the two shapes of a step, under the project's name, and the step's where there are several.

        Raises
        ------
        InvalidFile
            If one of them has not been drawn yet.
        """
        source, target = self.shapes[step : step + 2]
        for number, shape in ((step, source), (step + 1, target)):
            if not shape.parts:
                raise InvalidFile(
                    told("{name} has no shape {letter} yet", name=self.name, letter=letter(number)),
                    told("draw it in the editor and save"),
                )
        way, name = self.steps[step], self.step_name(step)
        if len(source) == len(target) == 1:
            (one,), (two,), (link,) = source.rings, target.rings, way.links
            return ShapePair(name, one, two, link.marks, link.root, way.turns, description=self.description)
        return MultiPair(
            name,
            source.shape,
            target.shape,
            tuple(link.ends for link in way.links),
            way.marks_by_part(len(source)),
            {link.ends: link.place for link in way.links if link.place is not None},
            roots=way.roots,
            joined=way.joined,
            turns=way.turns,
            description=self.description,
        )

    def step_name(self, step: int) -> str:
        """Give the name of a step: the project's, and the letters of its shapes where there are several."""
        if len(self.steps) == 1:
            return self.name
        return f"{self.name} {letter(step)}-{letter(step + 1)}"


def _own(shape: Shape) -> KeyShape:
    """Give the polygons as if they had been given counter-clockwise."""
    return KeyShape.of(*(Polygon(ring.vertices) for ring in shape.rings))


def _marks(pair: MultiPair, source: int, target: int | None, marks: Iterable[Mark]) -> tuple[Mark, ...]:
    if target is None:
        return ()
    one, two = pair.source.rings[source], pair.target.rings[target]
    return tuple((one.vertex_of(i), two.vertex_of(j)) for i, j in marks)


def _links(pair: MultiPair) -> tuple[Link, ...]:
    """Give the links of a pair; marks of a part that is cut into several belong to the first of these."""
    left = dict(enumerate(pair.marks))
    return tuple(
        Link(
            source,
            target,
            _marks(pair, source, target, left.pop(source, ())) if source is not None else (),
            pair.places.get((source, target)),
            pair.roots.get((source, target)),
        )
        for source, target in pair.pairing
    )


def letter(shape: int) -> str:
    """Give the letter of a key shape counted from 0: A, B, ... Z, AA, AB, ..."""
    letters, rest = "", shape
    while rest >= 0:
        letters = chr(ord("A") + rest % 26) + letters
        rest = rest // 26 - 1
    return letters
