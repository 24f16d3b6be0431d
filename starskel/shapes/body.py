"""One part on its way: the blend of its rows, in a frame that may turn along with the part."""

from dataclasses import dataclass, replace

import numpy as np

from starskel.arrays import Complex, Floats
from starskel.blending import STEERED
from starskel.blending.frames import Blend, row_masses
from starskel.blending.methods import blend_pair
from starskel.blending.star_skeleton import StarSkeletonBlend
from starskel.blending.vertex import VertexBlend
from starskel.correspondence import Correspondence
from starskel.decomposition.canonical import canonical
from starskel.polar import as_complex, as_points
from starskel.shapes.correspondence import PartPair
from starskel.shapes.holes.pieces import decompose_region
from starskel.task import Task

MOST_TURN = np.pi / 2
"""Parts that turn by more are blended as if they did not, and turned: so no method mistakes the way."""

NEEDING_PIECES = ("star-skeleton", "stitched", "rigid", "certified")
"""The methods that stand on star pieces."""


@dataclass(frozen=True, eq=False)
class Body:
    """A part and the blend of its rows.

    Attributes
    ----------
    part : PartPair
    blend : Blend
        Of the part's pair, source and target turned back by these angles, round their middles.
    turned : (float, float)
        How far the frame in which the blend is has turned at t = 0 and 1; between them it turns evenly.
    """

    part: PartPair
    blend: Blend
    turned: tuple[float, float] = (0.0, 0.0)

    def moved(self, ts: Floats) -> tuple[Complex, Complex]:
        """Give the rows relative to the part's root, (times, n), and where that is in the blend, (times,)."""
        rows = as_complex(self.blend.frames(ts))
        roots = self._roots(ts, rows)
        return (rows - roots[:, None]) * self._turns(ts)[:, None], roots

    def carried(self, t: float, points: Floats, anchor: Floats, place: Floats) -> Floats:
        """Give (m, 2) points of the blend at t where the part is then; the anchor comes to a place."""
        (turn,) = self._turns(np.array([t]))
        return as_points((as_complex(points) - complex(*anchor)) * turn + complex(*place))

    @property
    def root_ends(self) -> tuple[complex, complex]:
        """Where the root is in source and target."""
        ends = np.array([0.0, 1.0])
        pair = self.part.pair
        middles = row_masses(pair) @ as_complex(np.stack([pair.source, pair.target], axis=1))
        first, last = (middles + (self.moved(ends)[1] - middles) * self._turns(ends)).tolist()
        return first, last

    def _turns(self, ts: Floats) -> Complex:
        """Give by which factors the frame is turned at each time."""
        start, end = self.turned
        return np.asarray(np.exp(1j * ((1 - ts) * start + ts * end)))

    def _roots(self, ts: Floats, rows: Complex) -> Complex:
        """Give the star-skeleton's root; of methods that hang on none, the middle of all rings."""
        if isinstance(self.blend, StarSkeletonBlend):
            row = len(self.blend.decomposition.source) + self.blend.skeleton.root
            return as_complex(self.blend.inside(ts)[:, row])
        return np.asarray((rows * row_masses(self.part.pair)).sum(axis=1))


@dataclass(frozen=True)
class Manner:
    """How parts are blended.

    Attributes
    ----------
    method : str
    settled : bool
        Whether blends are as good as they get; else they come sooner.
    root : (float, float) or None
        The star origin of the source nearest to this place is the root of the star-skeleton.
    """

    method: str
    settled: bool
    root: tuple[float, float] | None = None


def prepared(part: PartPair, manner: Manner, rotation: float, task: Task) -> Body:
    """Blend a part that turns by this rotation, whole turns included.

    Of its two ends always the same is turned back, whichever is called the source.

    Raises
    ------
    StarskelError
        Where a region is too narrow for bridges to its holes.
    Cancelled
        If the task is told to stop.
    """
    turning = part.alone or (abs(rotation) > MOST_TURN and manner.method != "vertex")
    exchanged = turning and not part.alone and canonical(part.pair).swapped
    turned = (-rotation, 0.0) if exchanged else (0.0, rotation if turning else 0.0)
    pair = _turned_back(part.pair, turned)
    made = VertexBlend(pair) if part.alone else _blend(pair, manner, task)
    return Body(part, made, turned)


def _turned_back(pair: Correspondence, turned: tuple[float, float]) -> Correspondence:
    source, target = (
        _turned(rows, row_masses(pair), -angle) if angle else rows
        for rows, angle in zip((pair.source, pair.target), turned, strict=True)
    )
    return replace(pair, source=source, target=target)


def _turned(points: Floats, weights: Floats, angle: float) -> Floats:
    """Turn points round their middle."""
    rows = as_complex(points)
    middle = weights @ rows
    return as_points(middle + (rows - middle) * np.exp(1j * angle))


def _blend(pair: Correspondence, manner: Manner, task: Task) -> Blend:
    method = manner.method
    if method == "certified" and len(pair.starts) > 1:
        method = "stitched"  # the certificate is that of all rings together
    known = decompose_region(pair, task.part(0, 0.4)) if method in NEEDING_PIECES else None
    root = known.piece_at(manner.root) if known and manner.root and method == STEERED else None
    rest = task.part(0.4, 1)
    return blend_pair(pair, method, decomposition=known, root=root, settled=manner.settled, task=rest)
