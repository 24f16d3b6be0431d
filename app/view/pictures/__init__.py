"""Pictures behind the shapes: placed, and traced."""
