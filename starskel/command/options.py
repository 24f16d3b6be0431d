"""The words that each verb understands. Nothing that takes long to load is imported here."""

import argparse
import re
from pathlib import Path
from typing import Any

from starskel.blending import METHODS
from starskel.export.formats import FORMATS
from starskel.export.layouts import LAYOUTS

_FILE = "a project of the editor, or a file of pairs (polygon-pairs/1), of shapes too (polygon-multi-pairs/1)"
_DRAWING = (
    "a drawing or map (.svg, .geojson, .wkt), a picture whose silhouette is traced (.png, .jpg), a font"
    " (.ttf, .otf), a project or a file of pairs (.json)"
)


def add_render(parser: argparse.ArgumentParser) -> None:
    """Say what render understands."""
    formats = ", ".join(f"{found.ending} ({found.name}: {', '.join(found.layouts)})" for found in FORMATS)
    parser.description = (
        "Write what the editor's export writes, to the byte. The ending of OUT tells the format, and what it"
        f" can hold: {formats}. Numbered formats write a file for each frame: OUT-0001 and so on."
    )
    _add_pair(parser)
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="OUT", help="the file to write")
    _add_methods(parser, "this method; may be given again (stitched; in a sheet all)")
    parser.add_argument(
        "--layout",
        choices=LAYOUTS,
        help="all frames in a row; a sheet with a row for each method and its verdict; a picture or page for"
        " each of the frames; an animation; or the numbers (the usual one of the format)",
    )
    add_times(parser)
    parser.add_argument("--eased", action="store_true", help="frames apart as they are played, with easing")
    parser.add_argument("--separate", action="store_true", help="of shapes move each part by itself")
    parser.add_argument("--json", action="store_true", help="print the names of the files written, as JSON")
    _add_overlays(parser.add_argument_group("what is to be seen besides"))
    _add_look(parser.add_argument_group("how it looks (lengths in points, colours as #rrggbb)"))
    _add_motion(parser.add_argument_group("animations"))


def add_morph(parser: argparse.ArgumentParser) -> None:
    """Say what morph understands."""
    parser.description = (
        "Write frames of pictures inside shapes. OUT.gif, OUT.apng, OUT.webp and OUT.mp4 move; OUT.png holds"
        " the frames in a row, or is a file for each frame: OUT-0001.png and so on."
    )
    _add_pair(parser, "a project with pictures, or a file of pairs of pictures (image-pairs/1)")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="OUT", help="the file to write")
    parser.add_argument(
        "--every", action="store_true", help="a file for each pair, or step of a project: OUT-ID"
    )
    parser.add_argument("--method", choices=METHODS, default="stitched", help="(stitched)")
    parser.add_argument("--layout", choices=("row", "frames"), default="row", help="of OUT.png (row)")
    add_times(parser)
    parser.add_argument("--eased", action="store_true", help="frames apart as they are played, with easing")
    parser.add_argument(
        "--fade", choices=("smooth", "even"), default="smooth", help="how pictures fade over (smooth)"
    )
    parser.add_argument(
        "--as-it-is", action="store_true", help="keep what is transparent just inside the outlines"
    )
    parser.add_argument(
        "--size", type=_pixels, default=512, metavar="N", help="pixels of a frame's longer side (512)"
    )
    parser.add_argument("--paper", type=_colour, metavar="COLOUR", help="what is behind, #rrggbb (nothing)")
    group = parser.add_argument_group("what moves")
    group.add_argument("--duration", type=_seconds, default=2.0, metavar="S", help="seconds one way (2)")
    group.add_argument("--returning", action="store_true", help="come back again, the same way")
    group.add_argument("--rate", type=_rate, default=25.0, metavar="N", help="frames a second (25)")


def add_gallery(parser: argparse.ArgumentParser) -> None:
    """Say what gallery understands."""
    parser.description = "Write a page, index.html, and a sheet for each pair with all methods."
    parser.add_argument(
        "files", type=Path, nargs="*", metavar="FILE", help=f"{_FILE}; without any, the program's examples"
    )
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="DIR", help="the folder to write into"
    )
    _add_methods(parser)
    add_times(parser, 7)


def add_measure(parser: argparse.ArgumentParser) -> None:
    """Say what measure understands."""
    parser.description = "Print a table over all pairs and methods."
    parser.add_argument("file", type=Path, metavar="FILE", help=_FILE)
    parser.add_argument("--id", action="append", metavar="ID", help="only this pair; may be given again")
    parser.add_argument("--step", type=_step, metavar="N", help="only this step of a project, from 1 (all)")
    _add_methods(parser)
    parser.add_argument(
        "--frames", type=_frame_count, default=101, metavar="N", help="frames looked at (101)"
    )
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")


def add_convert(parser: argparse.ArgumentParser) -> None:
    """Say what convert understands."""
    parser.description = (
        "Read shapes and write them as another kind of file: .svg, .geojson, .wkt, or .json, a project whose"
        " source and target are the first two shapes, or those named. What was mended goes to standard error."
    )
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE", help=_DRAWING)
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="OUT", help="the file to write")
    parser.add_argument(
        "--shape", action="append", metavar="NAME", help="this shape; may be given again (all)"
    )
    _add_texts(parser)
    parser.add_argument(
        "--tolerance",
        type=_length,
        default=0.0005,
        metavar="E",
        help="how far lines may leave curves, as a part of the box of the shape (0.0005)",
    )


def add_info(parser: argparse.ArgumentParser) -> None:
    """Say what info understands."""
    parser.description = (
        "Print what files hold: their shapes with parts, holes, vertices, size, and what was mended."
    )
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE", help=_DRAWING)
    _add_texts(parser)
    parser.add_argument("--json", action="store_true", help="print JSON")


def add_batch(parser: argparse.ArgumentParser) -> None:
    """Say what batch understands."""
    parser.description = (
        "Blend and measure all pairs of a folder, or of a manifest, in parallel. RESULTS gets results.jsonl,"
        " a line for each pair, and index.html. Called again it goes on where it was interrupted."
    )
    parser.add_argument(
        "place",
        type=Path,
        metavar="DIR-OR-MANIFEST",
        help='a folder, or a file of lines like {"file": "pairs.json", "id": "a"} or'
        ' {"source": "a.svg", "target": "b.svg"}',
    )
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="RESULTS", help="the folder to fill"
    )
    parser.add_argument("--methods", type=_methods, metavar="M,M", help="by these methods (all)")
    parser.add_argument(
        "--frames", type=_frame_count, default=101, metavar="N", help="frames looked at (101)"
    )
    parser.add_argument(
        "--processes", type=_step, metavar="N", help="so many at once (one for each processor)"
    )
    parser.add_argument(
        "--scheduler", metavar="ADDRESS", help="on the Dask cluster of this scheduler instead"
    )
    parser.add_argument("--retry", action="store_true", help="try pairs again that failed before")
    parser.add_argument("--json", action="store_true", help="print JSON at the end")


def add_completion(parser: argparse.ArgumentParser) -> None:
    """Say what completion understands."""
    parser.description = (
        'Print a script that lets a shell complete words. For bash: eval "$(starskel completion bash)"'
    )
    parser.add_argument("shell", choices=("bash", "zsh", "fish", "tcsh", "powershell"))


def _add_pair(parser: argparse.ArgumentParser, file: str = _FILE) -> None:
    parser.add_argument("file", type=Path, metavar="FILE", help=file)
    parser.add_argument("--id", metavar="ID", help="the pair; may be left out where there is but one")
    parser.add_argument("--step", type=_step, metavar="N", help="only this step of a project, from 1 (all)")


def _add_texts(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--text",
        action="append",
        default=[],
        metavar="TEXT",
        help="of a font this text, as one shape; may be given again (its letters, each a shape)",
    )


def _add_methods(
    parser: argparse.ArgumentParser, words: str = "only this method; may be given again"
) -> None:
    parser.add_argument("--method", action=_Another, choices=METHODS, help=words)


class _Another(argparse.Action):
    """Takes one value more, which was not given before."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: Any,
        option_string: str | None = None,
    ) -> None:
        before = getattr(namespace, self.dest) or []
        if values in before:
            raise argparse.ArgumentError(self, f"{values} is given twice")
        setattr(namespace, self.dest, [*before, values])


def add_times(parser: argparse.ArgumentParser, count: int = 6) -> None:
    """Let frames be chosen by their number or by their times."""
    times = parser.add_mutually_exclusive_group()
    words = f"frames, evenly from t = 0 to 1 ({count})"
    times.add_argument("--frames", type=_frame_count, default=count, metavar="N", help=words)
    times.add_argument("--at", type=_time, nargs="+", metavar="T", help="frames at these times instead")


def _add_overlays(group: argparse._ArgumentGroup) -> None:
    group.add_argument("--marks", action="store_true", help="the marks as numbered pins")
    group.add_argument("--vertices", action="store_true", help="the vertices as dots")
    group.add_argument("--pieces", action="store_true", help="the star pieces, where the method has them")
    group.add_argument("--skeleton", action="store_true", help="the skeleton, where the method has one")
    group.add_argument("--no-pictures", action="store_true", help="the shapes, not the pictures in them")
    group.add_argument("--plain", action="store_true", help="no captions")
    group.add_argument(
        "--no-signs", action="store_true", help="nothing that tells where frames cross themselves"
    )


def _add_look(group: argparse._ArgumentGroup) -> None:
    group.add_argument(
        "--fill",
        type=_colour,
        nargs="+",
        metavar="COLOUR",
        help='from t = 0 to 1, mixed in between; or "none"',
    )
    group.add_argument(
        "--stroke", type=_colour, default="#20262e", metavar="COLOUR", help='outlines; or "none"'
    )
    group.add_argument("--stroke-width", type=_length, default=0.7, metavar="W", help="(0.7)")
    group.add_argument(
        "--paper", type=_colour, metavar="COLOUR", help="what is behind (nothing; white in sheets)"
    )
    group.add_argument("--size", type=_length, metavar="S", help="the longer side of the largest frame")
    group.add_argument(
        "--pixels", type=_pixels, metavar="N", help="the longer side of pictures of pixels (two for a point)"
    )
    group.add_argument("--margin", type=_length, default=18.0, metavar="M", help="round everything (18)")
    group.add_argument("--gap", type=_length, default=16.0, metavar="G", help="between frames (16)")


def _add_motion(group: argparse._ArgumentGroup) -> None:
    group.add_argument("--duration", type=_length, default=3.0, metavar="S", help="seconds one way (3)")
    group.add_argument("--returning", action="store_true", help="come back again, the same way")
    group.add_argument("--rate", type=_length, default=25.0, metavar="N", help="pictures a second (25)")
    group.add_argument(
        "--tolerance",
        type=_length,
        default=0.001,
        metavar="E",
        help="how far a vertex may stray between keys, as a part of the box of all frames (0.001)",
    )


def _methods(text: str) -> tuple[str, ...]:
    methods = tuple(text.split(","))
    if len(set(methods)) < len(methods):
        raise argparse.ArgumentTypeError("a method is given twice")
    for method in methods:
        if method not in METHODS:
            raise argparse.ArgumentTypeError(f"invalid choice: {method!r} (choose from {', '.join(METHODS)})")
    return methods


def _step(text: str) -> int:
    if not text.isdecimal() or not int(text):
        raise argparse.ArgumentTypeError(f"{text!r} is no number of a step: they count from 1")
    return int(text)


def _frame_count(text: str) -> int:
    try:
        count = int(text)
    except ValueError:
        count = 0
    if count < 2:
        raise argparse.ArgumentTypeError(f"{text!r} is no whole number above 1 (for one frame: --at T)")
    return count


def _time(text: str) -> float:
    time = _number(text)
    if not 0 <= time <= 1:
        raise argparse.ArgumentTypeError(f"{text!r} is no number from 0 to 1")
    return time


def _length(text: str) -> float:
    length = _number(text)
    if not 0 <= length < float("inf"):
        raise argparse.ArgumentTypeError(f"{text!r} is no number from 0 on")
    return length


def _pixels(text: str) -> int:
    return round(_within(text, 1, 8192, "number of pixels"))


def _seconds(text: str) -> float:
    return _within(text, 0.01, 600, "number of seconds")


def _rate(text: str) -> float:
    return _within(text, 0.1, 120, "number of frames a second")


def _within(text: str, least: float, most: float, what: str) -> float:
    number = _number(text)
    if not least <= number <= most:
        raise argparse.ArgumentTypeError(f"{text!r} is no {what} from {least:g} to {most:g}")
    return number


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return -1.0


def _colour(text: str) -> str | None:
    if text == "none":
        return None
    if not re.fullmatch(r"#[0-9a-fA-F]{6}", text):
        raise argparse.ArgumentTypeError(f'{text!r} is no colour: write it as #rrggbb, or "none"')
    return text.lower()
