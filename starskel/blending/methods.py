"""Choose a method by its name, and prepare it."""

from collections.abc import Callable

from starskel.arguments import instance, whole_number
from starskel.blending import METHODS, USUAL
from starskel.blending.certified import CertifiedBlend
from starskel.blending.edge_angle import EdgeAngleBlend
from starskel.blending.frames import Blend
from starskel.blending.rigid import RigidBlend
from starskel.blending.star_skeleton import StarSkeletonBlend
from starskel.blending.stitched import StitchedBlend
from starskel.blending.vertex import VertexBlend
from starskel.correspondence import Correspondence
from starskel.decomposition import decompose
from starskel.decomposition.pieces import Decomposition
from starskel.errors import StarskelError, UnknownMethod
from starskel.task import UNWATCHED, Task

MOST_TURNS = 1000
"""More whole turns than anyone watches; angles keep twelve digits."""

_DECOMPOSING = 0.5
"""The share of the work that the decomposition is taken to be."""


def blend_pair(  # noqa: PLR0913 -- all but the pair and the method are seldom given
    pair: Correspondence,
    method: str = USUAL,
    *,
    decomposition: Decomposition | None = None,
    root: int | None = None,
    turns: int = 0,
    settled: bool = True,
    task: Task = UNWATCHED,
) -> Blend:
    """Blend a pair of polygons, as `starskel.blend` does; or one of regions, whose decomposition is known.

    Raises
    ------
    UnknownMethod
        If there is no such method.
    StarskelError
        If the decomposition is of another pair, or there is no such root.
    Cancelled
        If the task is told to stop.
    """
    root = None if root is None else whole_number(root, "the root", 0)
    if decomposition is not None:
        _check_belongs(decomposition, pair)

    def pieces() -> Decomposition:
        if decomposition is not None:
            return decomposition
        return decompose(pair, progress=task.part(0, _DECOMPOSING).reach, should_stop=task.should_stop)

    rest = task.part(_DECOMPOSING, 1)
    made: dict[str, Callable[[], Blend]] = {
        "vertex": lambda: VertexBlend(pair),
        "edge-angle": lambda: EdgeAngleBlend(pair),
        "star-skeleton": lambda: StarSkeletonBlend(pieces(), root, turns),
        "stitched": lambda: StitchedBlend(pieces(), root, rest, settled=settled),
        "rigid": lambda: RigidBlend(pieces(), root, rest),
        "certified": lambda: CertifiedBlend(pieces(), root, rest),
    }
    return made[chosen_method(None, method)]()


def chosen_method(target: object, method: str | None) -> str:
    """Give the name of the method, which may stand in the target's place.

    Raises
    ------
    UnknownMethod
        If there is none of that name.
    StarskelError
        If it is given twice.
    """
    if isinstance(target, str) and method is not None:
        raise StarskelError(f"two methods are given, {target!r} and {method!r}", "give one")
    chosen = target if isinstance(target, str) else method
    if chosen is None:
        return USUAL
    if not isinstance(chosen, str) or chosen not in METHODS:
        raise UnknownMethod(f'there is no method "{chosen}"', "choose one of " + ", ".join(METHODS))
    return chosen


def checked_turns(given: int) -> int:
    """Give whole turns.

    Raises
    ------
    StarskelError
        If they are none, or so many that angles lose their digits.
    """
    return whole_number(given, "turns", -MOST_TURNS, MOST_TURNS)


def _check_belongs(decomposition: Decomposition, pair: Correspondence) -> None:
    mend = "give what decompose returns for the pair"
    if instance(decomposition, Decomposition, "the decomposition", mend).pair is not pair:
        raise StarskelError("the decomposition belongs to another pair", "decompose the pair to be blended")
