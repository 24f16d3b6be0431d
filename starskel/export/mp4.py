"""MP4 out: video, on white where no paper is wanted. It needs the extra `video`."""

from collections.abc import Iterator

from starskel.export.film import Film
from starskel.export.pixels import durations, moving
from starskel.files.video import video_of
from starskel.task import Task


def files(film: Film, task: Task) -> Iterator[bytes]:
    """Give the film as one file."""
    yield video_of(moving(film, task), durations(film))
