"""Triangulated rings: the ground that visibility expands over."""

from starskel.triangulation.triangulation import Grounds, Triangulation
from starskel.triangulation.ways import delaunay, triangulate

__all__ = ["Grounds", "Triangulation", "delaunay", "triangulate"]
