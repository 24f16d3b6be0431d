"""Ways to blend: one module a method, one protocol; `meshes` has the triangles that they move."""

METHODS = ("vertex", "edge-angle", "star-skeleton", "stitched", "rigid", "certified")
"""The methods by name, the simplest first."""

USUAL = "stitched"
"""The one that is taken where none is named."""

COMPARED = ("stitched", "certified", "rigid", "star-skeleton", "edge-angle", "vertex")
"""The same in the order in which they are shown side by side: the usual one, then its rivals."""

STEERED = "star-skeleton"
"""The one that the choice of a root and whole turns make a difference to."""
