"""Many tasks at once on this machine, each in a process, so that one that dies spoils no other."""

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

from starskel.command.batches.work import Outcome, Task, work

_AHEAD = 4
"""Tasks that wait for each process: so many pairs are in memory."""

_PULSE = 1.0
"""Seconds between two looks whether the program that gives the tasks is still there."""


def outcomes(tasks: Iterable[Task], processes: int) -> Iterator[Outcome]:
    """Do tasks and give what comes out, as soon as it is there.

    A process that dies takes those beside it along; each task that was under way is done again alone, and
    the one that dies again is a failure.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the processes are many enough
    remaining, broken = iter(tasks), True
    while broken:
        broken, suspects = False, []
        for outcome in _together(remaining, processes):
            if isinstance(outcome, Task):
                suspects.append(outcome)
                broken = True
            else:
                yield outcome
        for suspect in suspects:
            for outcome in _together(iter([suspect]), 1):
                yield _dead(suspect) if isinstance(outcome, Task) else outcome


def _together(tasks: Iterator[Task], processes: int) -> Iterator[Outcome | Task]:
    """Give outcomes, and where the pool breaks the tasks that were under way; those behind stay untouched."""
    with ProcessPoolExecutor(processes, _context(), initializer=_begin) as pool:
        running: dict[Future[Outcome], Task] = {}
        try:
            while True:
                for task in islice(tasks, _AHEAD * processes - len(running)):
                    running[pool.submit(work, task)] = task
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


def _dead(task: Task) -> Outcome:
    return Outcome(key=task.key, digest=task.digest, error="the process that worked at it died")


def _context() -> BaseContext:
    """Give the way to begin processes: where it can be had, as copies of one that has loaded all."""
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload([work.__module__])
    return context


def _begin() -> None:
    """Leave interruptions to the program that gives the tasks, and end when it is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_watch, args=(os.getppid(),), daemon=True).start()


def _watch(parent: int) -> None:
    while os.getppid() == parent:
        sleep(_PULSE)
    os._exit(1)
