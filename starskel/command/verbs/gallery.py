"""starskel gallery: a page of many pairs, all methods side by side."""

import re
import sys
import unicodedata
from argparse import Namespace
from collections.abc import Iterator, Sequence
from pathlib import Path

from starskel.blending import COMPARED
from starskel.command import FAILED
from starskel.command.opening import Opened, named, opened
from starskel.command.progress import Progress
from starskel.command.variants import Variant, blends_of, comparison
from starskel.command.written import written_text
from starskel.errors import StarskelError
from starskel.export.film import Scene
from starskel.export.settings import even_times
from starskel.export.svg import svg_text
from starskel.files.disk import made_folder, write_bytes
from starskel.files.gallery import Exhibit, gallery_page
from starskel.files.pairs import ShapePair
from starskel.files.projects.examples import example_names, resource_folder
from starskel.files.projects.project import AnyPair
from starskel.quality import Report, ShapeReport, measure
from starskel.sheet.comparison import Row, comparison_sheet
from starskel.sheet.keyframe import ALONE
from starskel.sheet.words import counted


def run(arguments: Namespace) -> int:
    """Blend, measure and draw every pair, and write the page; pairs that fail are named, the others go on."""
    folder = made_folder(arguments.output)
    failures: list[str] = []
    found = list(_found(arguments.files or _examples(), failures))
    exhibits: list[Exhibit] = []
    with Progress("") as progress:
        for number, (path, file, pair_id) in enumerate(found):
            try:
                pair = file.pair(pair_id)
                share = number / len(found), 1 / len(found)
                exhibit = _exhibit(pair, arguments, progress, share, {e.name for e in exhibits})
            except StarskelError as error:
                progress.clear()
                failures.append(_told(named(error, pair_id, path)))
                continue
            write_bytes(folder / f"{exhibit.name}.svg", svg_text(exhibit.sheet).encode())
            exhibits.append(exhibit)
    write_bytes(folder / "index.html", gallery_page(exhibits, failures).encode())
    page = folder / "index.html"
    if arguments.json:
        sheets = [folder / f"{exhibit.name}.svg" for exhibit in exhibits]
        print(written_text([page, *sheets], failures=failures), end="")
    else:
        print(f"{page}: {len(exhibits)} of {len(found)} pairs")
    return FAILED if failures else 0


def _examples() -> list[Path]:
    return [resource_folder() / "examples" / f"{name}.json" for name in example_names()]


def _found(paths: Sequence[Path], failures: list[str]) -> Iterator[tuple[Path, Opened, str]]:
    """Give the pairs of all files; those that cannot be opened are told, and kept among the failures."""
    for path in paths:
        try:
            file = opened(path)
        except StarskelError as error:
            failures.append(_told(str(error)))
            continue
        for pair_id in file.ids:
            yield path, file, pair_id


def _told(failure: str) -> str:
    print(f"starskel: {failure}", file=sys.stderr)
    return failure


def _exhibit(
    pair: AnyPair, arguments: Namespace, progress: Progress, share: tuple[float, float], taken: set[str]
) -> Exhibit:
    methods = arguments.method or COMPARED
    times, reports, rows = (
        arguments.at or even_times(arguments.frames),
        dict[str, Report | ShapeReport](),
        list[Row](),
    )

    def watch(method: str, fraction: float) -> None:
        start, length = share
        progress.label = f"{pair.id}: {method}"
        progress(start + length * fraction)

    variants = [*map(Variant, methods), *comparison(pair, methods)]
    for name, blend in blends_of(pair, variants, watch):
        scene = Scene(blend, measure(blend))
        rows.append(scene.row(name, times, ALONE))
        if scene.report is not None and name in methods:
            reports[name] = scene.report
    sheet = comparison_sheet(pair.id, rows, titled=False)
    return Exhibit(_free_name(pair.id, taken), pair.id, _text(pair), sheet, reports)


def _text(pair: AnyPair) -> str:
    sentences = [text.rstrip(".") + "." for text in (pair.description, pair.origin) if text]
    return " ".join([*sentences, _counts(pair)])


def _counts(pair: AnyPair) -> str:
    if isinstance(pair, ShapePair):
        return f"{len(pair.source)} and {len(pair.target)} vertices, {counted(len(pair.marks), 'mark')}."
    rings, vertices = (
        " and ".join(str(count(shape)) for shape in (pair.source, pair.target))
        for count in (len, lambda shape: sum(map(len, shape.rings)))
    )
    return f"{rings} rings, {vertices} vertices, {counted(sum(map(len, pair.marks)), 'mark')}."


def _free_name(title: str, taken: set[str]) -> str:
    """Give a name for files and addresses: plain letters, digits and hyphens, none given twice."""
    plain = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode().lower()
    name = re.sub(r"[^a-z0-9]+", "-", plain).strip("-")[:60] or "pair"
    number, free = 1, name
    while free in taken or free == "index":
        number += 1
        free = f"{name}-{number}"
    return free
