"""Words that several verbs understand, in groups. Nothing that takes long to load is imported here."""

import argparse
from pathlib import Path
from typing import Any

from starskel.blending import METHODS
from starskel.command import values
from starskel.export import bounds

FILE = "a project of the editor, or a file of pairs (polygon-pairs/1), of shapes too (polygon-multi-pairs/1)"


def add_pair(parser: argparse.ArgumentParser, file: str = FILE) -> None:
    """Let a file be named, and the pair or step in it."""
    parser.add_argument("file", type=Path, metavar="FILE", help=file)
    parser.add_argument("--id", metavar="ID", help="the pair; may be left out where there is but one")
    parser.add_argument(
        "--step", type=values.step, metavar="N", help="only this step of a project, from 1 (all)"
    )


def add_texts(parser: argparse.ArgumentParser) -> None:
    """Let texts be given that a font sets."""
    parser.add_argument(
        "--text",
        action="append",
        default=[],
        metavar="TEXT",
        help="a text to set in a font, as one shape; may be given again (all letters, each a shape)",
    )


def add_json(parser: argparse.ArgumentParser) -> None:
    """Let what was written be told as JSON."""
    parser.add_argument("--json", action="store_true", help="print what was written, as JSON")


def add_methods(parser: argparse.ArgumentParser, words: str = "only this method; may be given again") -> None:
    """Let methods be chosen, one after another."""
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
    times.add_argument("--frames", type=values.frame_count, default=count, metavar="N", help=words)
    times.add_argument("--at", type=values.time, nargs="+", metavar="T", help="frames at these times instead")


def add_overlays(group: argparse._ArgumentGroup) -> None:
    """Offer what may be drawn besides the shapes."""
    group.add_argument("--marks", action="store_true", help="the marks as numbered pins")
    group.add_argument("--vertices", action="store_true", help="the vertices as dots")
    group.add_argument("--pieces", action="store_true", help="the star pieces, where the method has them")
    group.add_argument("--skeleton", action="store_true", help="the skeleton, where the method has one")
    group.add_argument("--no-pictures", action="store_true", help="the shapes, not the pictures in them")
    group.add_argument("--plain", action="store_true", help="no captions")
    group.add_argument("--no-signs", action="store_true", help="no signs where frames cross themselves")


def add_look(group: argparse._ArgumentGroup) -> None:
    """Offer colours, lines and sizes."""
    group.add_argument(
        "--fill",
        type=values.colour,
        nargs="+",
        metavar="COLOUR",
        help='from t = 0 to 1, mixed in between, of parts without colours of their own; or "none"',
    )
    group.add_argument(
        "--stroke", type=values.colour, default="#20262e", metavar="COLOUR", help='outlines; or "none"'
    )
    group.add_argument(
        "--stroke-width", type=values.within(bounds.STROKE), default=0.7, metavar="W", help="(0.7)"
    )
    group.add_argument(
        "--paper", type=values.colour, metavar="COLOUR", help="what is behind (nothing; white in sheets)"
    )
    group.add_argument(
        "--size", type=values.within(bounds.SIZE), metavar="S", help="the longer side of the largest frame"
    )
    group.add_argument(
        "--pixels",
        type=values.pixels,
        metavar="N",
        help="the longer side of pictures of pixels (two for a point)",
    )
    group.add_argument(
        "--margin",
        type=values.within(bounds.DISTANCE),
        default=18.0,
        metavar="M",
        help="round everything (18)",
    )
    group.add_argument(
        "--gap", type=values.within(bounds.DISTANCE), default=16.0, metavar="G", help="between frames (16)"
    )


def add_motion(group: argparse._ArgumentGroup) -> None:
    """Offer how animations run."""
    seconds, rate = values.within(bounds.DURATION), values.within(bounds.RATE)
    group.add_argument("--duration", type=seconds, default=3.0, metavar="S", help="seconds one way (3)")
    group.add_argument("--returning", action="store_true", help="come back again, the same way")
    group.add_argument("--rate", type=rate, default=25.0, metavar="N", help="pictures a second (25)")


def add_tolerance(group: argparse._ArgumentGroup) -> None:
    """Offer how true animations are between their keys."""
    group.add_argument(
        "--tolerance",
        type=values.within(bounds.TOLERANCE),
        default=0.001,
        metavar="E",
        help="how far a vertex may stray between keys, as a part of the box of all frames (0.001)",
    )
