"""Files drawn by programs that know nothing of this one, as arrays of grey."""

import shutil
import subprocess

import numpy as np
import pytest
import shapely
from PySide6.QtGui import QImage

from starskel.export.pdf import pdf_document
from starskel.export.postscript import eps_text, postscript_text
from starskel.export.svg import svg_text

DOTS = 2
"""Pixels for one point."""

needs_ghostscript = pytest.mark.skipif(not shutil.which("gs"), reason="Ghostscript (gs) is not installed")
needs_rsvg = pytest.mark.skipif(not shutil.which("rsvg-convert"), reason="rsvg-convert is not installed")


def run(*command, quiet=True):
    done = subprocess.run([str(word) for word in command], capture_output=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert not quiet or done.stderr == b"", done.stderr
    return done.stdout


def write_svg(path, drawing):
    path.write_text(svg_text(drawing), encoding="utf-8")


def write_eps(path, drawing):
    path.write_text(eps_text(drawing))


def write_postscript(path, pages):
    path.write_text(postscript_text(pages))


def write_pdf(path, pages):
    path.write_bytes(pdf_document(pages))


def ghostscript(*arguments):
    return run("gs", "-q", "-dBATCH", "-dNOPAUSE", "-dSAFER", f"-r{72 * DOTS}", *arguments)


def rendered_svg(path):
    """An SVG file on white paper, as (height, width) grey values."""
    image = path.with_suffix(".png")
    run("rsvg-convert", "--dpi-x", 72, "--dpi-y", 72, "-z", DOTS, "-b", "white", "-o", image, path)
    return grey(image)


def rendered_postscript(path, *arguments):
    """The pages of a PostScript or EPS file on white paper, each as (height, width) grey values."""
    ghostscript(
        "-dEPSCrop", "-dGraphicsAlphaBits=4", *arguments, "-sDEVICE=pnggray", f"-o{path}-%d.png", path
    )
    pages = sorted(path.parent.glob(f"{path.name}-*.png"), key=lambda page: int(page.stem.split("-")[-1]))
    return [grey(page) for page in pages]


def painted_box(path):
    """What Ghostscript finds painted on a page: left, lower, right and upper end, in points."""
    command = ["gs", "-q", "-dBATCH", "-dNOPAUSE", "-dSAFER", "-r720", "-sDEVICE=bbox", str(path)]
    report = subprocess.run(command, capture_output=True, text=True, check=True).stderr
    name, *numbers = report.splitlines()[1].split()
    assert name == "%%HiResBoundingBox:"
    return [float(number) for number in numbers]


def grey(path):
    image = QImage(str(path)).convertToFormat(QImage.Format.Format_Grayscale8)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : image.width()].copy()


def assert_filled(picture, ring):
    """Show that only this ring, in points from the lower left, is filled, up to a pixel at its edge."""
    polygon = shapely.Polygon(np.asarray(ring) * DOTS)
    height, width = picture.shape
    x, y = np.meshgrid(np.arange(width) + 0.5, height - np.arange(height) - 0.5)
    inside = shapely.contains_xy(polygon.buffer(-1.5), x, y)
    outside = ~shapely.contains_xy(polygon.buffer(1.5), x, y)
    assert inside.sum() > 100
    assert (picture[inside] < 250).all()
    assert (picture[outside] == 255).all()
