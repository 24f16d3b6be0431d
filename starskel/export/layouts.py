"""What an export is to be: pictures, one that moves, or numbers."""

from typing import Literal

Layout = Literal["row", "sheet", "frames", "animation", "numbers"]

LAYOUTS: tuple[Layout, ...] = ("row", "sheet", "frames", "animation", "numbers")

PICTURES: tuple[Layout, ...] = ("row", "sheet", "frames")
"""Those that stand still."""
