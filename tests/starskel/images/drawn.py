"""Pictures for the tests, drawn by formulas: smooth, different in every place and channel."""

import numpy as np

from starskel.images.placed import Pixels


def waves(width: int, height: int, phase: float = 0.0, alpha: bool = False) -> Pixels:
    y, x = np.mgrid[:height, :width] + 0.5
    channels = [
        127 + 120 * np.sin(x / 9 + phase) * np.cos(y / 13),
        127 + 120 * np.sin((x + y) / 17 + 1 + phase),
        127 + 120 * np.cos(y / 7 - phase),
        127 + 120 * np.cos(x / 11) if alpha else np.full_like(x, 255),
    ]
    return np.rint(np.stack(channels, axis=-1)).astype(np.uint8)


def noise(width: int, height: int, seed: int = 0) -> Pixels:
    return np.random.default_rng(seed).integers(0, 256, (height, width, 4), dtype=np.uint8)


def premultiplied(pixels: Pixels) -> np.ndarray:
    colours = pixels.astype(np.float64)
    colours[..., :3] *= colours[..., 3:] / 255
    return colours
