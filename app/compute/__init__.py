"""Blends computed beside the window: frozen requests, one worker thread, the newest request wins."""

from app.compute.blends import USUAL_METHODS, Blends
from app.compute.computer import Computer
from app.compute.matched_vertex import MatchedVertex, matched_vertex
from app.compute.morphs import Morphs
from app.compute.request import (
    Failure,
    MarkWish,
    MethodState,
    Proposal,
    Request,
    Result,
    Subject,
    subjects_of,
)
from starskel.blending import STEERED

__all__ = [
    "STEERED",
    "USUAL_METHODS",
    "Blends",
    "Computer",
    "Failure",
    "MarkWish",
    "MatchedVertex",
    "MethodState",
    "Morphs",
    "Proposal",
    "Request",
    "Result",
    "Subject",
    "matched_vertex",
    "subjects_of",
]
