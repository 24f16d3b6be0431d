"""Compatible star decompositions: the same pieces in both polygons, each star-shaped in both."""

from starskel.decomposition.decompose import decompose, decompose_quickly
from starskel.decomposition.pieces import Decomposition

__all__ = ["Decomposition", "decompose", "decompose_quickly"]
