"""Blends that provably never cross themselves, at no moment."""

from starskel.blending.certified.blend import CertifiedBlend
from starskel.blending.certified.path import Way

__all__ = ["CertifiedBlend", "Way"]
