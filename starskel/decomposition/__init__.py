"""Compatible star decompositions: the same pieces in both polygons, each star-shaped in both."""
