"""What was written, told to machines."""

from collections.abc import Sequence
from pathlib import Path

from starskel.files.documents import document_text


def written_text(paths: Sequence[Path], **besides: object) -> str:
    """Give the names of the files written, and what there is to say besides, as JSON."""
    return document_text({"files": [str(path) for path in paths], **besides})
