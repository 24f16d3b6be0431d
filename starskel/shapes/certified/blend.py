"""The certified blend of shapes: no ring touches itself or another one, for any t.

Parts without holes move by their own certified blends, parts with holes by stitched ones, all joined by the
meta-skeleton. Keyframes of that are taken so densely that all even motions between them are proven, for all
rings together: then outlines and holes stay simple, holes inside and apart, and parts apart. Where rings do
meet on the way, that stretch of it is bridged by a morph of all rings together.
"""

from dataclasses import dataclass
from typing import NoReturn

import numpy as np

from starskel.arrays import Floats, read_only
from starskel.blending.certified import Way
from starskel.blending.certified.gaps import narrowed
from starskel.blending.certified.keys import Chain, Guide, Key, between, chains_between
from starskel.decomposition.canonical import canonical
from starskel.errors import StarskelError, told
from starskel.outline import signed_areas
from starskel.shapes.body import Body
from starskel.shapes.certified.joint_morph import MARGINS, JointMorphing
from starskel.shapes.certified.joint_rings import JointRings
from starskel.shapes.correspondence import ShapeCorrespondence
from starskel.shapes.meta_skeleton import Tree
from starskel.shapes.shape_blend import ShapeBlend
from starskel.task import Task

LINKS = (64, 64)
"""So many links are looked at first."""

FARTHEST, CLOSEST = 2.0**-6, 2.0**-16
"""How far from a moment at which a ring is a point frames are looked at: from the first to the last."""

LOOKED_AT = 17
"""So many moments are looked at to say which rings meet."""


class CertifiedShapeBlend(ShapeBlend):
    """Keyframes that every vertex moves evenly between, each such motion proven.

    Attributes
    ----------
    key_times : (k,) array
        When the keyframes are, from 0 to 1.
    how : Way
        A convex morph where rings would have met on the way, and a morph of all rings was taken there; else
        the same as of the part that took the most.
    meeting_parts : tuple of (int, int)
        The bodies that meet in the source or the target, and so may on the way.

    Raises
    ------
    StarskelError
        Where rings must meet on the way, or shapes are as narrow as rounding.
    """

    how: Way

    def __init__(
        self, pair: ShapeCorrespondence, bodies: tuple[Body, ...], tree: Tree | None, task: Task
    ) -> None:
        super().__init__(pair, "certified", bodies, tree)
        self._keys: tuple[Floats, Floats] | None = None
        self._stops = np.cumsum([len(body.part.pair) for body in bodies])[:-1]
        rings = JointRings([body.part for body in bodies])
        self.meeting_parts = rings.meeting
        keys, morphed = _Proof(rings, self._all_rows, _names(bodies), _backwards(bodies)).keys(task)
        taken = {body.blend.how for body in bodies}
        self.how = Way.CONVEX if morphed else [way for way in Way if way in taken | {Way.AS_IT_IS}][-1]
        self.key_times = read_only(np.array([key.t for key in keys]))
        self._keys = self.key_times, np.stack([key.frame for key in keys])

    @property
    def pieces(self) -> tuple[None, ...]:
        """None for each body: frames lie between keyframes, where the bodies' pieces would be elsewhere."""
        return (None,) * len(self.bodies)

    def _all_rows(self, ts: Floats) -> Floats:
        return np.concatenate(self._exact_rows(ts), axis=1)

    def _exact_rows(self, ts: Floats) -> list[Floats]:
        if self._keys is None:
            return super()._exact_rows(ts)
        return np.split(between(*self._keys, ts), self._stops, axis=1)


def _backwards(bodies: tuple[Body, ...]) -> bool:
    """Tell whether to go from the target to the source: the same way, whichever of them is which."""
    parts = [body.part for body in bodies if not body.part.alone]
    if not parts:
        return False
    areas = np.array([signed_areas(part.rings(part.ends)[0]).sum() for part in parts])
    return canonical(parts[int((areas / areas.max()).round(9).argmax())].pair).swapped


def _names(bodies: tuple[Body, ...]) -> list[str]:
    """Name all rings as they are paired."""
    return [str(link) for body in bodies for link in body.part.links]


@dataclass(frozen=True, eq=False)
class _Proof:
    """Keys with safe links from source to target.

    Attributes
    ----------
    rings : JointRings
    guide : Guide
        The frames that are wanted.
    names : list of str
        What the rings are called in errors.
    backwards : bool
        Whether they are sought from the target to the source.
    """

    rings: JointRings
    guide: Guide
    names: list[str]
    backwards: bool

    def keys(self, task: Task) -> tuple[Chain, bool]:
        """Give the keys, and whether some are of a morph.

        Raises
        ------
        StarskelError
            Where there are none.
        """
        self._check_nesting()
        keys, morphed = self._sought(task)
        return ([Key(1 - key.t, key.frame) for key in keys[::-1]] if self.backwards else keys), morphed

    def _sought(self, task: Task) -> tuple[Chain, bool]:
        frames = self.rings.ends[::-1] if self.backwards else self.rings.ends
        start, end = (Key(float(t), frame) for t, frame in enumerate(frames))
        first, last = self._beside(start, end, task), self._beside(end, start, task)
        linked, sound = self.rings.safe, self.rings.sound
        chains = chains_between((first, last), self._wanted, linked, task.part(0, 0.4), LINKS, sound)
        whole = len(chains) == 1
        if not whole:
            gap = chains[0][-1].t, chains[1][0].t
            chains = narrowed(chains, JointMorphing(self.rings), MARGINS, task.part(0.4, 1))
            if len(chains) > 1:
                self._refuse(*gap)
        ends = [start] if first is not start else [], [end] if last is not end else []
        return [*ends[0], *chains[0], *ends[1]], not whole

    def _wanted(self, ts: Floats) -> Floats:
        return self.guide(1 - ts if self.backwards else ts)

    def _beside(self, end: Key, other: Key, task: Task) -> Key:
        """Give a key linked to an end at which no ring is a point any more; the end itself, if none is."""
        if not len(self.rings.points(end.frame)):
            return end
        share = FARTHEST
        while share >= CLOSEST:
            task.quiet.reach(0)
            t = end.t + share * (other.t - end.t)
            frame = self._wanted(np.array([t]))[0]
            if self.rings.sound(frame) and self.rings.safe(end.frame, frame):
                return Key(t, frame)
            share /= 2
        return self._refuse(end.t, t)

    def _check_nesting(self) -> None:
        for side, name in enumerate(("source", "target")):
            wrong = np.argwhere(self.rings.misplaced(side))
            if len(wrong):
                ring, other = (self.names[k] for k in wrong[0])
                raise StarskelError(
                    told(
                        "the rings paired as {ring} lie in those paired as {other}, but not in the {name}:"
                        " they must meet on the way",
                        ring=ring,
                        other=other,
                        name=told(name),
                    ),
                    told(
                        "pair them otherwise, place what grows or shrinks elsewhere, or choose another method"
                    ),
                )

    def _refuse(self, before: float, after: float) -> NoReturn:
        """Say which rings meet between two times, and where no way round them was found."""
        for t in np.linspace(before, after, LOOKED_AT).tolist():
            crossing = self.rings.crossing(self._wanted(np.array([t]))[0])
            if crossing and 0 < t < 1:
                break
        t = 1 - t if self.backwards else t
        raise StarskelError(
            told("{what} at t = {t:.3f}, and no way round was found", what=self._meeting(crossing), t=t),
            told("choose another method, such as stitched, add marks, or widen the narrowest places"),
        )

    def _meeting(self, crossing: list[tuple[int, int]]) -> str:
        """Say which rings meet, of those found."""
        if not crossing:
            return told("two rings come too near to each other")
        ring, other = (self.names[k] for k in crossing[0])
        if ring == other:
            return told("the ring paired as {ring} crosses itself", ring=ring)
        return told("the rings paired as {ring} and {other} meet", ring=ring, other=other)
