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
    from starskel.blending.frames import Blend
    from starskel.correspondence import Correspondence, suggest_marks
    from starskel.decomposition import decompose
    from starskel.decomposition.pieces import Decomposition
    from starskel.images.morph import ImageMorph, image_morph
    from starskel.images.placed import PlacedImage
    from starskel.images.tracing import trace
    from starskel.polygon import Polygon
    from starskel.quality import Report, ShapeReport, measure
    from starskel.shapes.blend import blend
    from starskel.shapes.correspondence import ShapeCorrespondence
    from starskel.shapes.matching.match import match
    from starskel.shapes.matching.pairing import suggest_pairing
    from starskel.shapes.shape import Shape
    from starskel.shapes.shape_blend import ShapeBlend
    from starskel.skeleton import Skeleton

__all__ = [
    "METHODS",
    "Blend",
    "Cancelled",
    "Correspondence",
    "Decomposition",
    "ImageMorph",
    "InvalidFile",
    "InvalidMarks",
    "InvalidPolygon",
    "NoDecomposition",
    "PlacedImage",
    "Polygon",
    "Report",
    "Shape",
    "ShapeBlend",
    "ShapeCorrespondence",
    "ShapeReport",
    "Skeleton",
    "StarskelError",
    "UnknownMethod",
    "blend",
    "decompose",
    "image_morph",
    "match",
    "measure",
    "suggest_marks",
    "suggest_pairing",
    "trace",
]

_HOMES = {
    "Blend": "starskel.blending.frames",
    "Correspondence": "starskel.correspondence",
    "Decomposition": "starskel.decomposition.pieces",
    "ImageMorph": "starskel.images.morph",
    "PlacedImage": "starskel.images.placed",
    "Polygon": "starskel.polygon",
    "Report": "starskel.quality",
    "Shape": "starskel.shapes.shape",
    "ShapeBlend": "starskel.shapes.shape_blend",
    "ShapeCorrespondence": "starskel.shapes.correspondence",
    "ShapeReport": "starskel.quality",
    "Skeleton": "starskel.skeleton",
    "blend": "starskel.shapes.blend",
    "decompose": "starskel.decomposition",
    "image_morph": "starskel.images.morph",
    "match": "starskel.shapes.matching.match",
    "measure": "starskel.quality",
    "suggest_marks": "starskel.correspondence",
    "suggest_pairing": "starskel.shapes.matching.pairing",
    "trace": "starskel.images.tracing",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return __all__
