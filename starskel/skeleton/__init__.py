"""The skeleton: a tree that links the star origins through the mid-points of shared edges."""

from starskel.skeleton.tree import Skeleton, skeleton_of

__all__ = ["Skeleton", "skeleton_of"]
