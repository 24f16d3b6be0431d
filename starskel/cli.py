"""The command: a parser of words. What a verb needs is imported when it runs: --help answers at once."""

import argparse
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

from starskel.blending import METHODS
from starskel.command import FAILED
from starskel.errors import StarskelError

INTERRUPTED = 130
PIPE_BROKEN = 141

_FILE = "a file of pairs (polygon-pairs/1) or a project of the editor"
_SHAPES = "; or of shapes of several polygons (polygon-multi-pairs/1)"
_EXAMPLES = """\
examples:
  starskel blend shapes.json --id letter-C-S --frames 6 -o row.svg
  starskel blend shapes.json --id letter-C-S --at 0.5 -o middle.eps
  starskel blend drawing.json --frames 25 -o flipbook.ps
  starskel compare drawing.json -o sheet.svg
  starskel gallery -o gallery drawing.json shapes.json
  starskel measure shapes.json --json > figures.json
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command and give its exit status: 0, or 2 where something failed.

    Parameters
    ----------
    argv : sequence of str, optional
        The words behind the command's name; else those of the process.
    """
    arguments = _parser().parse_args(argv)
    try:
        status: int = import_module(f"starskel.command.{arguments.verb}").run(arguments)
        sys.stdout.flush()
    except StarskelError as error:
        print(f"starskel: {error}", file=sys.stderr)
        return FAILED
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:
        # The reader of our output has gone. What is still buffered must not fail again at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return PIPE_BROKEN
    return status


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="starskel",
        description="Blend one drawn shape into another by the star-skeleton.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="VERB")
    _add_blend(verbs.add_parser("blend", help="write the keyframes of one method"))
    _add_compare(verbs.add_parser("compare", help="write a sheet of all methods, a row each"))
    _add_gallery(verbs.add_parser("gallery", help="write a page of many pairs, all methods side by side"))
    _add_measure(verbs.add_parser("measure", help="print what is measured of every pair and method"))
    return parser


def _add_blend(parser: argparse.ArgumentParser) -> None:
    parser.description = (
        "Write keyframes: .svg and .eps hold them in a row, .ps one on each page, .json as numbers."
    )
    _add_pair(parser)
    parser.add_argument("--method", choices=METHODS, default="stitched", help="default: stitched")
    _add_times(parser)
    _add_output(parser, ".svg, .eps, .ps or .json")
    parser.add_argument(
        "--separate", action="store_true", help="of shapes of several polygons move each part by itself"
    )
    parser.add_argument("--plain", action="store_true", help="leave the captions out")


def _add_compare(parser: argparse.ArgumentParser) -> None:
    parser.description = "Write a sheet: a row for each method, with its verdict and figures."
    _add_pair(parser)
    _add_methods(parser)
    _add_times(parser)
    _add_output(parser, ".svg, .eps or .ps")


def _add_gallery(parser: argparse.ArgumentParser) -> None:
    parser.description = "Write a page, index.html, and a sheet for each pair with all methods."
    parser.add_argument(
        "files", type=Path, nargs="*", metavar="FILE", help=f"{_FILE}; without any, the program's examples"
    )
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="DIR", help="the folder to write into"
    )
    _add_methods(parser)
    _add_times(parser, 7)


def _add_measure(parser: argparse.ArgumentParser) -> None:
    parser.description = "Print a table over all pairs and methods."
    parser.add_argument("file", type=Path, metavar="FILE", help=_FILE)
    parser.add_argument("--id", action="append", metavar="ID", help="only this pair; may be given again")
    parser.add_argument("--step", type=_step, metavar="N", help="only this step of a project, from 1 (all)")
    _add_methods(parser)
    parser.add_argument(
        "--frames", type=_frame_count, default=101, metavar="N", help="frames looked at (101)"
    )
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")


def _add_pair(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, metavar="FILE", help=_FILE + _SHAPES)
    parser.add_argument("--id", metavar="ID", help="the pair; may be left out where there is but one")
    parser.add_argument("--step", type=_step, metavar="N", help="the step of a project, counted from 1 (1)")


def _add_methods(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--method", action="append", choices=METHODS, help="only this method; may be given again"
    )


def _add_times(parser: argparse.ArgumentParser, count: int = 6) -> None:
    times = parser.add_mutually_exclusive_group()
    words = f"frames, evenly from t = 0 to 1 ({count})"
    times.add_argument("--frames", type=_frame_count, default=count, metavar="N", help=words)
    times.add_argument("--at", type=_time, nargs="+", metavar="T", help="frames at these times instead")


def _add_output(parser: argparse.ArgumentParser, endings: str) -> None:
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="OUT", help=f"the file to write: {endings}"
    )
    parser.add_argument("--marks", action="store_true", help="show the marks as numbered pins")
    parser.add_argument(
        "--pieces", action="store_true", help="show the star pieces, where the method has them"
    )
    parser.add_argument("--skeleton", action="store_true", help="show the skeleton, where the method has one")


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
    try:
        time = float(text)
    except ValueError:
        time = -1.0
    if not 0 <= time <= 1:
        raise argparse.ArgumentTypeError(f"{text!r} is no number from 0 to 1")
    return time
