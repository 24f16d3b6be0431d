"""Blends computed beside the window: frozen requests, one worker thread, the newest request wins."""

from app.compute.blends import USUAL_METHODS, Blends
from app.compute.computer import Computer
from app.compute.morphs import Morphs
from app.compute.request import Failure, MethodState, Proposal, Request, Result, Subject, subjects_of
from app.compute.trace import Trace, trace_of
from starskel.blending import STEERED

__all__ = [
    "STEERED",
    "USUAL_METHODS",
    "Blends",
    "Computer",
    "Failure",
    "MethodState",
    "Morphs",
    "Proposal",
    "Request",
    "Result",
    "Subject",
    "Trace",
    "subjects_of",
    "trace_of",
]
