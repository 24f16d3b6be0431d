"""Several methods on one pair, which is decomposed but once."""

from collections.abc import Iterator, Sequence

from starskel.blending.blend import blend
from starskel.blending.frames import Blend
from starskel.command.progress import Progress
from starskel.correspondence import match
from starskel.decomposition.pieces import Decomposition
from starskel.files.pairs import ShapePair


def blends(pair: ShapePair, methods: Sequence[str]) -> Iterator[tuple[str, Blend]]:
    """Blend a pair by each of the methods in turn, and give each blend under the method's name.

    Raises
    ------
    StarskelError
        If the pair cannot be matched or blended.
    """
    matched = match(pair.source, pair.target, pair.marks)
    decomposition: Decomposition | None = None
    for method in methods:
        with Progress(f"{pair.id}: {method}") as progress:
            made = blend(matched, method=method, decomposition=decomposition, progress=progress)
        decomposition = made.decomposition or decomposition
        yield method, made
