"""Regions with holes: bridges that cut them into simple polygons in both shapes alike; their star pieces."""
