"""Where the handles of a frame are, above all the one that turns: it can be reached wherever one looks."""

import pytest

from app.model.transforms import Box
from app.tools.handles import GAP, SIGHT, STALK, TURN, handle_at, handle_places
from app.tools.tool import PICK, Pointer

BOX = Box((0, 0), (100, 100))
OUT = GAP + STALK
"""So far from the box, in pixels, is the handle that turns."""


def turn(view: Box | None) -> tuple[float, float]:
    return handle_places(BOX, 1.0, view)[TURN]


@pytest.mark.parametrize(
    ("view", "place"),
    [
        (None, (50, 100 + OUT)),
        (Box((-200, -200), (300, 300)), (50, 100 + OUT)),
        (Box((-200, -200), (300, 120)), (50, -OUT)),
        (Box((-200, -10), (300, 120)), (50, 100 + GAP - STALK)),
        (Box((10, 10), (40, 40)), (40 - SIGHT, 40 - SIGHT)),
        (Box((200, 200), (300, 300)), (50, 100 + OUT)),
    ],
    ids=["nobody looks", "room all round", "none above", "none below either", "within", "elsewhere"],
)
def test_the_handle_that_turns_is_in_sight_while_the_frame_is(
    view: Box | None, place: tuple[float, float]
) -> None:
    assert turn(view) == place
    assert handle_at(BOX, Pointer("source", place, PICK, view=view)) == TURN
