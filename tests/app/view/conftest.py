"""What tests of the view begin with."""

import pytest

from tests.app.driver import Driver
from tests.app.view.faces import with_face


@pytest.fixture
def face(driver: Driver) -> Driver:
    return with_face(driver)
