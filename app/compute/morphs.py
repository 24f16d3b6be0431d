"""Pictures carried by blends, computed beside the window: for each panel the newest request, one by one.

Requests come with every tick of the clock, more of them than can be met. Each panel has at most one that
waits; a newer one takes its place. What is prepared for a blend is kept while it is shown.
"""

from collections import OrderedDict
from dataclasses import dataclass, replace
from importlib import import_module
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal, Slot

from app.compute.threads import thread_named
from starskel.errors import Cancelled, StarskelError
from starskel.files.projects.picture import Picture
from starskel.images.placed import SOLID

if TYPE_CHECKING:  # what blends and paints is loaded by the worker, so that the window opens sooner
    from starskel import Blend, Decomposition, ShapeBlend
    from starskel.images.morph import ImageMorph, Quality

KEPT = 8
"""So many blends keep what was prepared for their pictures."""

View = tuple[float, float, float, float]


@dataclass(frozen=True, eq=False)
class Carried:
    """The pictures that a blend carries.

    Attributes
    ----------
    blend : Blend or ShapeBlend
    source, target : Picture or None
        At least one of them is there.
    decomposition : Decomposition or None
        That of the blend's pair, where it is known already.
    """

    blend: "Blend | ShapeBlend"
    source: Picture | None
    target: Picture | None
    decomposition: "Decomposition | None" = None

    def same(self, other: "Carried") -> bool:
        """Tell whether another one looks the same."""
        return self.blend is other.blend and (self.source, self.target) == (other.source, other.target)


@dataclass(frozen=True, eq=False)
class MorphRequest:
    """What a panel wants to show.

    Attributes
    ----------
    panel : str
        Which one.
    carried : Carried
    t : float
    size : (int, int)
        Width and height in pixels.
    view : (float, float, float, float)
        What of the document is seen: left, bottom, right, top.
    hidden : tuple of int
        Parts that are not to be seen, by the numbers of their links.
    careful : bool
        Whether it is to be as good as can be: what stands still.
    """

    panel: str
    carried: Carried
    t: float
    size: tuple[int, int]
    view: View
    hidden: tuple[int, ...] = ()
    careful: bool = False


@dataclass(frozen=True, eq=False)
class PaintedMorph:
    """A request fulfilled: its pixels, (h, w, 4), premultiplied; None where the pictures cannot be read."""

    request: MorphRequest
    pixels: NDArray[np.uint8] | None


class _Painter(QObject):
    """Fulfils requests, in its own thread."""

    done = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.wanted: dict[str, Carried] = {}
        """What each panel wants now: written by the window, read here, one value at a time."""
        self._prepared: OrderedDict[tuple[Blend | ShapeBlend, Picture | None, Picture | None], ImageMorph] = (
            OrderedDict()
        )

    @Slot(object)
    def fulfil(self, request: MorphRequest) -> None:
        try:
            morph = self._morph(request)
            quality: Quality = "precise" if request.careful else "preview"
            pixels = morph.at(
                request.t,
                request.size,
                request.view,
                quality=quality,
                premultiplied=True,
                hidden=request.hidden,
            )
        except Cancelled:
            self.done.emit(None)
        except StarskelError:
            self.done.emit(PaintedMorph(request, None))
        except BaseException:
            self.done.emit(PaintedMorph(request, None))  # the next has its turn, and the fault its report
            raise
        else:
            self.done.emit(PaintedMorph(request, pixels))

    def _morph(self, request: MorphRequest) -> "ImageMorph":
        """Give what carries the pictures; it is loaded here, so that the window opens sooner."""
        carried = request.carried
        key = carried.blend, carried.source, carried.target
        if key not in self._prepared:
            made = import_module("starskel.images.morph").ImageMorph(
                carried.blend,
                *(self._placed(picture) for picture in (carried.source, carried.target)),
                decomposition=carried.decomposition,
                solid=SOLID,
                should_stop=lambda: not self._is_wanted(request),
            )
            self._prepared[key] = made
            while len(self._prepared) > KEPT:
                self._prepared.popitem(last=False)
        self._prepared.move_to_end(key)
        return self._prepared[key]

    def _is_wanted(self, request: MorphRequest) -> bool:
        wanted = self.wanted.get(request.panel)
        return wanted is not None and wanted.same(request.carried)

    def _placed(self, picture: Picture | None) -> object:
        if picture is None:
            return None
        return import_module("starskel.files.image_pairs").placed_image(picture)


class Morphs(QObject):
    """The window's end: takes requests, passes on what was painted.

    Attributes
    ----------
    busy : bool
        Whether a picture is being painted.
    """

    painted = Signal(object)
    """A `PaintedMorph`."""
    _asked = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._waiting: dict[str, MorphRequest] = {}
        self.busy = False
        self._painter = _Painter()
        self._thread = thread_named("pictures", self)
        self._painter.moveToThread(self._thread)
        self._asked.connect(self._painter.fulfil)
        self._painter.done.connect(self._take)

    def paint(self, request: MorphRequest) -> None:
        """Paint this as soon as the others have had their turn; of each panel only the newest one counts."""
        self._painter.wanted[request.panel] = request.carried
        self._waiting[request.panel] = request
        self._go_on()

    def close(self) -> None:
        """Stop and end the thread; to be called before the program ends."""
        self._waiting.clear()
        self._painter.wanted.clear()
        self._thread.quit()
        self._thread.wait()

    @Slot(object)
    def _take(self, painted: PaintedMorph | None) -> None:
        self.busy = False
        if painted is not None:
            self.painted.emit(painted)
        self._go_on()

    def _go_on(self) -> None:
        if self.busy or not self._waiting:
            return
        if not self._thread.isRunning():
            self._thread.start()
        self.busy = True
        self._asked.emit(self._waiting.pop(next(iter(self._waiting))))


def finer(request: MorphRequest) -> MorphRequest:
    """Give the request for the same, as good as can be."""
    return replace(request, careful=True)
