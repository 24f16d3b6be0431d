"""Pictures inside shapes: placed, carried along by a blend's triangles, traced."""
