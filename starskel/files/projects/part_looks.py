"""How the parts of a project look on their way from one key shape to the next."""

from starskel.files.projects.key_shape import KeyShape
from starskel.files.projects.step import Step
from starskel.sheet.style import PartLook


def part_looks(source: KeyShape, step: Step, target: KeyShape) -> tuple[PartLook, ...]:
    """Give for each link of a step its colours at the start and at the end, and whether it is to be seen.

    A part that is alone keeps its colour. One of two partners to be seen is enough.
    """
    looks = []
    for link in step.links:
        ends = zip((source, target), link.ends, strict=True)
        members = [shape.parts[part] for shape, part in ends if part is not None]
        visible = any(part.visible for part in members)
        looks.append(PartLook((members[0].colour.lower(), members[-1].colour.lower()), visible))
    return tuple(looks)
