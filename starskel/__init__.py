"""Blend one drawn shape into another by the star-skeleton.

The names below are loaded when they are first used, so that importing the package costs next to nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from starskel.blending import METHODS
from starskel.errors import (
    Cancelled,
    InvalidFile,
    InvalidMarks,
    InvalidPolygon,
    NoDecomposition,
    StarskelError,
    UnknownMethod,
)

if TYPE_CHECKING:
    from starskel.correspondence import Correspondence, match
    from starskel.decomposition.pieces import Decomposition
    from starskel.polygon import Polygon

__all__ = [
    "METHODS",
    "Cancelled",
    "Correspondence",
    "Decomposition",
    "InvalidFile",
    "InvalidMarks",
    "InvalidPolygon",
    "NoDecomposition",
    "Polygon",
    "StarskelError",
    "UnknownMethod",
    "match",
]

_HOMES = {
    "Correspondence": "starskel.correspondence",
    "Decomposition": "starskel.decomposition.pieces",
    "Polygon": "starskel.polygon",
    "match": "starskel.correspondence",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return __all__
