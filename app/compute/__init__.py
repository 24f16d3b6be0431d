"""Blends computed beside the window: frozen requests, one worker thread, the newest request wins."""

from app.compute.blends import UNHURRIED, Blends
from app.compute.computer import Computer
from app.compute.request import STEERED, Failure, MethodState, Motion, Request, Result, Subject, subjects_of
from app.compute.trace import Trace, trace_of

__all__ = [
    "STEERED",
    "UNHURRIED",
    "Blends",
    "Computer",
    "Failure",
    "MethodState",
    "Motion",
    "Request",
    "Result",
    "Subject",
    "Trace",
    "subjects_of",
    "trace_of",
]
