"""What the library hands out stays what it was proven to be: its arrays cannot be written to."""

from collections.abc import Iterator

import numpy as np
import pytest

import starskel

SQUARE = [(0, 0), (8, 0), (8, 8), (0, 8)]
KITE = [(1, 0), (3, 2), (1, 5), (-1, 2)]
FRAME = starskel.Shape([SQUARE, [(2, 2), (6, 2), (6, 6), (2, 6)]])


def arrays_of(carrier: object, name: str) -> Iterator[tuple[str, np.ndarray]]:
    """All arrays within public fields, with their names."""
    if isinstance(carrier, np.ndarray):
        yield name, carrier
    elif isinstance(carrier, tuple):
        for number, item in enumerate(carrier):
            yield from arrays_of(item, f"{name}[{number}]")
    elif type(carrier).__module__.startswith("starskel"):
        for key, value in vars(carrier).items():
            if not key.startswith("_"):
                yield from arrays_of(value, f"{name}.{key}")


@pytest.mark.parametrize("method", starskel.METHODS)
@pytest.mark.parametrize("ends", [(SQUARE, KITE), (FRAME, FRAME)], ids=["polygons", "shapes"])
def test_what_is_handed_out_cannot_be_written_to(ends, method):
    blend = starskel.blend(*ends, method=method)
    carriers = {"blend": blend, "report": starskel.measure(blend, 5), "rings": blend.pair.ring_pairs}
    if ends[0] is SQUARE:
        carriers |= {"exchanged": blend.pair.exchanged, "decomposition": blend.decomposition}
    found = dict(array for name, carrier in carriers.items() for array in arrays_of(carrier, name))
    assert len(found) > 8
    assert [name for name, array in found.items() if array.flags.writeable] == []


def test_frames_belong_to_who_asked_for_them():
    blend = starskel.blend(SQUARE, KITE)
    for t in (0, 0.5, 1):
        frame = blend.at(t)
        before = frame.copy()
        frame[:] = 0
        np.testing.assert_array_equal(blend.at(t), before)
