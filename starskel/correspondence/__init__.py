"""From a few marks to a complete correspondence."""

from starskel.correspondence.match import PolygonLike, match
from starskel.correspondence.pair import Correspondence, checked_pair
from starskel.correspondence.suggestion import suggest_marks

__all__ = ["Correspondence", "PolygonLike", "checked_pair", "match", "suggest_marks"]
