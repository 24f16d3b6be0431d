# PYTHON_ARGCOMPLETE_OK
"""The command: a parser of words. What a verb needs is imported when it runs: --help answers at once."""

import argparse
import os
import sys
from collections.abc import Sequence
from importlib import import_module

from starskel.command import FAILED, options
from starskel.errors import StarskelError

INTERRUPTED = 130
PIPE_BROKEN = 141

_EXAMPLES = """\
examples:
  starskel render drawing.json --frames 7 -o row.svg
  starskel render shapes.json --id letter-C-S --at 0.5 -o middle.eps
  starskel render drawing.json --frames 25 -o flipbook.pdf
  starskel render drawing.json --layout animation --returning -o moving.svg
  starskel render drawing.json --layout sheet -o methods.svg
  starskel morph pictures.json --returning -o morph.gif
  starskel gallery drawing.json shapes.json -o gallery
  starskel measure shapes.json --json > figures.json
  starskel convert icons.svg --shape heart --shape star -o drawing.json

exit status: 0 done, 2 something is wrong with what was given (of batch, gallery, info and measure: something
failed, all else is done), 130 interrupted, 141 nobody reads the output
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command and give its exit status: 0, or 2 where something failed.

    Parameters
    ----------
    argv : sequence of str, optional
        The words behind the command's name; else those of the process.
    """
    parser = command_parser()
    if "_ARGCOMPLETE" in os.environ:  # a shell asks how a word may go on
        import_module("argcomplete").autocomplete(parser)
    arguments = parser.parse_args(argv)
    try:
        status: int = import_module(f"starskel.command.verbs.{arguments.verb}").run(arguments)
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


class _Version(argparse.Action):
    """Prints the version; it is looked up only then."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        version = import_module("importlib.metadata").version("starskel")
        print(f"starskel {version}")
        parser.exit()


def command_parser() -> argparse.ArgumentParser:
    """Give the parser of all verbs."""
    parser = argparse.ArgumentParser(
        prog="starskel",
        description="Blend one drawn shape into another by the star-skeleton.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action=_Version, nargs=0, help="print the version and exit")
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="VERB")
    for verb, words, add in _VERBS:
        add(verbs.add_parser(verb, help=words))
    return parser


_VERBS = (
    (
        "render",
        "write what the editor's export writes: keyframes, sheets, animations, numbers",
        options.add_render,
    ),
    ("morph", "write frames of pictures inside shapes, side by side or moving", options.add_morph),
    ("gallery", "write a page of many pairs, all methods side by side", options.add_gallery),
    (
        "convert",
        "write shapes of drawings and maps as another kind of file, or as a project",
        options.add_convert,
    ),
    ("info", "print what files hold", options.add_info),
    ("measure", "print what is measured of every pair and method", options.add_measure),
    ("batch", "blend and measure thousands of pairs in parallel; it can be resumed", options.add_batch),
    ("completion", "print the script that lets a shell complete words", options.add_completion),
)
"""Each verb, what it does, and what it understands; the module of its name in command/verbs runs it."""
