"""Sheets: where things stand, and how they look in print."""

import numpy as np
import pytest

from starskel.errors import StarskelError
from starskel.sheet.comparison import Row, comparison_sheet
from starskel.sheet.drawing import Area, Disc, Group, Label, Line
from starskel.sheet.keyframe import FramePart, Keyframe, PlacedSkeleton
from starskel.sheet.rows import LONGEST, Stage, box_of, row_sheet
from starskel.sheet.style import USUAL, Look
from tests.starskel.export.rendering import (
    assert_filled,
    needs_ghostscript,
    needs_rsvg,
    painted_box,
    rendered_postscript,
    rendered_svg,
    write_eps,
    write_postscript,
    write_svg,
)

HOOK = np.array([[0, 0], [2, 0], [2, 6], [8, 6], [8, 8], [0, 8]], dtype=float)
BOW_TIE = np.array([[0, 0], [4, 4], [4, 0], [0, 4]], dtype=float)


def turned(ring, quarter):
    c, s = np.cos(quarter * np.pi / 2), np.sin(quarter * np.pi / 2)
    return ring @ np.array([[c, s], [-s, c]])


def frame_of(ring, t=0.5, marks=(), **cut):
    return Keyframe(t, (FramePart((ring,), **cut),), np.empty((0, 2, 2)), ring[list(marks)])


def ring_of(frame):
    (part,) = frame.parts
    return part.rings[0]


FRAMES = tuple(frame_of(turned(HOOK, t) + 100 * t, t, (0, 3)) for t in (0.0, 0.25, 0.5, 1.0))
WHOLE = frame_of(
    HOOK,
    marks=(0,),
    pieces=(HOOK[:3], HOOK[2:]),
    skeleton=PlacedSkeleton(HOOK[[0, 4]], HOOK[[2]], HOOK[[[0, 2], [2, 4]]]),
)


def page_sheets(title, frames, look=USUAL):
    stage = Stage(box_of(frames), look=look)
    return [stage.picture(title, f"frame-{number}", [frame]) for number, frame in enumerate(frames)]


SHEETS = {
    "row": row_sheet("row", FRAMES),
    "rows": row_sheet("rows", FRAMES * 4),
    "plain": row_sheet("plain", FRAMES, look=Look(captions=False)),
    "page": page_sheets("page", [WHOLE])[0],
    "comparison": comparison_sheet(
        "both",
        [
            Row("good", "simple", "simple", ("area drift 1 %",), FRAMES),
            Row("bad", "harmful", "crosses", (), (WHOLE,) * 4),
            Row("layered", "natural", "natural crossing", (), (WHOLE,) * 4),
        ],
    ),
}


def items(group, kind):
    """All items of a kind, inside of groups too."""
    for item in group.items:
        if isinstance(item, Group):
            yield from items(item, kind)
        elif isinstance(item, kind):
            yield item


def frames_of(sheet):
    return [item for item in sheet.items if isinstance(item, Group)]


def outline(group):
    return next(item.ring for item in group.items if isinstance(item, Area) and item.stroke)


def extent(item):
    points = {
        Area: lambda: item.ring,
        Line: lambda: item.points,
        Disc: lambda: np.array(item.centre) + item.radius * np.array([[-1, -1], [1, 1]]),
        Label: lambda: np.array([item.place]),
    }[type(item)]()
    return points.min(axis=0), points.max(axis=0)


@pytest.mark.parametrize("name", SHEETS)
def test_all_stands_on_the_sheet(name):
    sheet = SHEETS[name]
    for item in items(sheet, (Area, Line, Disc, Label)):
        low, high = extent(item)
        assert (low >= 0).all()
        assert (high <= [sheet.width, sheet.height]).all()


@pytest.mark.parametrize("name", ["row", "rows", "plain", "comparison"])
def test_no_frame_stands_on_another(name):
    boxes = [(outline(frame).min(axis=0), outline(frame).max(axis=0)) for frame in frames_of(SHEETS[name])]
    for i, (low, high) in enumerate(boxes):
        for other_low, other_high in boxes[:i]:
            assert (high < other_low).any() or (low > other_high).any()


@pytest.mark.parametrize("name", ["row", "rows", "plain", "comparison"])
def test_all_frames_have_one_scale(name):
    edges = [np.linalg.norm(outline(frame)[1] - outline(frame)[0]) for frame in frames_of(SHEETS[name])]
    assert edges == pytest.approx([edges[0]] * len(edges))


def test_pages_lie_on_one_another_as_the_frames_do():
    pages = [outline(frames_of(page)[0]) for page in page_sheets("pages", FRAMES)]
    scale = np.linalg.norm(pages[0][1] - pages[0][0]) / 2
    for page, frame in zip(pages, FRAMES, strict=True):
        assert (page - pages[0]) / scale == pytest.approx(ring_of(frame) - ring_of(FRAMES[0]))


def test_a_long_row_goes_on_below():
    heights = [
        outline(frame).mean(axis=0)[1] for frame in frames_of(row_sheet("long", [WHOLE] * (LONGEST + 1)))
    ]
    assert np.ptp(heights[:LONGEST]) == pytest.approx(0)
    assert heights[LONGEST] < heights[0]


def test_a_frame_that_meets_itself_bears_a_sign_and_rings_the_place():
    (good,) = frames_of(row_sheet("good", [frame_of(HOOK)]))
    (bad,) = frames_of(row_sheet("bad", [frame_of(BOW_TIE)]))
    assert not list(items(good, (Disc, Line)))
    ring, sign = items(bad, Disc)
    assert ring.centre == pytest.approx(outline(bad).mean(axis=0))
    assert ring.fill is None
    assert sign.fill is not None
    assert len(list(items(bad, Line))) == 2


def test_a_frame_knows_the_places_where_it_meets_itself():
    assert frame_of(BOW_TIE).crossings.tolist() == [[2.0, 2.0]]
    assert frame_of(HOOK).crossings.shape == (0, 2)


def test_a_frame_that_is_inside_out_is_not_simple_as_measure_says():
    assert frame_of(HOOK).simple
    assert not frame_of(HOOK[::-1]).simple


def test_a_point_has_no_size_to_be_drawn_in():
    with pytest.raises(StarskelError, match="all that is to be seen is a point; choose other times"):
        row_sheet("point", [frame_of(HOOK[[0, 0, 0]])])


def test_pins_are_numbered_from_one_at_their_vertices():
    (frame,) = frames_of(row_sheet("pins", [frame_of(HOOK, 0.0, (3, 0))]))
    ring = outline(frame)
    assert [disc.centre for disc in items(frame, Disc)] == [tuple(ring[3]), tuple(ring[0])]
    assert [label.text for label in items(frame, Label)] == ["1", "2"]


def test_a_comparison_says_in_words_what_the_signs_say():
    texts = [label.text for label in items(SHEETS["comparison"], Label)]
    assert {"both", "good", "simple", "area drift 1 %", "bad", "crosses", "t = 0", "t = 0.25"} <= set(texts)


def test_the_names_of_groups_are_unique():
    for sheet in SHEETS.values():
        names = [frame.name for frame in frames_of(sheet)]
        assert len(set(names)) == len(names)


@needs_ghostscript
@pytest.mark.parametrize("name", SHEETS)
def test_what_is_painted_lies_in_the_bounding_box(tmp_path, name):
    sheet = SHEETS[name]
    write_eps(tmp_path / "a.eps", sheet)
    left, lower, right, upper = painted_box(tmp_path / "a.eps")
    assert 0 <= left < right <= sheet.width + 0.1
    assert 0 <= lower < upper <= sheet.height + 0.1


@needs_rsvg
def test_a_frame_in_svg_is_where_the_sheet_says_and_right_side_up(tmp_path):
    sheet = row_sheet("one", [frame_of(HOOK)], look=Look(captions=False))
    write_svg(tmp_path / "a.svg", sheet)
    assert_filled(rendered_svg(tmp_path / "a.svg"), outline(frames_of(sheet)[0]))


@needs_ghostscript
def test_pages_in_postscript_are_where_the_sheets_say_and_right_side_up(tmp_path):
    sheets = page_sheets(
        "pages", [frame_of(ring_of(frame) * 10, frame.t) for frame in FRAMES], look=Look(captions=False)
    )
    write_postscript(tmp_path / "a.ps", sheets)
    pictures = rendered_postscript(tmp_path / "a.ps")
    assert len(pictures) == len(FRAMES)
    for picture, sheet in zip(pictures, sheets, strict=True):
        assert_filled(picture, outline(frames_of(sheet)[0]))
