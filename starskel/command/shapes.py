"""What blend and compare do with files of pairs of shapes."""

from argparse import Namespace
from collections.abc import Iterator, Sequence

from starskel.blending import COMPARED
from starskel.command.output import WRITERS, write_keyframes
from starskel.command.progress import Progress
from starskel.errors import InvalidFile
from starskel.files.frames import write_shape_frames
from starskel.files.multi_pairs import MultiPair, MultiPairsFile, read_multi_pairs
from starskel.quality import measure
from starskel.shapes.blend import blend
from starskel.shapes.match import match
from starskel.shapes.shape_blend import ShapeBlend
from starskel.sheet.comparison import Row, comparison_sheet
from starskel.sheet.shape_keyframe import shape_keyframes


def blend_shapes(arguments: Namespace, ending: str, times: list[float]) -> int:
    """Blend the shapes by the method and write the keyframes."""
    pair = _chosen(arguments)
    ways = [(arguments.method, arguments.method, not arguments.separate)]
    ((_, made),) = _blends(pair, ways)
    if ending == ".json":
        write_shape_frames(arguments.output, arguments.method, times, made.pair.outer, made.frames(times))
    else:
        frames = shape_keyframes(made, times, arguments.skeleton)
        write_keyframes(arguments, ending, f"{pair.id}: {arguments.method}", frames)
    return 0


def compare_shapes(arguments: Namespace, ending: str, times: list[float]) -> int:
    """Blend the shapes by every method that can, by the first also part by part; write the sheet."""
    pair = _chosen(arguments)
    holed = any(outer >= 0 for outer in (*pair.source.outer, *pair.target.outer))
    usual = [method for method in COMPARED if not (holed and method == "certified")]
    methods = arguments.method or usual
    ways = [*((method, method, True) for method in methods), ("parts separately", methods[0], False)]
    rows = []
    for name, made in _blends(pair, ways):
        frames = shape_keyframes(made, times, arguments.skeleton)
        rows.append(Row.of_shapes(name, measure(made), frames))
    WRITERS[ending](arguments.output, comparison_sheet(pair.id, rows))
    return 0


def _chosen(arguments: Namespace) -> MultiPair:
    if arguments.marks or arguments.pieces:
        raise InvalidFile(
            f"{arguments.file} holds shapes of several polygons, on which marks and pieces are not drawn",
            "leave out --marks and --pieces",
        )
    if arguments.step is not None:
        raise InvalidFile(f"{arguments.file} is no project and has no steps", "choose a pair: --id ID")
    file = read_multi_pairs(arguments.file)
    return file.pair(arguments.id or _only(file))


def _only(file: MultiPairsFile) -> str:
    if len(file.ids) > 1:
        raise InvalidFile(
            f"{file.path} holds {len(file.ids)} pairs", f"choose one: --id {' | '.join(file.ids)}"
        )
    return file.ids[0]


def _blends(pair: MultiPair, ways: Sequence[tuple[str, str, bool]]) -> Iterator[tuple[str, ShapeBlend]]:
    """Blend a pair in several ways, each a name, a method and whether a meta-skeleton joins the parts."""
    matched = match(pair.source, pair.target, pair.marks, pairing=pair.pairing, places=pair.places)
    for name, method, joined in ways:
        with Progress(f"{pair.id}: {name}") as bar:
            made = blend(matched, method=method, joined=joined, progress=bar)
        yield name, made
