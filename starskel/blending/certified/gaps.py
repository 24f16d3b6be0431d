"""Narrowing the gaps between safe chains, in whatever way bridges are built."""

from collections.abc import Callable

from starskel.blending.certified.keys import Chain, Key
from starskel.task import Task

Bridge = Callable[[Key, Key, Task], Chain | None]
"""Gives a chain of good links from one key to another; None where it finds none."""


def narrowed(
    chains: list[Chain],
    bridge: Bridge,
    margins: tuple[float, ...],
    task: Task,
    resisted: set[tuple[float, float]] | None = None,
) -> list[Chain]:
    """Bridge gaps, each widened by a margin in time, in the end by the last; those that resist stay.

    What resisted, from one time to another, is not tried again, and added to what is known of that.
    """
    resisted = set() if resisted is None else resisted
    for number, margin in enumerate(margins):
        part = task.part(number / len(margins), (number + 1) / len(margins))
        chains = _narrowed(chains, bridge, margin, resisted, part)
        if len(chains) == 1:
            break
    return chains


def _narrowed(
    chains: list[Chain], bridge: Bridge, margin: float, resisted: set[tuple[float, float]], task: Task
) -> list[Chain]:
    """Bridge gaps, each widened by a margin, but for those from and to times that resisted before."""
    long = [chain for chain in chains[1:-1] if chain[-1].t - chain[0].t > 2 * margin]
    chains = [chains[0], *long, chains[-1]]  # what is shorter lies within the margins of two gaps
    done, share = [chains[0]], 1 / (len(chains) - 1)
    for at, chain in enumerate(chains[1:]):
        left = [key for key in done[-1] if key.t <= done[-1][-1].t - margin] or done[-1][:1]
        right = [key for key in chain if key.t >= chain[0].t + margin] or chain[-1:]
        span = left[-1].t, right[0].t
        found = None
        if span not in resisted:
            found = bridge(left[-1], right[0], task.part(at * share, (at + 1) * share))
        if found is None:
            resisted.add(span)
            done.append(chain)
        else:
            done[-1] = [*left[:-1], *found, *right[1:]]
    return done
