"""Many jobs at once on a Dask cluster (extra `cluster`)."""

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any

from starskel.command.batches.work import Outcome, PackedJob, work
from starskel.errors import InvalidFile

_AHEAD = 4
"""Tasks that wait for each thread of the cluster."""

_PATIENCE = "10s"
"""So long the scheduler may take to answer."""


def outcomes(jobs: Iterable[PackedJob], address: str) -> Iterator[Outcome]:
    """Do jobs on the cluster of a scheduler and give what comes out, as soon as it is there.

    What was under way on a worker that is lost is done again by the scheduler.

    Raises
    ------
    InvalidFile
        If Dask is not installed, or no scheduler answers at the address.
    """
    try:
        from distributed import Client, as_completed  # noqa: PLC0415 -- an extra
    except ImportError:
        raise InvalidFile("--scheduler needs Dask", 'install it: pip install "starskel[cluster]"') from None
    try:
        client = Client(address, timeout=_PATIENCE)
    except (OSError, ValueError, TimeoutError) as error:
        raise InvalidFile(
            f"no scheduler answers at {address}", "start one, or correct the address"
        ) from error
    with client:
        remaining = iter(jobs)
        threads = max(1, sum(client.nthreads().values()))
        running: dict[Any, PackedJob] = {}

        def submit(count: int) -> list[Any]:
            futures = [(client.submit(work, job, pure=False), job) for job in islice(remaining, count)]
            running.update(futures)
            return [future for future, _ in futures]

        done = as_completed(submit(_AHEAD * threads))
        for future in done:
            job = running.pop(future)
            yield future.result() if future.status == "finished" else _failed(job, future.exception())
            done.update(submit(1))


def _failed(job: PackedJob, error: BaseException | None) -> Outcome:
    return Outcome(key=job.key, digest=job.digest, error=f"{type(error).__name__}: {error}")
