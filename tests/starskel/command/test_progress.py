import io

import pytest

from starskel.command.progress import Progress


class Terminal(io.StringIO):
    def isatty(self):
        return True


def interrupted(stream):
    with Progress("work", stream) as progress:
        progress(0.5)
        raise KeyboardInterrupt


def test_nothing_is_shown_where_nobody_watches():
    stream = io.StringIO()
    with Progress("work", stream) as progress:
        progress(0.5)
    assert stream.getvalue() == ""


def test_the_bar_grows_and_is_gone_at_the_end():
    stream = Terminal()
    with Progress("work", stream) as progress:
        progress(0.5)
        progress(0.501)
        progress(1.0)
    bars = stream.getvalue().split("\r")[1:]
    assert [bar.count("#") for bar in bars] == [15, 30, 0]
    assert " 50 % work" in bars[0]
    assert bars[-1] == "\x1b[K"


def test_the_bar_is_gone_after_an_interruption_too():
    stream = Terminal()
    with pytest.raises(KeyboardInterrupt):
        interrupted(stream)
    assert stream.getvalue().endswith("\r\x1b[K")


def test_another_label_is_shown_and_a_cleared_bar_comes_back():
    stream = Terminal()
    with Progress("one", stream) as progress:
        progress(0.5)
        progress.label = "two"
        progress(0.5)
        progress.clear()
        progress(0.5)
    bars = stream.getvalue().split("\r")[1:]
    assert [bar.removesuffix("\x1b[K")[-3:] for bar in bars] == ["one", "two", "", "two", ""]
