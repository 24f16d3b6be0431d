"""Outlines of what is seen in a picture: by its alpha, or by how dark or light it is."""

from typing import Literal, get_args

import contourpy
import numpy as np
import shapely

from starskel.arguments import choice, finite
from starskel.arrays import Floats, Indices
from starskel.errors import StarskelError, told
from starskel.images.placed import Pixels, PlacedImage
from starskel.limits import TRACED_PLACES, TRACED_SIDE, TRACED_VERTICES
from starskel.shapes.shape import Shape

By = Literal["alpha", "dark", "light"]
"""What is traced: what is opaque, what is darker than a level, or what is lighter."""

Parts = Literal["largest", "all"]
"""Only the part with the largest area, or all of them but for specks."""

LEAST_SHARE = 1e-3
"""Specks and pinholes of less than this part of the largest area are left out."""

_BAND = 64
"""Rows of the smaller picture that are made at a time."""

_WORDS: dict[By, str] = {"alpha": told("opaque"), "dark": told("dark"), "light": told("light")}

_LUMA = np.array([0.2126, 0.7152, 0.0722])
"""How bright red, green and blue are (ITU-R BT.709)."""


def trace(  # noqa: PLR0913 -- what is seen, and how much of it
    image: PlacedImage,
    by: By | None = None,
    level: float = 0.5,
    tolerance: float = 1.0,
    *,
    parts: Parts = "largest",
    holes: bool = True,
) -> Shape:
    """Give the outline of what is seen in a picture, in the document's coordinates.

    Contours run between the middles of pixels where the level lies between their values, so that smooth edges
    give smooth outlines. No point of them is farther from the simplified outline than the tolerance.

    Parameters
    ----------
    image : PlacedImage
    by : {"alpha", "dark", "light"}, optional
        By default alpha where a pixel is not opaque; else what is darker or lighter than the level, whichever
        most of the picture's border is not.
    level : float
        Between 0 and 1.
    tolerance : float
        In pixels of the picture; 0 keeps all vertices.
    parts : {"largest", "all"}
        Only the part with the largest area, or all of them but for specks.
    holes : bool
        Whether holes are kept, but for pinholes.

    Raises
    ------
    StarskelError
        If nothing is found, the outline is too rugged, or something given is not among what it may be.

    Examples
    --------
    >>> import numpy as np
    >>> import starskel
    >>> picture = np.zeros((100, 100, 4), dtype=np.uint8)
    >>> picture[20:80, 20:80] = 255
    >>> picture[40:60, 40:60] = 0
    >>> starskel.trace(starskel.PlacedImage(picture))
    Shape of 1 part with 1 hole
    """
    _check_names(image, by, parts)
    _check(level, tolerance)
    chosen = by or usual(image.pixels, level)
    step = -(-max(image.pixels.shape) // TRACED_SIDE)
    values = _values(image.pixels, chosen, step)
    found = _contours(values, level if chosen != "dark" else 1 - level, parts, holes)
    if not found:
        raise StarskelError(
            told(
                "nothing in the picture is {what} enough at a level of {level:g}",
                what=_WORDS[chosen],
                level=level,
            ),
            told("choose another level, or trace something else"),
        )
    kept = shapely.get_parts(_simplified(found, tolerance / step))
    return Shape.of_parts(
        [(_placed(image, p.exterior, step), [_placed(image, h, step) for h in p.interiors]) for p in kept]
    )


def _simplified(found: list[shapely.Polygon], tolerance: float) -> shapely.MultiPolygon:
    simple = shapely.simplify(shapely.MultiPolygon(found), tolerance)
    count = len(shapely.get_coordinates(simple))
    if count > TRACED_VERTICES:
        raise StarskelError(
            told("the outline has {count} vertices", count=count),
            told("choose a larger tolerance: {most} are the most", most=TRACED_VERTICES),
        )
    return simple


def usual(pixels: Pixels, level: float = 0.5) -> By:
    """Give what is traced of a picture where nobody says so."""
    if (pixels[..., 3] < 255).any():
        return "alpha"
    border = np.concatenate([pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]])
    return "dark" if np.median(border[:, :3] @ _LUMA) > 255 * level else "light"


def _check_names(image: object, by: object, parts: object) -> None:
    if not isinstance(image, PlacedImage):
        raise StarskelError(f"a picture of type {type(image).__name__}", "give a PlacedImage")
    if by is not None:
        choice(by, get_args(By), "what is traced")
    choice(parts, get_args(Parts), "the choice of parts")


def _check(level: float, tolerance: float) -> None:
    finite([level, tolerance], 2, "the level and the tolerance")
    if not 0 < level < 1:
        raise StarskelError(f"a level of {level:g}", "give a number between 0 and 1")
    if not 0 <= tolerance < np.inf:
        raise StarskelError(f"a tolerance of {tolerance:g} pixels", "give 0 or more")


def _values(pixels: Pixels, by: By, step: int) -> Floats:
    """Give how much squares of so many pixels a side belong to what is traced, from 0 to 255."""
    height = step * _BAND
    bands = [pixels[top : top + height] for top in range(0, len(pixels), height)]
    return np.concatenate([_shrunk(_seen(band, by), step) for band in bands])


def _seen(pixels: Pixels, by: By) -> Floats:
    """Give how much each pixel belongs to what is traced; transparent ones do not."""
    alpha = pixels[..., 3].astype(np.float64)
    if by == "alpha":
        return alpha
    brightness = sum((pixels[..., k] * _LUMA[k] for k in (1, 2)), pixels[..., 0] * _LUMA[0])
    return np.asarray((255 - brightness if by == "dark" else brightness) * alpha / 255)


def _shrunk(values: Floats, step: int) -> Floats:
    """Give the means of squares of so many pixels a side, 0 outside."""
    if step == 1:
        return values
    height, width = values.shape
    whole = np.pad(values, ((0, -height % step), (0, -width % step)))
    return np.asarray(
        whole.reshape(whole.shape[0] // step, step, whole.shape[1] // step, step).mean(axis=(1, 3))
    )


def _contours(
    values: Floats, level: float, parts: Literal["largest", "all"], holes: bool
) -> list[shapely.Polygon]:
    """Give the regions above a level that count as polygons, the largest first.

    The level is between two values of a byte, so none touch.
    """
    between = np.floor(255 * level) + 0.5 + 1 / 512  # means of squares may be halves
    lines = contourpy.contour_generator(z=np.pad(values, 1), fill_type="ChunkCombinedOffsetOffset")
    chunks = lines.filled(between, np.inf)
    if chunks[0][0] is None:
        return []
    places, (starts, regions) = chunks[0][0], (np.asarray(own[0], dtype=np.intp) for own in chunks[1:])
    rings = np.split(places - 0.5, starts[1:-1])
    kept = _kept(_areas(places, starts), regions, parts, holes)
    count = sum(len(rings[ring]) for region in kept for ring in region)
    if count > TRACED_PLACES:
        raise StarskelError(
            told("the outline changes direction at {count} places", count=count),
            told("smooth the picture or scale it down: {most} are the most", most=TRACED_PLACES),
        )
    return [shapely.Polygon(rings[outline], [rings[hole] for hole in inner]) for outline, *inner in kept]


def _areas(places: Floats, starts: Indices) -> Floats:
    """Give the areas of closed rings that follow each other."""
    x, y = (places - places[0]).T
    steps = x[:-1] * y[1:] - x[1:] * y[:-1]
    steps[starts[1:-1] - 1] = 0  # from one ring to the next
    return np.asarray(np.abs(np.add.reduceat(steps, starts[:-1])) / 2)


def _kept(areas: Floats, regions: Indices, parts: Literal["largest", "all"], holes: bool) -> list[list[int]]:
    """Give the rings of each region, its outline first, without specks and pinholes; the largest comes first.

    Parameters
    ----------
    areas : (k,) array
        Of each ring.
    regions : (m + 1,) array
        Where the rings of each region begin, and the end of the last.
    """
    outlines = areas[regions[:-1]]
    least = LEAST_SHARE * outlines.max()
    net = 2 * outlines - np.add.reduceat(areas, regions[:-1])
    order = np.argsort(-outlines, kind="stable")
    some = order[:1] if parts == "largest" else order[net[order] >= least]
    inner = [np.arange(regions[k] + 1, regions[k + 1]) if holes else np.empty(0, int) for k in some]
    return [[int(regions[k]), *own[areas[own] >= least].tolist()] for k, own in zip(some, inner, strict=True)]


def _placed(image: PlacedImage, ring: shapely.LinearRing, step: int) -> Floats:
    return image.to_document(shapely.get_coordinates(ring)[:-1] * step)
