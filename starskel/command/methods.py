"""Several methods on one pair, which is decomposed but once."""

from collections.abc import Callable, Iterator, Sequence

from starskel.blending import STEERED
from starskel.blending.frames import Blend
from starskel.command.progress import Progress
from starskel.correspondence import match
from starskel.decomposition import decompose
from starskel.decomposition.pieces import Decomposition
from starskel.files.pairs import ShapePair
from starskel.shapes.blend import blend


def blends(
    pair: ShapePair, methods: Sequence[str], watch: Callable[[str, float], None] | None = None
) -> Iterator[tuple[str, Blend]]:
    """Blend a pair by each of the methods in turn, and give each blend under the method's name.

    Parameters
    ----------
    pair : ShapePair
    methods : sequence of str
    watch : callable, optional
        Called with the method under way and the fraction of all that is done; else each method shows a bar.

    Raises
    ------
    StarskelError
        If the pair cannot be matched or blended.
    """
    matched = match(pair.source, pair.target, pair.marks)
    decomposition: Decomposition | None = None
    for number, method in enumerate(methods):
        with Progress(f"{pair.id}: {method}") as bar:
            progress = bar if watch is None else shared(watch, method, number, len(methods))
            root = None
            if method == STEERED and pair.root is not None:
                decomposition = decomposition or decompose(matched)
                root = decomposition.piece_at(pair.root)
            made = blend(
                matched,
                method=method,
                decomposition=decomposition,
                root=root,
                turns=pair.turns,
                progress=progress,
            )
        decomposition = made.decomposition or decomposition
        yield method, made


def shared(
    watch: Callable[[str, float], None], method: str, number: int, count: int
) -> Callable[[float], None]:
    """Give the progress of one of several methods, told to who watches all of them."""
    return lambda fraction: watch(method, (number + fraction) / count)
