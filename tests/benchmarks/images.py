"""How fast pictures are carried: frames a second for the screen, and the time of careful ones beside it."""

import numpy as np

import starskel
from tests.benchmarks.decomposing import paired
from tests.benchmarks.timing import seconds, table
from tests.families import blob

TIMES = (0.2, 0.5, 0.8)


def pictures() -> None:
    rows, first = [], {}
    for n in (50, 200, 800):
        pair = paired(blob(n, 1), blob(n, 2))
        blend = starskel.blend(pair, method="stitched")
        placed = [_placed(ring, seed) for seed, ring in enumerate((pair.source, pair.target))]
        morph = starskel.ImageMorph(blend, *placed)
        view = morph.view
        for size in (256, 512, 1024):
            fast, careful = (
                seconds(
                    lambda q=q, m=morph, s=size, v=view: [
                        m.at(t, s, v, quality=q, premultiplied=q == "preview") for t in TIMES
                    ]
                )
                / len(TIMES)
                for q in ("preview", "precise")
            )
            first.setdefault("fast", fast)
            rows.append(
                (size, len(blend.mesh.triangles), fast * 1e3, 1 / fast, fast / first["fast"], careful * 1e3)
            )
    heads = ("pixels a side", "triangles", "preview ms", "frames/s", "times least", "precise ms")
    table("Image morphs of two pictures, 1024 pixels a side", heads, rows)


def _placed(ring: np.ndarray, seed: int) -> starskel.PlacedImage:
    pixels = np.random.default_rng(seed).integers(0, 256, (1024, 1024, 4), dtype=np.uint8)
    low, high = ring.min(axis=0), ring.max(axis=0)
    return starskel.PlacedImage.in_box(pixels, tuple((low + high) / 2), tuple(high - low))
