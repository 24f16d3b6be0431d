from dataclasses import replace

from app.model.document import Document
from app.model.marks import Side
from app.model.selection import Selection
from app.tools.mark import MarkBegun, MarkTool
from app.tools.tool import Pointer, Response, Tool, ToolContext
from starskel.polygon import Polygon

SHAPE = Polygon([(0, 0), (10, 0), (10, 10), (0, 10)])
CONTEXT = ToolContext(Document.of(source=SHAPE, target=SHAPE, marks=((0, 0), (1, 1))), Selection())


def at(side: Side, x: float, y: float) -> Pointer:
    return Pointer(side, (x, y), 0.5)


def click(tool: Tool, side: Side, x: float, y: float) -> Response:
    pressed = tool.press(CONTEXT, at(side, x, y))
    released = pressed.tool.release(CONTEXT, at(side, x, y))
    return Response(
        released.tool, pressed.commit or released.commit, None, pressed.refusal or released.refusal
    )


def test_a_click_on_each_canvas_sets_a_mark() -> None:
    begun = click(MarkTool(), "source", 10, 10).tool
    assert begun.overlay(CONTEXT, "source").pin == (2, 2)
    response = click(begun, "target", 0, 10)
    assert response.commit is not None
    assert response.commit.document.marks[-1] == (2, 3)


def test_it_may_begin_on_the_target() -> None:
    response = click(click(MarkTool(), "target", 0, 10).tool, "source", 10, 10)
    assert response.commit is not None
    assert response.commit.document.marks[-1] == (2, 3)


def test_a_crossing_mark_is_refused_and_shows_both() -> None:
    context = ToolContext(Document.of(source=SHAPE, target=SHAPE, marks=((0, 0), (3, 3))), Selection())
    response = MarkBegun("source", 1).press(context, at("target", 10, 10))
    assert response.commit is not None
    context = ToolContext(response.commit.document, Selection())
    response = MarkBegun("source", 2).press(context, at("target", 10, 0))
    assert response.commit is None
    assert response.refusal is not None
    assert set(response.refusal.marks) == {(1, 2), (2, 1)}
    assert isinstance(response.tool, MarkBegun)
    assert (response.tool.side, response.tool.vertex) == ("source", 2)


def test_a_second_mark_at_a_vertex_is_refused() -> None:
    response = click(click(MarkTool(), "source", 10, 10).tool, "target", 0, 0)
    assert response.commit is None
    assert response.refusal is not None
    assert set(response.refusal.marks) == {(0, 0), (2, 0)}


def test_another_vertex_of_the_same_canvas_begins_anew() -> None:
    tool = click(click(MarkTool(), "source", 10, 10).tool, "source", 0, 10).tool
    assert isinstance(tool, MarkBegun)
    assert tool.vertex == 3


def test_a_click_on_a_pin_removes_it() -> None:
    response = click(MarkTool(), "target", 10, 0)
    assert response.commit is not None
    assert response.commit.document.marks == ((0, 0),)


def test_a_pin_is_dragged_to_another_vertex() -> None:
    held = MarkTool().press(CONTEXT, at("target", 10, 0)).tool
    held = held.move(CONTEXT, at("target", 5, 5)).tool.move(CONTEXT, at("target", 10, 9.9)).tool
    assert held.overlay(CONTEXT, "target").pin == (2, 1)
    response = held.release(CONTEXT, at("target", 10, 10))
    assert response.commit is not None
    assert response.commit.document.marks == ((0, 0), (1, 2))


def test_a_pin_dragged_onto_another_is_refused() -> None:
    held = MarkTool().press(CONTEXT, at("target", 10, 0)).tool.move(CONTEXT, at("target", 0, 0)).tool
    response = held.release(CONTEXT, at("target", 0, 0))
    assert response.commit is None
    assert response.refusal is not None


def test_a_pin_dragged_into_the_void_goes_back() -> None:
    held = MarkTool().press(CONTEXT, at("target", 10, 0)).tool.move(CONTEXT, at("target", 5, 5)).tool
    response = held.release(CONTEXT, at("target", 5, 5))
    assert response.commit is None
    assert response.tool == MarkTool("target")


def dragged(tool: Tool, side: Side, *stops: Pointer) -> Response:
    """Drag from a canvas to places on the other one."""
    for stop in stops:
        tool = tool.move(CONTEXT, replace(at(side, 50, 50), across=stop)).tool
    return tool.release(CONTEXT, replace(at(side, 50, 50), across=stops[-1]))


def test_a_drag_from_canvas_to_canvas_sets_a_mark() -> None:
    begun = MarkTool().press(CONTEXT, at("source", 10, 10)).tool
    response = dragged(begun, "source", at("target", 5, 5), at("target", 0, 10))
    assert response.commit is not None
    assert response.commit.document.marks[-1] == (2, 3)


def test_a_drag_shows_its_line_or_what_it_may_not_do() -> None:
    begun = MarkTool().press(CONTEXT, at("source", 10, 10)).tool
    over = begun.move(CONTEXT, replace(at("source", 50, 50), across=at("target", 10, 0)))
    assert over.refusal is not None
    assert over.tool.overlay(CONTEXT, "target").line is None  # it would cross the words that say why not
    away = over.tool.move(CONTEXT, replace(at("source", 50, 50), across=at("target", 5, 5)))
    assert away.refusal is not None  # it can still be read
    good = away.tool.move(CONTEXT, replace(at("source", 50, 50), across=at("target", 0, 10)))
    assert good.refusal is None
    assert good.tool.overlay(CONTEXT, "target").line == (0, 10)
    assert good.tool.overlay(CONTEXT, "source").line is None


def test_a_drag_into_the_void_waits_for_a_click() -> None:
    begun = MarkTool().press(CONTEXT, at("source", 10, 10)).tool
    response = dragged(begun, "source", at("target", 5, 5))
    assert response.commit is None
    assert isinstance(response.tool, MarkBegun)


def test_a_pin_dragged_to_the_other_canvas_moves_its_end_there() -> None:
    held = MarkTool().press(CONTEXT, at("source", 10, 0)).tool
    response = dragged(held, "source", at("target", 10, 10))
    assert response.commit is not None
    assert response.commit.document.marks == ((0, 0), (1, 2))


def test_a_drag_previews_the_document_that_it_would_leave() -> None:
    held = MarkTool().press(CONTEXT, at("target", 10, 0)).tool
    assert held.preview(CONTEXT, at("target", 10, 0)) is None  # a click would remove the pin
    held = held.move(CONTEXT, at("target", 10, 10)).tool
    shown = held.preview(CONTEXT, at("target", 10, 10))
    assert shown is not None
    assert shown.marks == ((0, 0), (1, 2))
