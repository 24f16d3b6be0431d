import pytest

from app.model.document import Document
from app.model.selection import Selection
from app.tools.figure import FIGURES, Figure, FigureTool
from app.tools.tool import Pointer, Response, ToolContext

CONTEXT = ToolContext(Document(), Selection())
KINDS = {figure.name: figure for figure in FIGURES}


def at(x: float, y: float, *, shift: bool = False) -> Pointer:
    return Pointer("source", (x, y), 0.9, shift)


def drag(tool: FigureTool, start: Pointer, end: Pointer) -> Response:
    return tool.press(CONTEXT, start).tool.move(CONTEXT, end).tool.release(CONTEXT, end)


@pytest.mark.parametrize("figure", FIGURES, ids=list(KINDS))
def test_a_drag_previews_and_its_release_draws_what_was_shown(figure: Figure) -> None:
    held = FigureTool(figure).press(CONTEXT, at(0, 0)).tool.move(CONTEXT, at(8, 5)).tool
    shown = held.overlay(CONTEXT, "source").figure
    commit = held.release(CONTEXT, at(8, 5)).commit
    assert shown is not None
    assert commit is not None
    assert sorted(commit.document.vertices("source").tolist()) == sorted(shown.tolist())


@pytest.mark.parametrize("figure", FIGURES, ids=list(KINDS))
def test_a_shaky_click_draws_nothing(figure: Figure) -> None:
    assert drag(FigureTool(figure), at(0, 0), at(0.1, 0.1)).commit is None


def test_shift_makes_squares_whichever_way_the_drag_goes() -> None:
    for x, y in ((8, 5), (-8, 5), (3, -8)):
        commit = drag(FigureTool(KINDS["rectangle"]), at(0, 0), at(x, y, shift=True)).commit
        assert commit is not None
        ring = commit.document.vertices("source")
        assert (ring.max(axis=0) - ring.min(axis=0)).tolist() == [8, 8]


def test_shift_turns_a_polygon_by_steps() -> None:
    commit = drag(FigureTool(KINDS["regular-polygon"]), at(0, 0), at(1, 9, shift=True)).commit
    assert commit is not None
    assert commit.document.vertices("source")[0] == pytest.approx((0, 9))
