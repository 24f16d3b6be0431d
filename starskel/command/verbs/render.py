"""starskel render: a film in any format, as the editor exports it."""

from argparse import Namespace
from pathlib import Path

from starskel.blending import COMPARED
from starskel.command.films import opened_film
from starskel.command.progress import Progress
from starskel.command.written import written_text
from starskel.errors import InvalidFile
from starskel.export.film import Film
from starskel.export.formats import format_for, layouts_of
from starskel.export.layouts import Layout
from starskel.export.settings import Settings, even_times
from starskel.export.write import write
from starskel.sheet.drawing import Colour, Stroke
from starskel.sheet.keyframe import Shown
from starskel.sheet.style import WAY, Look
from starskel.task import Task


def run(arguments: Namespace) -> int:
    """Blend by the methods asked for and write the file, or the files."""
    settings = settings_of(arguments)
    format_for(arguments.output, settings.layout)  # refuses before the work is done
    methods = arguments.method or (COMPARED if settings.layout == "sheet" else ["stitched"])
    name, tracks = opened_film(arguments, methods, measured=settings.layout == "sheet")
    with Progress(arguments.output.name) as bar:
        written = write(arguments.output, Film(name, tracks, settings), Task(bar))
    if arguments.json:
        print(written_text(written), end="")
    return 0


def settings_of(arguments: Namespace) -> Settings:
    """Give what is wanted.

    Raises
    ------
    StarskelError
        If the options do not go together.
    """
    times = tuple(arguments.at or even_times(arguments.frames))
    return Settings(
        layout=arguments.layout or _usual_layout(arguments.output, len(times), arguments.method or []),
        times=times,
        eased=arguments.eased,
        look=_look(arguments),
        shown=Shown(
            arguments.marks,
            arguments.pieces,
            arguments.skeleton,
            arguments.vertices,
            not arguments.no_pictures,
        ),
        duration=arguments.duration,
        returning=arguments.returning,
        rate=arguments.rate,
        pixels=arguments.pixels,
        tolerance=arguments.tolerance,
    )


def _usual_layout(path: Path, frames: int, methods: list[str]) -> Layout:
    """One frame is drawn large; several methods go into a sheet; else what the format usually holds."""
    layouts = layouts_of(path)
    if frames == 1 and "frames" in layouts:
        return "frames"
    if len(methods) > 1 and "sheet" in layouts:
        return "sheet"
    return layouts[0]


def _look(arguments: Namespace) -> Look:
    colours = WAY if arguments.fill is None else tuple(filter(None, arguments.fill))
    if arguments.fill is not None and None in arguments.fill[1:]:
        raise InvalidFile('--fill names colours and "none"', 'give either colours or "none" alone')
    return Look(
        colours=colours,
        outline=_outline(arguments.stroke, arguments.stroke_width),
        paper=arguments.paper,
        gap=arguments.gap,
        margin=arguments.margin,
        size=arguments.size,
        signs=not arguments.no_signs,
        captions=not arguments.plain,
    )


def _outline(colour: Colour | None, width: float) -> Stroke | None:
    return Stroke(colour, width) if colour is not None and width > 0 else None
