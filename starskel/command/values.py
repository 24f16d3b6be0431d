"""What words of the command stand for: each function reads one kind, or says what it should be."""

import argparse
import re
from collections.abc import Callable

from starskel.blending import METHODS
from starskel.errors import StarskelError
from starskel.export import bounds


def methods(text: str) -> tuple[str, ...]:
    """Read methods, set apart by commas."""
    methods = tuple(text.split(","))
    if len(set(methods)) < len(methods):
        raise argparse.ArgumentTypeError("a method is given twice")
    for method in methods:
        if method not in METHODS:
            raise argparse.ArgumentTypeError(f"invalid choice: {method!r} (choose from {', '.join(METHODS)})")
    return methods


def step(text: str) -> int:
    """Read the number of a step."""
    return _from_one(text, "number of a step: they count from 1")


def processes(text: str) -> int:
    """Read how many processes."""
    return _from_one(text, "number of processes: give 1 or more")


def _from_one(text: str, what: str) -> int:
    if not text.isdecimal() or not int(text):
        raise argparse.ArgumentTypeError(f"{text!r} is no {what}")
    return int(text)


def frame_count(text: str) -> int:
    """Read how many frames."""
    try:
        count = int(text)
    except ValueError:
        count = 0
    if not 2 <= count <= bounds.FRAMES.most:
        raise argparse.ArgumentTypeError(
            f"{text!r} is no number of frames: give a whole number from 2 to {bounds.FRAMES.most}"
            " (for one frame: --at T)"
        )
    return count


def time(text: str) -> float:
    """Read a time."""
    time = _number(text)
    if not 0 <= time <= 1:
        raise argparse.ArgumentTypeError(f"{text!r} is no number from 0 to 1")
    return time


def pixels(text: str) -> int:
    """Read a number of pixels."""
    return round(within(bounds.PIXELS)(text))


def within(wanted: bounds.Bounds) -> Callable[[str], float]:
    """Give what reads a number of these bounds."""

    def read(text: str) -> float:
        number = _number(text)
        try:
            wanted.check(number)
        except StarskelError as error:
            raise argparse.ArgumentTypeError(f"{text!r} is no {wanted.what}: {error.mend}") from None
        return number

    return read


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return float("nan")


def colour(text: str) -> str | None:
    """Read a colour, or "none"."""
    if text == "none":
        return None
    if not re.fullmatch(r"#[0-9a-fA-F]{6}", text):
        raise argparse.ArgumentTypeError(f'{text!r} is no colour: write it as #rrggbb, or "none"')
    return text.lower()
