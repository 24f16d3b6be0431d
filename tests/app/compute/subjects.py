"""What tests have blended."""

from app.compute import Subject
from app.model.marks import Marks
from starskel.files.projects.step import Link
from starskel.polygon import Polygon


def subject(source: Polygon, target: Polygon, marks: Marks = ()) -> Subject:
    """Two shapes of one part each."""
    return Subject((source,), (target,), (Link(0, 0, marks),))
