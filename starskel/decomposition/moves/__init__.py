"""Moves to fewer pieces and Steiner vertices, and these in better places; all pieces stay star-shaped."""
