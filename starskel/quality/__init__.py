"""What is measured of a blend: does it cross itself, how far does it drift, how much is it distorted."""

from starskel.quality.inside import Distortion
from starskel.quality.measure import measure
from starskel.quality.report import Crossing, Report
from starskel.quality.shape_report import ShapeReport

__all__ = ["Crossing", "Distortion", "Report", "ShapeReport", "measure"]
