"""Ways to blend: one module a method, one protocol."""

METHODS = ("vertex", "edge-angle", "star-skeleton", "stitched", "rigid")
"""The methods by name, the simplest first."""
