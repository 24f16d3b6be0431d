"""Blends computed beside the window: frozen requests, one worker thread, the newest request wins."""

from app.compute.blends import UNHURRIED, Blends
from app.compute.computer import Computer
from app.compute.request import Failure, MethodState, Request, Result, Subject
from app.compute.trace import Trace, trace_of

__all__ = [
    "UNHURRIED",
    "Blends",
    "Computer",
    "Failure",
    "MethodState",
    "Request",
    "Result",
    "Subject",
    "Trace",
    "trace_of",
]
