"""Image morphs: pictures inside shapes, blended with them (paper, section 4 and figure 10).

The fans of the star pieces are the local coordinates: a pixel of a frame lies in a triangle, and the same
place of that triangle in source and target tells where to look in both pictures. In detail:

* Colours from outside a shape never come in: pictures are cut along the outline, and continued beyond it by
  the colours inside. Parts of a shape that its picture does not cover are transparent.
* Edges are smooth: a pixel counts by the share of it inside the frame's outline.
* Where a frame crosses itself it is filled as outlines are drawn, wherever the outline goes round. What lies
  over another is decided by the order of pieces, the same at all times; triangles that are folded over are
  under all others, and so only seen where the frame is inside out.
* Of several parts the later ones lie over the earlier.
* Where only one picture is given the shape carries it all the way, at full strength. To fade it in or out
  give a transparent picture for the other one. A part that grows from a point or shrinks to one only has the
  picture of the shape that it belongs to.
"""

from collections.abc import Callable, Collection, Sequence
from functools import cached_property
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from starskel.arguments import choice, whole_number
from starskel.blending.frames import Blend, checked_times
from starskel.decomposition.pieces import Decomposition
from starskel.errors import StarskelError
from starskel.images.carriers import carriers_of
from starskel.images.compositing import Image, Rasterizer, lay, trim
from starskel.images.given import Size, View, checked_share, checked_size, checked_view
from starskel.images.part import PicturedPart, Seen, part_of
from starskel.images.placed import Pixels, PlacedImage
from starskel.images.precise import Precise
from starskel.images.preview import Preview
from starskel.shapes.shape_blend import ShapeBlend
from starskel.task import Progress, ShouldStop, Task

Fade = Callable[[float], float]
"""Gives for each t how much of the target's picture is seen, from 0 to 1."""

Quality = Literal["precise", "preview"]

_LOOKS = 33
"""So many frames are looked at to find a view that shows all of them."""

_MARGIN = 0.02
"""What is left free around them, as a part of the larger extent."""


def smooth(t: float) -> float:
    """Fade slowly near the ends: a frame near an end is sharp."""
    return t * t * (3 - 2 * t)


class ImageMorph:
    """One or two pictures carried along by a blend: what is the same in all frames is prepared once.

    Parameters
    ----------
    blend : Blend or ShapeBlend
        By any method. Those without triangles in their frames, vertex, edge-angle and certified, carry the
        fans of the pair's star pieces along (`starskel.blending.inner_mesh`).
    source, target : PlacedImage, optional
        The pictures, at least one.
    decomposition : Decomposition, optional
        That of the blend's pair, where it is known already.
    fade : callable
        How the pictures fade into each other over t; by default slowly near both ends.
    solid : int
        So near to the outlines, in pixels of the pictures, what is not opaque counts as outside, and gets the
        colours of the inside: where an outline follows the edge of what is drawn only roughly, no
        transparent nicks come in. 0 takes pictures as they are.
    progress, should_stop : callable, optional
        As for `starskel.blend`.

    Raises
    ------
    StarskelError
        If there is no picture, or what is given is none.
    Cancelled
        If ``should_stop`` answered True.

    Examples
    --------
    >>> import numpy as np
    >>> import starskel
    >>> square, kite = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (3, 2), (1, 5), (-1, 2)]
    >>> red = np.full((20, 20, 4), (255, 0, 0, 255), dtype=np.uint8)
    >>> picture = starskel.PlacedImage.in_box(red, middle=(1, 1), size=(2, 2))
    >>> morph = starskel.ImageMorph(starskel.blend(square, kite, marks=[(0, 0)]), picture)
    >>> frames = [morph.at(t, size=64, view=(-1, 0, 3, 5)) for t in (0, 0.5, 1)]
    >>> frames[1].shape, frames[1][32, 25].tolist()
    ((64, 51, 4), [255, 0, 0, 255])
    """

    def __init__(  # noqa: PLR0913 -- a blend, two pictures and how they are mixed
        self,
        blend: Blend | ShapeBlend,
        source: PlacedImage | None = None,
        target: PlacedImage | None = None,
        *,
        decomposition: Decomposition | None = None,
        fade: Fade = smooth,
        solid: int = 0,
        progress: Progress | None = None,
        should_stop: ShouldStop | None = None,
    ) -> None:
        _check_pictures(source, target)
        task = Task(progress, should_stop)
        self.fade = fade
        self.blend = blend
        self._parts: list[PicturedPart] = []
        width = whole_number(solid, "solid", 0)
        carriers = carriers_of(blend, decomposition, task.part(0, 0.7))
        for number, carrier in enumerate(carriers):
            task.reach(0.7 + 0.3 * number / len(carriers))
            self._parts.append(part_of(carrier, source, target, width))
        task.reach(1)

    @cached_property
    def view(self) -> View:
        """A view that shows all frames, and a little around them."""
        looks = np.linspace(0, 1, _LOOKS).tolist()
        nodes = np.concatenate([part.outline_at(t) for part in self._parts for t in looks])
        low, high = nodes.min(axis=0), nodes.max(axis=0)
        margin = _MARGIN * (high - low).max()
        return (*(low - margin).tolist(), *(high + margin).tolist())

    def at(  # noqa: PLR0913 -- a moment, and how it is to be seen
        self,
        t: float,
        size: Size | int = 512,
        view: View | None = None,
        *,
        quality: Quality = "precise",
        premultiplied: bool = False,
        hidden: Collection[int] = (),
    ) -> Pixels:
        """Give the frame at t, an (h, w, 4) array of uint8.

        Parameters
        ----------
        t : float
        size : (int, int) or int
            Width and height in pixels; or the longer of both, the other one as the view asks for.
        view : (float, float, float, float), optional
            What of the document fills the image: left, bottom, right, top. By default `view`.
        quality : {"precise", "preview"}
            Preview is many times faster, for what moves on a screen.
        premultiplied : bool
            Whether colours are multiplied by alpha, as screens want them; else alpha is straight.
        hidden : collection of int
            Parts of a shape that are not painted, by the numbers of their outlines among a frame's rings.

        Raises
        ------
        StarskelError
            Where t is not a number from 0 to 1, or there is something wrong with the size, the view or the
            quality.
        """
        time = float(checked_times([t])[0])
        box = self.view if view is None else checked_view(view)
        width, height = checked_size(size, box)
        choice(quality, get_args(Quality), "the quality")
        seen = Seen(time, (width, height), box, checked_share(self.fade(time)))
        parts = [part for part in self._parts if part.carrier.number not in hidden]
        if quality == "preview":
            pixels = _painted(Preview(), parts, seen, premultiplied)
        else:
            pixels = _painted(Precise(), parts, seen, premultiplied)
        return pixels.reshape(height, width, 4)


def image_morph(  # noqa: PLR0913, PLR0917 -- what is seen, of what, and when
    blend: Blend | ShapeBlend,
    source: PlacedImage | None = None,
    target: PlacedImage | None = None,
    t: float = 0.5,
    size: Size | int = 512,
    view: View | None = None,
    *,
    fade: Fade = smooth,
    solid: int = 0,
) -> Pixels:
    """Give one frame of an image morph, an (h, w, 4) array of uint8 with straight alpha.

    For several frames of one blend `ImageMorph` is faster.

    Parameters
    ----------
    blend : Blend or ShapeBlend
    source, target : PlacedImage, optional
        The pictures, at least one.
    t : float
    size : (int, int) or int
        Width and height in pixels; or the longer of both, the other one as the view asks for.
    view : (float, float, float, float), optional
        What of the document fills the image: left, bottom, right, top. By default what shows all frames.
    fade : callable
        How much of the target's picture is seen at t; by default it fades slowly near both ends.
    solid : int
        So near to the outlines, in pixels of the pictures, what is not opaque is taken from inside.

    Raises
    ------
    StarskelError
        If there is no picture, t is not from 0 to 1, or there is something wrong with the size or the view.

    Examples
    --------
    >>> import numpy as np
    >>> import starskel
    >>> square, kite = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (3, 2), (1, 5), (-1, 2)]
    >>> red = np.full((20, 20, 4), (255, 0, 0, 255), dtype=np.uint8)
    >>> picture = starskel.PlacedImage.in_box(red, middle=(1, 1), size=(2, 2))
    >>> blend = starskel.blend(square, kite, marks=[(0, 0)])
    >>> starskel.image_morph(blend, picture, t=0.5, size=(64, 80)).shape
    (80, 64, 4)
    """
    return ImageMorph(blend, source, target, fade=fade, solid=solid).at(t, size, view)


def _check_pictures(source: object, target: object) -> None:
    if source is None and target is None:
        raise StarskelError("there is no picture", "give one for the source or the target")
    for name, given in (("source", source), ("target", target)):
        if not isinstance(given, PlacedImage | None):
            raise StarskelError(
                f"the picture of the {name} is of type {type(given).__name__}", "give a PlacedImage"
            )


def _painted(
    rasterizer: Rasterizer[Image], parts: Sequence[PicturedPart], seen: Seen, premultiplied: bool
) -> NDArray[np.uint8]:
    count = seen.size[0] * seen.size[1]
    image = rasterizer.blank(count)
    covered = np.zeros(count, dtype=np.float32)
    for part in parts:
        frame = part.frame(seen)
        if frame is None:
            continue
        alone = len(parts) == 1
        front = image if alone else rasterizer.blank(count)
        rasterizer.paint(front, frame.spans, frame.layers, seen.share)
        if alone:
            trim(rasterizer, image, frame.coverage, folded=frame.folded)
        else:
            lay(rasterizer, image, covered, front, frame.coverage)
    return rasterizer.premultiplied(image) if premultiplied else rasterizer.straight(image)
