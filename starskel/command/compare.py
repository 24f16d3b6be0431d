"""starskel compare: a sheet of all methods."""

from argparse import Namespace

from starskel.blending import COMPARED
from starskel.command.blend import shown_of, times_of
from starskel.command.methods import blends
from starskel.command.opening import chosen_pair
from starskel.command.output import WRITERS, ending_of
from starskel.command.shapes import compare_shapes
from starskel.files import multi_pairs
from starskel.files.documents import format_of
from starskel.quality import measure
from starskel.sheet.comparison import Row, comparison_sheet
from starskel.sheet.keyframe import keyframes


def run(arguments: Namespace) -> int:
    """Blend the pair by every method and write the sheet."""
    ending = ending_of(arguments.output, tuple(WRITERS))
    if format_of(arguments.file) == multi_pairs.FORMAT:
        return compare_shapes(arguments, ending, times_of(arguments))
    pair = chosen_pair(arguments.file, arguments.id, arguments.step)
    times, shown = times_of(arguments), shown_of(arguments)
    rows = []
    for method, blend in blends(pair, arguments.method or COMPARED):
        rows.append(Row.of(method, measure(blend), keyframes(blend, times, shown)))
    WRITERS[ending](arguments.output, comparison_sheet(pair.id, rows))
    return 0
