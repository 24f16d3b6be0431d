import pytest

from app.view.main_window import MainWindow
from app.view.status import Status, seconds_left


@pytest.mark.parametrize(
    ("elapsed", "fraction", "left"),
    [(1.0, 0.5, None), (60.0, 0.0, None), (4.0, 0.5, 4), (3.0, 0.99, 1), (9.0, 0.3, 25), (3.0, 1.0, 1)],
)
def test_how_long_it_still_takes_is_told_as_soon_as_the_pace_is_known(
    elapsed: float, fraction: float, left: int | None
) -> None:
    assert seconds_left(elapsed, fraction) == left


def test_a_narrow_window_gets_fewer_sentences_of_the_hint(window: MainWindow) -> None:
    bar = window.statusBar()
    assert isinstance(bar, Status)
    hint = bar.hint
    window.actions_table["select"].trigger()
    whole = hint.toolTip()
    hint.resize(2000, hint.height())
    assert hint.text() == whole
    hint.resize(hint.sizeHint().width() - 20, hint.height())
    assert whole.startswith(hint.text())
    assert hint.text().endswith(".")
    assert len(hint.text()) < len(whole)
