"""Moving pictures read back, frame by frame."""

from pathlib import Path

import numpy as np
from PIL import Image, ImageSequence


def read_animation(path: Path) -> tuple[list[np.ndarray], list[float]]:
    """Give all frames, and how long each is seen, in seconds."""
    with Image.open(path) as image:
        frames = [
            (np.asarray(frame.convert("RGBA")), frame.info.get("duration", 0) / 1000)
            for frame in ImageSequence.Iterator(image)
        ]
    return [pixels for pixels, _ in frames], [seconds for _, seconds in frames]
