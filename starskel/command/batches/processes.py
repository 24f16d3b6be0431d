"""Many jobs at once on this machine, each in a process, so that one that dies spoils no other."""

import multiprocessing
import os
import signal
import threading
from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from itertools import islice
from multiprocessing.context import BaseContext
from time import sleep

from starskel.command.batches.work import Outcome, PackedJob, work

_AHEAD = 4
"""Tasks that wait for each process: so many pairs are in memory."""

_PULSE = 1.0
"""Seconds between two looks whether the program that gives the jobs is still there."""


def outcomes(jobs: Iterable[PackedJob], processes: int) -> Iterator[Outcome]:
    """Do jobs and give what comes out, as soon as it is there.

    A process that dies takes those beside it along; each job that was under way is done again alone, and
    the one that dies again is a failure.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the processes are many enough
    remaining, broken = iter(jobs), True
    while broken:
        broken, suspects = False, []
        for outcome in _together(remaining, processes):
            if isinstance(outcome, PackedJob):
                suspects.append(outcome)
                broken = True
            else:
                yield outcome
        for suspect in suspects:
            for outcome in _together(iter([suspect]), 1):
                yield _dead(suspect) if isinstance(outcome, PackedJob) else outcome


def _together(jobs: Iterator[PackedJob], processes: int) -> Iterator[Outcome | PackedJob]:
    """Give outcomes, and where the pool breaks the jobs that were under way; those behind stay untouched."""
    with ProcessPoolExecutor(processes, _context(), initializer=_begin) as pool:
        running: dict[Future[Outcome], PackedJob] = {}
        try:
            while True:
                for job in islice(jobs, _AHEAD * processes - len(running)):
                    running[pool.submit(work, job)] = job
                if not running:
                    return
                for future in wait(running, return_when=FIRST_COMPLETED).done:
                    outcome = future.result()
                    del running[future]
                    yield outcome
        except BrokenProcessPool:
            yield from running.values()
        except BaseException:
            for child in multiprocessing.active_children():
                child.terminate()  # lest the end wait for pairs that take long
            raise


def _dead(job: PackedJob) -> Outcome:
    return Outcome(key=job.key, digest=job.digest, error="the process that worked at it died")


def _context() -> BaseContext:
    """Give the way to begin processes: where it can be had, as copies of one that has loaded all."""
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload([work.__module__])
    return context


def _begin() -> None:
    """Leave interruptions to the program that gives the jobs, and end when it is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_watch, args=(os.getppid(),), daemon=True).start()


def _watch(parent: int) -> None:
    while os.getppid() == parent:
        sleep(_PULSE)
    os._exit(1)
