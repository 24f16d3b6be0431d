"""From a few marks to a complete correspondence."""

from starskel.correspondence.match import PolygonLike, match
from starskel.correspondence.pair import Correspondence
from starskel.correspondence.suggestion import suggest_marks

__all__ = ["Correspondence", "PolygonLike", "match", "suggest_marks"]
