"""Triangulated rings: the ground that visibility expands over."""

from starskel.triangulation.triangulating import delaunay, triangulate
from starskel.triangulation.triangulation import Grounds, Triangulation

__all__ = ["Grounds", "Triangulation", "delaunay", "triangulate"]
