"""From a few marks to a complete correspondence."""

from starskel.correspondence.match import PolygonLike, match
from starskel.correspondence.pair import Correspondence

__all__ = ["Correspondence", "PolygonLike", "match"]
