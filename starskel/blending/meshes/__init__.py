"""The triangles inside both polygons alike: fans of star pieces, joined to meshes and improved."""
