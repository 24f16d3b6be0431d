"""starskel batch: thousands of pairs blended and measured, in parallel and never twice."""

import os
import sys
from argparse import Namespace
from collections.abc import Iterable, Iterator, Sequence

from starskel.blending import COMPARED
from starskel.command import FAILED
from starskel.command.batches import cluster, processes
from starskel.command.batches.jobs import Job, jobs_of
from starskel.command.batches.journal import FORMAT, RESULTS, Journal, Terms
from starskel.command.batches.summary import summary_page
from starskel.command.batches.work import Outcome, PackedJob
from starskel.command.progress import Progress
from starskel.errors import InvalidFile, StarskelError
from starskel.files.disk import write_bytes
from starskel.files.documents import document_text
from starskel.sheet.words import counted


def run(arguments: Namespace) -> int:
    """Do what is not done yet, and write the summary."""
    methods = arguments.methods or COMPARED
    jobs = list(jobs_of(arguments.place))
    if not jobs:
        raise InvalidFile(f"{arguments.place} holds no pair", "give a folder of projects and files of pairs")
    with Journal(arguments.output, Terms(FORMAT, list(methods), arguments.frames)) as journal:
        keys = {job.key: job for job in jobs}
        journal.drop(_outdated(journal, keys, arguments.retry))
        pending = [job for job in keys.values() if job.key not in journal.outcomes]
        _work(arguments, methods, pending, journal)
        outcomes = [journal.outcomes[key] for key in keys]
        gone = len(journal.outcomes) - len(outcomes)
        write_bytes(arguments.output / "index.html", summary_page(outcomes, methods).encode())
    failed = sum(bool(outcome.error) for outcome in outcomes)
    counts = {"pairs": len(outcomes), "done_now": len(pending), "failed": failed, "gone": gone}
    if arguments.json:
        print(document_text({"results": str(arguments.output / RESULTS), **counts}), end="")
    else:
        besides = f"; results of {gone} more that are no longer there" if gone else ""
        print(
            f"{arguments.output / 'index.html'}: {counted(counts['pairs'], 'pair')}, {failed} failed{besides}"
        )
    return FAILED if failed else 0


def _outdated(journal: Journal, jobs: dict[str, Job], retry: bool) -> list[str]:
    """Give the keys of results whose files have changed, and of failures where they are to be tried again."""
    return [
        key
        for key, outcome in journal.outcomes.items()
        if (key in jobs and jobs[key].digest != outcome.digest) or (retry and outcome.error)
    ]


def _work(arguments: Namespace, methods: Sequence[str], jobs: Sequence[Job], journal: Journal) -> None:
    failures: list[Outcome] = []
    packed = _packed(jobs, tuple(methods), arguments.frames, failures)
    with Progress("") as bar:
        for number, outcome in enumerate(_with_failures(_done(arguments, packed), failures), 1):
            journal.add(outcome)
            if outcome.error:
                bar.clear()
                print(f"starskel: {outcome.key}: {outcome.error}", file=sys.stderr)
            bar.label = f"{number} of {len(jobs)}"
            bar(number / len(jobs))


def _done(arguments: Namespace, packed: Iterable[PackedJob]) -> Iterator[Outcome]:
    if arguments.scheduler:
        return cluster.outcomes(packed, arguments.scheduler)
    return processes.outcomes(packed, arguments.processes or os.cpu_count() or 1)


def _packed(
    jobs: Iterable[Job], methods: tuple[str, ...], frames: int, failures: list[Outcome]
) -> Iterator[PackedJob]:
    """Load pairs one by one; those that cannot be loaded are failures already."""
    for job in jobs:
        try:
            yield PackedJob(job.key, job.digest, job.load(), methods, frames)
        except StarskelError as error:
            failures.append(Outcome(key=job.key, digest=job.digest, error=str(error)))


def _with_failures(outcomes: Iterator[Outcome], failures: list[Outcome]) -> Iterator[Outcome]:
    for outcome in outcomes:
        yield outcome
        while failures:
            yield failures.pop()
    yield from failures
