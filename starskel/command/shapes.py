"""What render does with files of pairs of shapes."""

from argparse import Namespace
from collections.abc import Iterator, Sequence

from starskel.command.opening import chosen_id
from starskel.command.progress import Progress
from starskel.errors import InvalidFile
from starskel.export.film import Scene, Track
from starskel.files.multi_pairs import MultiPair, read_multi_pairs
from starskel.quality import measure
from starskel.shapes.blend import blend
from starskel.shapes.match import match
from starskel.shapes.shape_blend import ShapeBlend


def shape_tracks(
    arguments: Namespace, methods: Sequence[str], *, measured: bool
) -> tuple[str, tuple[Track, ...]]:
    """Blend the shapes by every method; a sheet of all shows the first also part by part."""
    pair = _chosen(arguments)
    ways = [(method, method, not arguments.separate) for method in methods]
    if measured:
        ways.append(("parts separately", methods[0], False))
    tracks = []
    for name, made in _blends(pair, ways):
        report = measure(made) if measured else None
        tracks.append(Track(name, (Scene(made, report),)))
    return pair.id, tuple(tracks)


def _chosen(arguments: Namespace) -> MultiPair:
    if arguments.marks or arguments.pieces:
        raise InvalidFile(
            f"{arguments.file} holds shapes of several polygons, on which marks and pieces are not drawn",
            "leave out --marks and --pieces",
        )
    if arguments.step is not None:
        raise InvalidFile(f"{arguments.file} is no project and has no steps", "choose a pair: --id ID")
    file = read_multi_pairs(arguments.file)
    return file.pair(chosen_id(arguments.file, file.ids, arguments.id))


def _blends(pair: MultiPair, ways: Sequence[tuple[str, str, bool]]) -> Iterator[tuple[str, ShapeBlend]]:
    """Blend a pair in several ways, each a name, a method and whether a meta-skeleton joins the parts."""
    matched = match(pair.source, pair.target, pair.marks, pairing=pair.pairing, places=pair.places)
    for name, method, joined in ways:
        with Progress(f"{pair.id}: {name}") as bar:
            made = blend(matched, method=method, joined=joined, progress=bar)
        yield name, made
