"""Frames as MP4 video, H.264: with PyAV, which comes with the extra `video`."""

import io
from collections.abc import Iterable, Sequence
from fractions import Fraction
from pathlib import Path

import numpy as np

from starskel.errors import InvalidFile, told
from starskel.files.disk import write_bytes
from starskel.images.placed import Pixels

VIDEO = ".mp4"

_GROUND = 255
"""Video knows no transparency: frames are put on white."""


def write_video(path: Path, frames: Iterable[Pixels], durations: Sequence[float]) -> None:
    """Write frames as video, whole or not at all; as `video_of` makes it.

    Raises
    ------
    InvalidFile
        If PyAV is missing or the file cannot be written.
    """
    write_bytes(path, video_of(frames, durations))


def video_of(frames: Iterable[Pixels], durations: Sequence[float]) -> bytes:
    """Give frames as a video, on white where they are transparent.

    Parameters
    ----------
    frames : iterable of (h, w, 4) arrays
        All of one size, as many as durations. They are taken one by one.
    durations : sequence of float
        How long each is seen, in seconds: in video all equally long, their mean.

    Raises
    ------
    InvalidFile
        If PyAV is missing.
    """
    try:
        import av  # noqa: PLC0415 -- an extra: most people need no video
    except ImportError:
        raise InvalidFile(
            told("writing {ending} needs PyAV", ending=VIDEO),
            told('install it: pip install "starskel[video]"'),
        ) from None
    rate = Fraction(len(durations) / sum(durations)).limit_denominator(1000)
    content = io.BytesIO()
    with av.open(content, "w", format="mp4") as container:
        stream = container.add_stream("libx264", rate=rate)
        stream.pix_fmt = "yuv420p"
        started = False
        for frame in frames:
            picture = _even(frame)
            if not started:
                stream.height, stream.width = picture.shape[:2]
                started = True
            container.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        container.mux(stream.encode(None))
    return content.getvalue()


def _even(frame: Pixels) -> Pixels:
    """Put a frame on the ground, with even sides, as its colours are kept for two by two pixels."""
    alpha = frame[..., 3:] / 255
    mixed = np.rint(frame[..., :3] * alpha + _GROUND * (1 - alpha)).astype(np.uint8)
    height, width = mixed.shape[:2]
    return np.pad(mixed, ((0, height % 2), (0, width % 2), (0, 0)), mode="edge")
