"""One job: a pair blended by each method and measured, wherever that is done."""

from dataclasses import dataclass
from time import process_time
from typing import Any

import msgspec

from starskel.command.figures import measured
from starskel.errors import StarskelError
from starskel.files.projects.project import AnyPair


class Outcome(msgspec.Struct, frozen=True, kw_only=True):
    """What came out, a line of the results.

    Attributes
    ----------
    key, digest : str
        Those of the job.
    figures : list of dict
        For each method what was measured.
    error : str
        Why it failed; "" where it did not.
    seconds : float
        The processor time that it took.
    """

    key: str
    digest: str
    figures: list[dict[str, Any]] = []
    error: str = ""
    seconds: float = 0.0


@dataclass(frozen=True)
class PackedJob:
    """A job with its pair, as it is sent to where it is done.

    Attributes
    ----------
    key, digest : str
        Those of the job.
    pair : ShapePair or MultiPair
    methods : tuple of str
    frames : int
        So many frames are looked at.
    """

    key: str
    digest: str
    pair: AnyPair
    methods: tuple[str, ...]
    frames: int


def work(job: PackedJob) -> Outcome:
    """Do a job; what goes wrong is told in the outcome, beside what was measured before."""
    start = process_time()
    figures: list[dict[str, Any]] = []
    error = ""
    try:
        for found, _ in measured(job.pair, job.methods, job.frames, watch=lambda method, fraction: None):
            figures.append(msgspec.to_builtins(found))
    except StarskelError as fault:
        error = str(fault)
    except Exception as fault:  # a defect of the program stops one pair, not the batch
        error = f"{type(fault).__name__}: {fault}"
    return Outcome(
        key=job.key, digest=job.digest, figures=figures, error=error, seconds=process_time() - start
    )
