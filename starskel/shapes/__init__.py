"""Shapes of several polygons, with holes: pairing, bridges, the meta-skeleton (paper, section 4)."""
