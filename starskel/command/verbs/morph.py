"""starskel morph: pictures inside shapes, as a moving picture, a row of frames or numbered files."""

from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path

from starskel.command.opening import Opened, Pictures, chosen_id, opened
from starskel.command.progress import Progress
from starskel.command.variants import Variant, blends_of
from starskel.command.written import written_text
from starskel.easing import EVEN, Easing
from starskel.errors import InvalidFile
from starskel.export.morphs import PNG, MorphSettings, check_ending, write_morph
from starskel.export.settings import Settings, even_times
from starskel.files.file_name import file_names_of
from starskel.images.morph import ImageMorph, smooth
from starskel.images.placed import SOLID
from starskel.task import Task


def run(arguments: Namespace) -> int:
    """Morph the pictures of a pair, or of every pair, and write the frames."""
    check_ending(arguments.output)
    file = opened(arguments.file, arguments.step)
    if arguments.every:
        paths = dict(zip(file.ids, _own_files(arguments.output, file.ids), strict=True))
    else:
        paths = {chosen_id(arguments.file, file.ids, arguments.id): arguments.output}
    written = [own for pair_id, path in paths.items() for own in _morph(arguments, file, pair_id, path)]
    if arguments.json:
        print(written_text(written), end="")
    return 0


def _morph(arguments: Namespace, file: Opened, pair_id: str, path: Path) -> tuple[Path, ...]:
    pair, pictures = file.pair(pair_id), _pictures(arguments.file, file, pair_id)
    ((_, made),) = blends_of(pair, [Variant(arguments.method)])
    fade, solid = (smooth if arguments.fade == "smooth" else float), (0 if arguments.as_it_is else SOLID)
    with Progress(f"{pair_id}: pictures") as bar:
        morph = ImageMorph(made, *pictures, fade=fade, solid=solid, progress=bar)
    wanted = MorphSettings(
        _times(arguments, path, file.steps[file.ids.index(pair_id)].easing if file.steps else EVEN),
        arguments.pixels,
        arguments.rate,
        arguments.paper,
        numbered=arguments.layout == "frames",
        hidden=[number for number, look in enumerate(file.looks(pair_id)) if not look.visible],
    )
    with Progress(f"{pair_id}: frames") as bar:
        return write_morph(path, morph, wanted, Task(bar))


def _pictures(path: Path, file: Opened, pair_id: str) -> Pictures:
    found = file.pictures(pair_id)
    if found == (None, None):
        raise InvalidFile(
            f'{path} has no picture behind the shapes of "{pair_id}"', "place one in the editor and save"
        )
    return found


def _times(arguments: Namespace, path: Path, easing: Easing) -> list[float]:
    """Give the times of frames: those asked for, or for what moves as many as its duration needs."""
    if arguments.at:
        times = list(arguments.at)
    elif path.suffix.lower() == PNG:
        times = list(even_times(arguments.frames))
    else:
        moving = Settings(
            "animation", duration=arguments.duration, returning=arguments.returning, rate=arguments.rate
        )
        times = list(moving.moments)
    return [easing.t(time) for time in times] if arguments.eased else times


def _own_files(path: Path, ids: Sequence[str]) -> list[Path]:
    """Give a file for each pair, its name behind the file's."""
    return [path.with_name(f"{path.stem}-{name}{path.suffix}") for name in file_names_of(ids)]
