"""The words that each verb understands. Nothing that takes long to load is imported here."""

import argparse
from pathlib import Path

from starskel.blending import METHODS
from starskel.command import values
from starskel.command.option_groups import (
    FILE,
    add_json,
    add_look,
    add_methods,
    add_motion,
    add_overlays,
    add_pair,
    add_texts,
    add_times,
    add_tolerance,
)
from starskel.export import bounds
from starskel.export.formats import FORMATS
from starskel.export.layouts import LAYOUTS

_DRAWING = (
    "a drawing or map (.svg, .geojson, .wkt), a picture whose silhouette is traced (.png, .jpg), a font"
    " (.ttf, .otf), a project or a file of pairs (.json)"
)


def add_render(parser: argparse.ArgumentParser) -> None:
    """Say what render understands."""
    parser.description = (
        "Write what the editor's export writes, to the byte; pictures alone: see morph.\n"
        "The ending of OUT tells the format. Where that holds but one picture each of the\n"
        "frames is a file: OUT-0001 and so on."
    )
    names = [(found.ending, str(found.name), ", ".join(found.layouts)) for found in FORMATS]
    lines = [f"  {ending:6} {name:13} {layouts}" for ending, name, layouts in names]
    parser.epilog = "\n".join(["formats, and the layouts that each can hold:", *lines])
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    add_pair(parser)
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="OUT", help="the file to write")
    add_methods(parser, "this method; may be given again (stitched; in a sheet all)")
    parser.add_argument(
        "--layout",
        choices=LAYOUTS,
        help="all frames in a row; a sheet with a row for each method and its verdict; a picture or page for"
        " each of the frames; an animation; or the numbers (the usual one of the format)",
    )
    add_times(parser)
    parser.add_argument("--eased", action="store_true", help="space frames as they are played, with easing")
    parser.add_argument("--separate", action="store_true", help="move each part of a shape by itself")
    add_json(parser)
    add_overlays(parser.add_argument_group("what is to be seen besides"))
    add_look(parser.add_argument_group("how it looks (lengths in points, colours as #rrggbb)"))
    motion = parser.add_argument_group("animations")
    add_motion(motion)
    add_tolerance(motion)


def add_morph(parser: argparse.ArgumentParser) -> None:
    """Say what morph understands."""
    parser.description = (
        "Write frames of pictures inside shapes. OUT.gif, OUT.apng, OUT.webp and OUT.mp4 move; OUT.png holds"
        " the frames in a row, or is a file for each frame: OUT-0001.png and so on."
    )
    add_pair(parser, "a project with pictures, or a file of pairs of pictures (image-pairs/1)")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="OUT", help="the file to write")
    parser.add_argument(
        "--every", action="store_true", help="a file for each pair, or step of a project: OUT-ID"
    )
    parser.add_argument("--method", choices=METHODS, default="stitched", help="(stitched)")
    parser.add_argument("--layout", choices=("row", "frames"), default="row", help="of OUT.png (row)")
    add_times(parser)
    parser.add_argument("--eased", action="store_true", help="space frames as they are played, with easing")
    parser.add_argument(
        "--fade", choices=("smooth", "even"), default="smooth", help="how pictures fade over (smooth)"
    )
    parser.add_argument(
        "--as-it-is", action="store_true", help="keep what is transparent just inside the outlines"
    )
    parser.add_argument(
        "--pixels", type=values.pixels, default=512, metavar="N", help="the longer side of a frame (512)"
    )
    parser.add_argument(
        "--paper", type=values.colour, metavar="COLOUR", help="what is behind, #rrggbb (nothing)"
    )
    add_json(parser)
    add_motion(parser.add_argument_group("what moves"))


def add_gallery(parser: argparse.ArgumentParser) -> None:
    """Say what gallery understands."""
    parser.description = "Write a page, index.html, and a sheet for each pair with all methods."
    parser.add_argument(
        "files", type=Path, nargs="*", metavar="FILE", help=f"{FILE}; without any, the program's examples"
    )
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="DIR", help="the folder to write into"
    )
    add_methods(parser)
    add_times(parser, 7)
    add_json(parser)


def add_measure(parser: argparse.ArgumentParser) -> None:
    """Say what measure understands."""
    parser.description = "Print a table over all pairs and methods."
    parser.add_argument("file", type=Path, metavar="FILE", help=FILE)
    parser.add_argument("--id", action="append", metavar="ID", help="only this pair; may be given again")
    parser.add_argument(
        "--step", type=values.step, metavar="N", help="only this step of a project, from 1 (all)"
    )
    add_methods(parser)
    parser.add_argument(
        "--frames", type=values.frame_count, default=101, metavar="N", help="frames looked at (101)"
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
    add_texts(parser)
    parser.add_argument(
        "--tolerance",
        type=values.within(bounds.TOLERANCE),
        default=0.0005,
        metavar="E",
        help="how far lines may leave curves, as a part of the box of the shape (0.0005)",
    )
    add_json(parser)


def add_info(parser: argparse.ArgumentParser) -> None:
    """Say what info understands."""
    parser.description = (
        "Print what files hold: their shapes with parts, holes, vertices, size, and what was mended."
    )
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE", help=_DRAWING)
    add_texts(parser)
    parser.add_argument("--json", action="store_true", help="print JSON")


def add_batch(parser: argparse.ArgumentParser) -> None:
    """Say what batch understands."""
    parser.description = (
        "Blend and measure all pairs of a folder or a file, in parallel. RESULTS gets results.jsonl,"
        " a line for each pair, and index.html. Called again it goes on where it was interrupted."
    )
    parser.add_argument(
        "place",
        type=Path,
        metavar="DIR-OR-FILE",
        help='a folder, a project, a file of pairs, or one of lines like {"file": "pairs.json", "id": "a"} or'
        ' {"source": "a.svg", "target": "b.svg"}',
    )
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="RESULTS", help="the folder to fill"
    )
    parser.add_argument("--methods", type=values.methods, metavar="M,M", help="by these methods (all)")
    parser.add_argument(
        "--frames", type=values.frame_count, default=101, metavar="N", help="frames looked at (101)"
    )
    parser.add_argument(
        "--processes", type=values.processes, metavar="N", help="so many at once (one for each processor)"
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
