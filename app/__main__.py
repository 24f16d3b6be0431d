"""starskel-editor [FILE]: open the editor."""

import argparse
import os
import sys
from importlib import import_module
from pathlib import Path

from app.surroundings import what_is_missing

FAILED = 2

THREAD_LIMITS = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "OMP_NUM_THREADS")
"""Where numpy, when it is loaded, looks how many threads a product of matrices may take."""


def main() -> int:
    """Run the editor and give its exit status: 0, or 2 where it cannot open a window."""
    parser = argparse.ArgumentParser(
        prog="starskel-editor",
        description="Draw two shapes, mark what corresponds, watch and export the blends.",
    )
    parser.add_argument(
        "file", nargs="?", type=Path, metavar="FILE", help="a project, or a file of pairs (polygon-pairs/1)"
    )
    arguments = parser.parse_args()
    missing = what_is_missing()
    if missing:
        print(f"starskel-editor: {missing}", file=sys.stderr)
        return FAILED
    for name in THREAD_LIMITS:
        # the window needs the other cores, and products as small as ours wait for threads more than they gain
        os.environ.setdefault(name, "1")
    # imported only now: where Qt's libraries are missing this fails, and the message above is clearer
    path = arguments.file and Path(os.path.abspath(arguments.file))
    status: int = import_module("app.view.start").run(path)
    return status


if __name__ == "__main__":
    sys.exit(main())
