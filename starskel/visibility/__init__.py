"""Who sees whom: all pairs at once."""

from starskel.visibility.relations import Visibility, visibility, visibility_from

__all__ = ["Visibility", "visibility", "visibility_from"]
