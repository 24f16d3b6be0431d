"""Fewer pieces and Steiner vertices, and these in better places: moves that keep all pieces star-shaped."""
