"""Settings of the tools, as the options bar shows them."""

from dataclasses import dataclass

from starskel.arrays import Floats


@dataclass(frozen=True)
class Snapping:
    """What catches the pointer.

    Attributes
    ----------
    vertices : bool
        Whether it is caught by vertices, and by their heights and sides.
    edges : bool
        Whether it is caught by edges and the lines that lengthen them.
    angles : bool
        Whether new edges keep to multiples of 15 degrees.
    grid : bool
        Whether it goes from point to point of the grid.
    spacing : float
        Between the lines of the grid, in document units.
    """

    vertices: bool = True
    edges: bool = True
    angles: bool = False
    grid: bool = False
    spacing: float = 10.0


@dataclass(frozen=True, eq=False)
class Lettering:
    """The outlines of a text of size 1, its baseline on the x axis, the largest outline first."""

    rings: tuple[Floats, ...] = ()


@dataclass(frozen=True)
class ToolSettings:
    """All that the user can set.

    Attributes
    ----------
    snapping : Snapping
        What catches the pointer.
    corners : int
        Of a regular polygon.
    points : int
        Of a star.
    inner : float
        The inner radius of a star, as a part of the outer.
    roundness : int
        Vertices of an ellipse.
    tolerance : float
        How far a simplified line may leave the one that was drawn, in pixels.
    added : int
        Vertices that refining adds.
    text, font : str
        What is set in outlines, and the name of the font, empty for the window's own.
    size : float
        Of the text, in document units.
    lettering : Lettering
        The outlines of text in font.
    """

    snapping: Snapping = Snapping()
    corners: int = 6
    points: int = 5
    inner: float = 0.45
    roundness: int = 48
    tolerance: float = 3.0
    added: int = 12
    text: str = "a"
    font: str = ""
    size: float = 60.0
    lettering: Lettering = Lettering()
