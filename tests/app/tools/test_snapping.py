from math import atan2, degrees

import pytest

from app.model.document import Document
from app.model.sequence import Sequence
from app.tools.settings import Snapping
from app.tools.snapping import caught, targets_for_drawing, targets_for_moving
from app.tools.tool import Catch, Pointer
from starskel.files.projects.key_shape import KeyShape, Part
from starskel.files.projects.step import Link, Step
from starskel.polygon import Polygon

SQUARE = Document.of(source=Polygon([(0, 0), (10, 0), (10, 10), (0, 10)]))
NOTHING = Snapping(vertices=False, edges=False)
ALL = Snapping(angles=True, grid=True, spacing=3)


def at(x: float, y: float, *, shift: bool = False, free: bool = False) -> Pointer:
    return Pointer("source", (x, y), 0.9, shift, free)


def drawing(pointer: Pointer, snapping: Snapping, *path: tuple[float, float]) -> Catch:
    return caught(pointer, snapping, targets_for_drawing(SQUARE, "source", path))


def moving(pointer: Pointer, snapping: Snapping, *vertices: int) -> Catch:
    return caught(pointer, snapping, targets_for_moving(SQUARE, "source", vertices))


def test_a_vertex_that_is_near_is_met() -> None:
    assert drawing(at(10.3, 9.7), Snapping()) == Catch((10, 10), "vertex")
    assert drawing(at(10.3, 9.7), NOTHING) == Catch((10.3, 9.7))


def test_an_edge_that_is_near_is_met() -> None:
    catch = drawing(at(4, 0.4), Snapping(vertices=False))
    assert (catch.at, catch.kind) == ((4, 0), "edge")
    assert drawing(at(4, 0.4), NOTHING).kind == ""


def test_a_place_level_with_a_vertex_is_taken_and_shown() -> None:
    catch = drawing(at(20, 10.4), Snapping())
    assert (catch.at, catch.kind, catch.guides) == ((20, 10), "aligned", (((10, 10), (20, 10)),))


def test_where_two_guides_cross_both_hold() -> None:
    catch = drawing(at(20.3, 9.8), Snapping(), (20, 30))
    assert catch.at == (20, 10)
    assert len(catch.guides) == 2


@pytest.mark.parametrize(("pointer", "angle"), [(at(25, 5.3), 0), (at(25, 13.4), 30), (at(10.2, -9), -90)])
def test_edges_keep_to_15_degrees_where_they_are_near(pointer: Pointer, angle: float) -> None:
    catch = drawing(pointer, Snapping(vertices=False, edges=False, angles=True), (10, 5))
    assert catch.kind == "angle"
    assert degrees(atan2(catch.at[1] - 5, catch.at[0] - 10)) == pytest.approx(angle)


def test_edges_between_two_steps_of_15_degrees_are_left_alone() -> None:
    assert drawing(at(12, 23), Snapping(vertices=False, edges=False, angles=True), (10, 5)).kind == ""


def test_shift_keeps_to_15_degrees_however_far() -> None:
    catch = drawing(at(12, 24, shift=True), NOTHING, (10, 5))
    assert degrees(atan2(catch.at[1] - 5, catch.at[0] - 10)) == pytest.approx(90)


def test_the_grid_catches_everywhere_where_nothing_else_does() -> None:
    assert drawing(at(31, 40.2), Snapping(grid=True, spacing=3)) == Catch((30, 39), "grid")
    assert drawing(at(9.8, 9.9), ALL).kind == "vertex"


def test_control_suspends_it() -> None:
    assert drawing(at(10.1, 10.1, free=True), ALL, (2, 2)) == Catch((10.1, 10.1))


def test_a_moved_vertex_keeps_off_the_others_but_takes_their_height() -> None:
    assert moving(at(14, 0.3), Snapping(edges=False), 2).at == (14, 0)
    assert moving(at(10.2, 10.2), Snapping(vertices=False), 2).kind == ""


def test_a_moved_vertex_may_lengthen_an_edge_or_lie_on_the_straight_between_its_neighbours() -> None:
    assert moving(at(5.2, 4.9), Snapping(vertices=False), 2).at == pytest.approx((5.15, 4.85))
    assert moving(at(10.3, -5), Snapping(), 3).at == (10, -5)
    assert moving(at(5, 0.2), Snapping(vertices=False), 2).kind == ""


def test_an_empty_canvas_catches_by_the_grid_alone() -> None:
    targets = targets_for_drawing(Document(), "source")
    assert caught(at(1, 1), Snapping(angles=True), targets) == Catch((1, 1))
    assert caught(at(1, 1), ALL, targets) == Catch((0, 0), "grid")


SEVERAL = Document(
    sequence=Sequence(
        (
            KeyShape(
                (
                    Part(Polygon([(0, 0), (10, 0), (10, 10), (0, 10)])),
                    Part(Polygon([(20, 0), (30, 0), (30, 10), (20, 10)])),
                    Part(Polygon([(4, 4), (6, 4), (5, 6)])),
                    Part(Polygon([(40, 0), (50, 0), (45, 9)]), visible=False),
                )
            ),
            KeyShape(),
        ),
        (Step(tuple(Link(k, None) for k in range(4))),),
    )
)


def test_all_parts_that_are_shown_catch() -> None:
    drawing = targets_for_drawing(SEVERAL.showing(0, 4), "source")
    moving = targets_for_moving(SEVERAL, "source", {2})
    for targets in (drawing, moving):
        assert caught(at(20.3, 9.8), Snapping(), targets) == Catch((20, 10), "vertex")
        assert caught(at(20.3, 5), Snapping(vertices=False), targets).at == (20, 5)
        assert caught(at(44.9, 9.1), Snapping(), targets).kind != "vertex"  # it is hidden


def test_holes_and_outlines_do_not_catch_each_other_but_are_level() -> None:
    for link, vertex, place in ((0, 2, at(5.2, 6.1)), (2, 2, at(10.1, 9.9))):
        catch = caught(place, Snapping(), targets_for_moving(SEVERAL.showing(0, link), "source", {vertex}))
        assert catch.kind == "aligned"
