"""Ways to blend: one module a method, one protocol."""

METHODS = ("vertex", "edge-angle", "star-skeleton", "stitched", "rigid", "certified")
"""The methods by name, the simplest first."""

COMPARED = ("stitched", "certified", "rigid", "star-skeleton", "edge-angle", "vertex")
"""The same in the order in which they are shown side by side: the usual one, then its rivals."""
