"""Pictures carried by blends, computed beside the window: for each panel the newest wish, one after another.

Wishes come with every tick of the clock, more of them than can be fulfilled. Each panel has at most one that
waits; a newer one takes its place. What is prepared for a blend is kept while it is shown.
"""

from collections import OrderedDict
from dataclasses import dataclass, replace
from importlib import import_module
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal, Slot

from app.compute.freeing import freeing_factors
from app.compute.threads import thread_named
from starskel.errors import Cancelled, StarskelError
from starskel.files.picture import Picture
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
class Wish:
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
class Shown:
    """A wish fulfilled: its pixels, (h, w, 4), premultiplied; None where the pictures cannot be read."""

    wish: Wish
    pixels: NDArray[np.uint8] | None


class _Painter(QObject):
    """Fulfils wishes, in its own thread."""

    done = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.wanted: dict[str, Carried] = {}
        """What each panel wants now: written by the window, read here, one value at a time."""
        self._prepared: OrderedDict[tuple[Blend | ShapeBlend, Picture | None, Picture | None], ImageMorph] = (
            OrderedDict()
        )

    @Slot(object)
    @freeing_factors()
    def fulfil(self, wish: Wish) -> None:
        try:
            morph = self._morph(wish)
            quality: Quality = "precise" if wish.careful else "preview"
            pixels = morph.at(
                wish.t, wish.size, wish.view, quality=quality, premultiplied=True, hidden=wish.hidden
            )
        except Cancelled:
            self.done.emit(None)
        except StarskelError:
            self.done.emit(Shown(wish, None))
        except BaseException:
            self.done.emit(Shown(wish, None))  # the next wish has its turn, and the fault its report
            raise
        else:
            self.done.emit(Shown(wish, pixels))

    def _morph(self, wish: Wish) -> "ImageMorph":
        """Give what carries the pictures; it is loaded here, so that the window opens sooner."""
        carried = wish.carried
        key = carried.blend, carried.source, carried.target
        if key not in self._prepared:
            made = import_module("starskel.images.morph").ImageMorph(
                carried.blend,
                *(self._placed(picture) for picture in (carried.source, carried.target)),
                decomposition=carried.decomposition,
                solid=SOLID,
                should_stop=lambda: not self._is_wanted(wish),
            )
            self._prepared[key] = made
            while len(self._prepared) > KEPT:
                self._prepared.popitem(last=False)
        self._prepared.move_to_end(key)
        return self._prepared[key]

    def _is_wanted(self, wish: Wish) -> bool:
        wanted = self.wanted.get(wish.panel)
        return wanted is not None and wanted.same(wish.carried)

    def _placed(self, picture: Picture | None) -> object:
        if picture is None:
            return None
        return import_module("starskel.files.image_pairs").placed_image(picture)


class Morphs(QObject):
    """The window's end: takes wishes, passes on what was painted.

    Attributes
    ----------
    busy : bool
        Whether a picture is being painted.
    """

    shown = Signal(object)
    """A `Shown`."""
    _asked = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._waiting: dict[str, Wish] = {}
        self.busy = False
        self._painter = _Painter()
        self._thread = thread_named("pictures", self)
        self._painter.moveToThread(self._thread)
        self._asked.connect(self._painter.fulfil)
        self._painter.done.connect(self._take)

    def wish(self, wish: Wish) -> None:
        """Paint this as soon as the others have had their turn; of each panel only the newest wish counts."""
        self._painter.wanted[wish.panel] = wish.carried
        self._waiting[wish.panel] = wish
        self._go_on()

    def close(self) -> None:
        """Stop and end the thread; to be called before the program ends."""
        self._waiting.clear()
        self._painter.wanted.clear()
        self._thread.quit()
        self._thread.wait()

    @Slot(object)
    def _take(self, shown: Shown | None) -> None:
        self.busy = False
        if shown is not None:
            self.shown.emit(shown)
        self._go_on()

    def _go_on(self) -> None:
        if self.busy or not self._waiting:
            return
        if not self._thread.isRunning():
            self._thread.start()
        self.busy = True
        self._asked.emit(self._waiting.pop(next(iter(self._waiting))))


def finer(wish: Wish) -> Wish:
    """Give the wish for the same, as good as can be."""
    return replace(wish, careful=True)
