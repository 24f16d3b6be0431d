"""Ways to blend: one module a method, one protocol."""
