import pytest

from app.view.start import FIRST_EXAMPLE
from starskel.files.projects.examples import example_names
from tests.app.driver import Driver


def test_the_first_example_is_there() -> None:
    assert FIRST_EXAMPLE in example_names()


@pytest.mark.parametrize("name", example_names())
def test_every_example_opens_and_blends_by_every_method(driver: Driver, name: str) -> None:
    driver.window.files.open_example(name)
    driver.wait_for_blends()
    assert len(driver.session.blends.fresh) == len(driver.document.methods)
    assert not driver.session.unsaved
