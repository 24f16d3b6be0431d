from collections.abc import Iterator

import pytest

from app.session import Session


@pytest.fixture
def session(qapp) -> Iterator[Session]:  # type: ignore[no-untyped-def]
    session = Session()
    yield session
    session.close()
