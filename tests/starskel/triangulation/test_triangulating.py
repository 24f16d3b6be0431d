import numpy as np
import pytest

from starskel.errors import InvalidPolygon
from starskel.outline import signed_areas
from starskel.points import points_of
from starskel.rings import Rings
from starskel.triangulation import Triangulation, delaunay, triangulate, triangulating
from tests.families import blob, comb, spiral, subdivided, turned, two_opt

RINGS = {
    **{
        f"grid {n} {seed}": two_opt(n, seed, grid)
        for n, grid in ((8, 3), (14, 5), (20, 6))
        for seed in range(8)
    },
    **{f"random {seed}": two_opt(18, seed) for seed in range(4)},
    "smooth": blob(60, 1),
    "comb": comb(5),
    "subdivided comb": subdivided(comb(3), 2),
    "spiral": spiral(20),
    "rounded runs": turned(subdivided(two_opt(10, 3), 4), 0.7),
}

FINDERS = "by_earcut", "by_geos"


def whole(ring):
    return points_of(ring), Rings.of([range(len(ring))])


def teeth_round_the_origin(count):
    """Give a ring on a grid round the origin: many of its coordinates differ in their signs only."""
    x = np.arange(-count, count + 1)
    teeth = np.stack([np.repeat(x, 2)[1:-1], np.tile([1, 1, 2, 2], count)[: 4 * count]], axis=1)
    return np.concatenate([teeth[::-1], teeth * [1, -1]]).astype(float)


def nothing(points, rings):
    """Find no triangles, as a library does that has lost its way."""


def wrong(points, rings):
    """Find triangles of which one is there twice."""
    triangles = triangulate(points, rings).triangles
    return np.concatenate([triangles[:1], triangles[:-1]])


@pytest.mark.parametrize("found", [None, nothing, wrong], ids=["as found", "nothing found", "wrong"])
@pytest.mark.parametrize("finder", FINDERS)
@pytest.mark.parametrize("ring", RINGS.values(), ids=RINGS)
def test_triangles_tile_the_ring(ring, finder, found, monkeypatch):
    if found:
        result = found(*whole(ring))
        monkeypatch.setattr(triangulating, finder, lambda points, rings: result)
    way = triangulate if finder == "by_earcut" else delaunay
    ground = way(*whole(ring))
    assert len(ground.triangles) == len(ring) - 2
    assert set(ground.triangles.ravel()) == set(range(len(ring)))
    assert (ground.points.orientation(*ground.triangles.T) > 0).all()
    assert sum(signed_areas(ring[t]) for t in ground.triangles) == pytest.approx(signed_areas(ring))
    inner = np.flatnonzero(ground.twins >= 0)
    np.testing.assert_array_equal(ground.twins[ground.twins[inner]], inner)


@pytest.mark.parametrize("finder", FINDERS)
@pytest.mark.parametrize("kind", ["blob", "spiral", "comb", "teeth"])
def test_libraries_are_believed_on_plain_rings(kind, finder, monkeypatch):
    ring = {"blob": blob(200), "spiral": spiral(60), "comb": comb(20), "teeth": teeth_round_the_origin(50)}[
        kind
    ]
    monkeypatch.setattr(triangulating, "cut_ears", None)  # an error, if called
    way = triangulate if finder == "by_earcut" else delaunay
    assert len(way(*whole(ring)).triangles) == len(ring) - 2


@pytest.mark.parametrize("start", [1, 7])
def test_delaunay_triangles_are_the_same_wherever_the_ring_starts(start):
    ring = blob(40, 3)
    here = {frozenset(t) for t in delaunay(*whole(ring)).triangles.tolist()}
    shifted = delaunay(*whole(np.roll(ring, start, axis=0))).triangles - start
    assert {frozenset(t) for t in (shifted % 40).tolist()} == here


def test_no_vertex_that_is_seen_lies_in_the_circle_round_a_delaunay_triangle():
    ring = blob(40, 3)
    ground = delaunay(*whole(ring))
    inner = np.flatnonzero(ground.twins >= 0)
    a, b, c, d = ring[opposite(ground, inner)].view(np.complex128)[..., 0]
    angles = np.angle((a - c) / (b - c)) + np.angle((b - d) / (a - d))
    assert (np.abs(angles) <= np.pi + 1e-9).all()


def opposite(ground: Triangulation, inner):
    """Give the ends of edges, and the corners of both triangles that lie opposite."""
    corners = ground.triangles.ravel()
    beyond = [edges - edges % 3 + (edges + 2) % 3 for edges in (inner, ground.twins[inner])]
    ends = [corners[inner - inner % 3 + (inner + 1) % 3], corners[inner]]
    return np.stack([*ends, *(corners[edge] for edge in beyond)])


@pytest.mark.parametrize("triangles", [[(0, 1, 2), (0, 2, 1)], [(0, 1, 2), (1, 2, 3)], [(0, 1, 2)]])
def test_triangles_that_do_not_tile_are_told(triangles):
    square = np.array([(0, 0), (2, 0), (2, 2), (0, 2)], dtype=float)
    assert Triangulation.of(*whole(square), np.array([(0, 1, 2), (0, 2, 3)])).tiles
    assert not Triangulation.of(*whole(square), np.array(triangles)).tiles


@pytest.mark.parametrize("way", [triangulate, delaunay])
def test_a_ring_that_touches_itself_is_refused(way):
    """The ring comes from rounding straight runs, so that no check of the polygon can have seen it."""
    ring = np.array([(0, 0), (4, 4), (4, 0), (0, 4)], dtype=float)
    with pytest.raises(InvalidPolygon, match="touches itself near vertex"):
        way(*whole(ring))
