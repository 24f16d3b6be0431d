from app.model.document import Document
from app.model.selection import Selection, everything
from app.tools.moving import Dragging
from app.tools.select import RubberBand, SelectTool
from app.tools.tool import Key, Pointer, Response, ToolContext
from starskel.errors import InvalidPolygon
from starskel.polygon import Polygon

SQUARE = Document.of(source=Polygon([(0, 0), (10, 0), (10, 10), (0, 10)]))
CONTEXT = ToolContext(SQUARE, Selection())


def at(x: float, y: float, *, shift: bool = False) -> Pointer:
    return Pointer("source", (x, y), 0.5, shift)


def drag(context: ToolContext, start: tuple[float, float], *stops: tuple[float, float]) -> Response:
    response = SelectTool().press(context, at(*start))
    context = ToolContext(context.document, response.selection or context.selection)
    for stop in stops:
        response = response.tool.move(context, at(*stop))
    return response.tool.release(context, at(*stops[-1]) if stops else at(*start))


def test_a_press_selects_the_vertex_under_it() -> None:
    response = SelectTool().press(CONTEXT, at(10.2, 0.1))
    assert response.selection == Selection("source", frozenset([1]))


def test_shift_adds_and_removes() -> None:
    one = SelectTool().press(CONTEXT, at(0, 0, shift=True)).selection
    assert one is not None
    two = SelectTool().press(ToolContext(SQUARE, one), at(10, 0, shift=True)).selection
    assert two == Selection("source", frozenset([0, 1]))
    assert SelectTool().press(ToolContext(SQUARE, two), at(0, 0, shift=True)).selection == Selection(
        "source", frozenset([1])
    )


def test_a_drag_previews_and_its_release_commits_once() -> None:
    held = SelectTool().press(CONTEXT, at(0, 0)).tool.move(CONTEXT, at(-3, -1)).tool.move(CONTEXT, at(-4, -2))
    assert held.commit is None
    ring = held.tool.overlay(CONTEXT, "source").ring
    assert ring is not None
    assert ring[0].tolist() == [-4, -2]
    response = held.tool.release(CONTEXT, at(-4, -2))
    assert response.commit is not None
    assert response.commit.document.vertices("source")[0].tolist() == [-4, -2]


def test_a_drag_moves_everything_that_is_selected() -> None:
    context = ToolContext(SQUARE, everything(SQUARE, "source"))
    response = drag(context, (0, 0), (5, 5))
    assert response.commit is not None
    assert response.commit.document.vertices("source").tolist() == [[5, 5], [15, 5], [15, 15], [5, 15]]


def test_a_click_on_one_of_many_selects_it_alone() -> None:
    response = drag(ToolContext(SQUARE, everything(SQUARE, "source")), (0, 0))
    assert response.commit is None
    assert response.selection == Selection("source", frozenset([0]))


def test_a_drag_that_crosses_is_refused_and_stores_nothing() -> None:
    response = drag(CONTEXT, (0, 0), (5, 5), (15, 5))
    assert response.commit is None
    assert response.refusal is not None
    assert len(response.refusal.segments) == 2


def test_all_crossings_are_pointed_at_not_only_the_first() -> None:
    teeth = [(0, 0), (10, 0), (10, 10), (8, 10), (8, 4), (5, 4), (5, 10), (0, 10)]
    context = ToolContext(Document.of(source=Polygon(teeth)), Selection())
    response = drag(context, (0, 10), (12, 8))  # its edges run through the right tooth and the gap
    assert response.refusal is not None
    assert isinstance(response.refusal.error, InvalidPolygon)
    assert len(response.refusal.segments) == 10
    assert sorted(x for x, _ in response.refusal.places) == [6, 8, 8, 10, 10]


def test_cancel_puts_a_dragged_vertex_back() -> None:
    held = SelectTool().press(CONTEXT, at(0, 0)).tool.move(CONTEXT, at(-3, -1)).tool
    assert isinstance(held, Dragging)
    assert held.cancel().overlay(CONTEXT, "source").ring is None


def test_the_selection_follows_a_triangle_turned_inside_out() -> None:
    document = Document.of(source=Polygon([(0, 0), (10, 0), (0, 10)]))
    context = ToolContext(document, Selection())
    response = drag(context, (10, 0), (-5, 5))
    assert response.commit is not None
    assert response.selection is not None
    (vertex,) = response.selection.vertices
    assert response.commit.document.vertices("source")[vertex].tolist() == [-5, 5]


def test_a_rubber_band_selects_what_is_inside() -> None:
    response = SelectTool().press(CONTEXT, at(-2, -2))
    assert isinstance(response.tool, RubberBand)
    assert response.tool.move(CONTEXT, at(12, 5)).selection == Selection("source", frozenset([0, 1]))


def test_a_rubber_band_with_shift_adds() -> None:
    context = ToolContext(SQUARE, Selection("source", frozenset([2])))
    tool = SelectTool().press(context, at(-2, -2, shift=True)).tool
    assert tool.move(context, at(2, 2)).selection == Selection("source", frozenset([0, 2]))


def test_a_double_click_on_an_edge_inserts_there() -> None:
    response = SelectTool().double_press(CONTEXT, at(5, 0.3))
    assert response.commit is not None
    assert response.commit.document.vertices("source")[1].tolist() == [5, 0]
    assert response.selection == Selection("source", frozenset([1]))


def test_a_double_click_elsewhere_does_nothing() -> None:
    assert SelectTool().double_press(CONTEXT, at(5, 5)).commit is None
    assert SelectTool().double_press(CONTEXT, at(0, 0)).commit is None


def test_delete_removes_the_selection() -> None:
    context = ToolContext(SQUARE, Selection("source", frozenset([1])))
    response = SelectTool().key(context, Key("delete"))
    assert response.commit is not None
    assert len(response.commit.document.vertices("source")) == 3
    assert not response.selection


def test_deleting_too_many_is_refused() -> None:
    context = ToolContext(SQUARE, Selection("source", frozenset([1, 2])))
    response = SelectTool().key(context, Key("delete"))
    assert response.commit is None
    assert response.refusal is not None


def test_arrow_keys_nudge_as_one_step() -> None:
    context = ToolContext(SQUARE, Selection("source", frozenset([2])))
    first = SelectTool().key(context, Key("up", step=0.25)).commit
    second = SelectTool().key(context, Key("right", step=0.25)).commit
    assert first is not None
    assert second is not None
    assert first.document.vertices("source")[2].tolist() == [10, 10.25]
    assert first.joins == second.joins


def test_the_pointer_shows_the_vertex_or_the_place_to_insert() -> None:
    assert SelectTool().move(CONTEXT, at(0.1, 0)).tool.overlay(CONTEXT, "source").vertex == 0
    assert SelectTool().move(CONTEXT, at(5, 0.2)).tool.overlay(CONTEXT, "source").insertion == (5, 0)
