from dataclasses import replace

from app.model.document import Document
from app.model.selection import Selection
from app.tools.draw import DrawTool, PolygonBegun
from app.tools.select import SelectTool
from app.tools.tool import Key, Pointer, Response, Tool, ToolContext
from starskel.polygon import Polygon

CONTEXT = ToolContext(Document(), Selection())


def at(x: float, y: float) -> Pointer:
    return Pointer("source", (x, y), radius=0.5)


def click(tool: Tool, *places: tuple[float, float]) -> Response:
    response = Response(tool)
    for place in places:
        response = response.tool.press(CONTEXT, at(*place))
    return response


def test_clicks_and_a_click_on_the_first_vertex_draw_a_polygon() -> None:
    response = click(DrawTool(), (0, 0), (10, 0), (10, 10), (0.2, 0.2))
    assert response.commit is not None
    assert response.commit.document.source == Polygon([(0, 0), (10, 0), (10, 10)])
    assert response.tool == DrawTool()


def test_enter_closes() -> None:
    response = click(DrawTool(), (0, 0), (10, 0), (10, 10)).tool.key(CONTEXT, Key("enter"))
    assert response.commit is not None


def test_a_shape_drawn_clockwise_is_turned_round() -> None:
    response = click(DrawTool(), (0, 0), (10, 10), (10, 0), (0, 0))
    assert response.commit is not None
    assert response.commit.document.vertices("source").tolist() == [[0, 0], [10, 0], [10, 10]]


def test_a_crossing_edge_is_shown_and_not_stored() -> None:
    before = click(DrawTool(), (0, 0), (10, 0), (10, 10)).tool
    response = before.press(CONTEXT, at(5, -5))
    assert isinstance(response.tool, PolygonBegun)
    assert response.tool.points == ((0, 0), (10, 0), (10, 10))
    assert response.refusal is not None
    assert response.refusal.segments == (((0, 0), (10, 0)), ((10, 10), (5, -5)))
    hovered = before.move(CONTEXT, at(5, -5))
    assert hovered.refusal is not None
    assert before.move(CONTEXT, at(5, 5)).refusal is None


def test_an_edge_that_folds_back_is_refused() -> None:
    response = click(DrawTool(), (0, 0), (10, 0), (5, 0))
    assert response.refusal is not None
    drawing = response.tool
    assert isinstance(drawing, PolygonBegun)
    assert drawing.key(CONTEXT, Key("backspace")).tool == replace(drawing, points=((0, 0),))


def test_closing_over_another_edge_is_refused() -> None:
    tool = click(DrawTool(), (0, 0), (10, 0), (10, 10), (5, 10), (5, -5), (0, -5)).tool
    assert isinstance(tool, PolygonBegun)
    zigzag = click(DrawTool(), (0, 0), (4, 4), (4, -4), (6, -4), (6, 4), (10, 0))
    closing = zigzag.tool.press(CONTEXT, at(0, 0))
    assert closing.commit is None
    assert closing.refusal is not None
    by_key = zigzag.tool.key(CONTEXT, Key("enter"))
    assert by_key.commit is None
    assert by_key.refusal is not None
    assert by_key.refusal.places


def test_enter_on_two_vertices_is_refused() -> None:
    response = click(DrawTool(), (0, 0), (10, 0)).tool.key(CONTEXT, Key("enter"))
    assert response.refusal is not None
    assert "at least 3" in str(response.refusal.error)


def test_backspace_takes_vertices_back_one_by_one() -> None:
    tool = click(DrawTool(), (0, 0), (10, 0)).tool.key(CONTEXT, Key("backspace")).tool
    assert isinstance(tool, PolygonBegun)
    assert tool.points == ((0, 0),)
    assert tool.key(CONTEXT, Key("backspace")).tool == DrawTool()


def test_cancel_forgets_the_path() -> None:
    assert click(DrawTool(), (0, 0), (10, 0)).tool.cancel() == DrawTool()


def test_the_second_press_of_a_double_click_sets_no_vertex() -> None:
    tool = click(DrawTool(), (0, 0), (10, 0)).tool.double_press(CONTEXT, at(10, 0)).tool
    assert isinstance(tool, PolygonBegun)
    assert tool.points == ((0, 0), (10, 0))


def test_the_other_canvas_neither_adds_nor_cancels() -> None:
    tool = click(DrawTool(), (0, 0), (10, 0)).tool
    assert tool.press(CONTEXT, Pointer("target", (3, 3), 0.5)).tool == tool


def test_going_on_to_something_else_closes_what_is_a_polygon_already() -> None:
    response = click(DrawTool(), (0, 0), (10, 0), (10, 10)).tool.finish(CONTEXT)
    assert response.commit is not None
    assert response.commit.document.source == Polygon([(0, 0), (10, 0), (10, 10)])
    assert click(DrawTool(), (0, 0), (10, 0)).tool.finish(CONTEXT) == Response(DrawTool())
    zigzag = click(DrawTool(), (0, 0), (4, 4), (4, -4), (6, -4), (6, 4), (10, 0))
    refused = zigzag.tool.finish(CONTEXT)
    assert refused.tool == zigzag.tool
    assert refused.refusal is not None


def test_the_second_shape_done_the_drawing_tool_is_put_down() -> None:
    context = ToolContext(Document.of(target=Polygon([(0, 0), (9, 0), (9, 9)])), Selection())
    tool = click(DrawTool(), (0, 0), (10, 0), (10, 10)).tool
    assert tool.key(CONTEXT, Key("enter")).tool == DrawTool()
    assert tool.key(context, Key("enter")).tool == SelectTool()
