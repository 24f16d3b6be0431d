import pytest

from starskel.command.progress import Progress


@pytest.fixture
def terminal(monkeypatch):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)


def test_nothing_is_shown_where_nobody_watches(capsys):
    with Progress("work") as progress:
        progress(0.5)
    assert capsys.readouterr() == ("", "")


@pytest.mark.usefixtures("terminal")
def test_the_bar_grows_and_is_gone_at_the_end(capsys):
    with Progress("work") as progress:
        progress(0.5)
        progress(0.501)
        progress(1.0)
    out, err = capsys.readouterr()
    assert out == ""
    bars = err.split("\r")[1:]
    assert [bar.count("#") for bar in bars] == [15, 30, 0]
    assert " 50 % work" in bars[0]
    assert bars[-1] == "\x1b[K"


@pytest.mark.usefixtures("terminal")
def test_the_bar_is_gone_after_an_error_too(capsys):
    with pytest.raises(KeyboardInterrupt), Progress("work") as progress:
        progress(0.5)
        raise KeyboardInterrupt
    assert capsys.readouterr().err.endswith("\r\x1b[K")
