"""Several blends of one pair, be it of two polygons or of shapes of several."""

from argparse import Namespace
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from starskel.blending import STEERED
from starskel.blending.frames import Blend
from starskel.command.progress import Progress
from starskel.decomposition import decompose
from starskel.decomposition.pieces import Decomposition
from starskel.errors import InvalidFile
from starskel.files.multi_pairs import MultiPair
from starskel.files.pairs import ShapePair
from starskel.files.projects.project import AnyPair
from starskel.shapes.blend import blend
from starskel.shapes.matching.match import match
from starskel.shapes.shape_blend import ShapeBlend

Watch: TypeAlias = Callable[[str, float], None]
"""Told which variant is under way, and the fraction of all that is done."""


@dataclass(frozen=True)
class Variant:
    """One of several blends of a pair.

    Attributes
    ----------
    method : str
    joined : bool
        Whether a meta-skeleton joins the parts.
    label : str
        What it is called, where that is not the method.
    """

    method: str
    joined: bool = True
    label: str = ""

    @property
    def name(self) -> str:
        """What it is called."""
        return self.label or self.method


def variants_of(
    arguments: Namespace, pairs: Sequence[AnyPair], methods: Sequence[str], *, measured: bool
) -> list[Variant]:
    """Give a variant for every method; a sheet of shapes of several parts shows the first also part by part.

    Raises
    ------
    InvalidFile
        If the options do not go with what is blended.
    """
    if arguments.separate and not any(isinstance(pair, MultiPair) for pair in pairs):
        raise InvalidFile(f"{arguments.file} holds no shapes of several polygons", "leave out --separate")
    variants = [Variant(method, not arguments.separate) for method in methods]
    return [*variants, *comparison(pairs[0], methods)] if measured and len(pairs) == 1 else variants


def comparison(pair: AnyPair, methods: Sequence[str]) -> list[Variant]:
    """Give the first method part by part, of shapes of several parts (paper, figure 9)."""
    shapes = (pair.source, pair.target) if isinstance(pair, MultiPair) else ()
    several = any(len(shape.outlines) > 1 for shape in shapes)
    return [Variant(methods[0], joined=False, label="parts separately")] if several else []


def blends_of(
    pair: AnyPair, variants: Sequence[Variant], watch: Watch | None = None
) -> Iterator[tuple[str, Blend | ShapeBlend]]:
    """Blend a pair in several variants, one after the other, and give each blend under its variant's name.

    Parameters
    ----------
    pair : ShapePair or MultiPair
    variants : sequence of Variant
    watch : callable, optional
        Called with the name of the variant under way and the fraction of all that is done; else each shows a
        bar.

    Raises
    ------
    StarskelError
        If the pair cannot be matched or blended.
    """
    if isinstance(pair, MultiPair):
        yield from _shape_blends(pair, variants, watch)
    else:
        yield from _polygon_blends(pair, variants, watch)


def _polygon_blends(
    pair: ShapePair, variants: Sequence[Variant], watch: Watch | None
) -> Iterator[tuple[str, Blend]]:
    """Blend polygons, which are decomposed but once."""
    matched = match(pair.source, pair.target, pair.marks)
    decomposition: Decomposition | None = None
    for number, variant in enumerate(variants):
        with Progress(f"{pair.id}: {variant.name}") as bar:
            root = None
            if variant.method == STEERED and pair.root is not None:
                decomposition = decomposition or decompose(matched)
                root = decomposition.piece_at(pair.root)
            made = blend(
                matched,
                method=variant.method,
                decomposition=decomposition,
                root=root,
                turns=pair.turns,
                progress=_progress(bar, watch, variants, number),
            )
        decomposition = made.decomposition or decomposition
        yield variant.name, made


def _shape_blends(
    pair: MultiPair, variants: Sequence[Variant], watch: Watch | None
) -> Iterator[tuple[str, ShapeBlend]]:
    matched = match(pair.source, pair.target, pair.marks, pairing=pair.pairing, places=pair.places)
    for number, variant in enumerate(variants):
        with Progress(f"{pair.id}: {variant.name}") as bar:
            made = blend(
                matched,
                method=variant.method,
                joined=variant.joined and pair.joined,
                roots=pair.roots,
                turns=pair.turns,
                progress=_progress(bar, watch, variants, number),
            )
        yield variant.name, made


def _progress(
    bar: Progress, watch: Watch | None, variants: Sequence[Variant], number: int
) -> Callable[[float], None]:
    """Give what is told how far one variant is: its bar, or who watches all of them."""
    if watch is None:
        return bar
    return lambda fraction: watch(variants[number].name, (number + fraction) / len(variants))
