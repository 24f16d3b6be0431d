from dataclasses import replace

import numpy as np
import pytest

from starskel.blending.meshes.fans import Fans, fans_of
from starskel.blending.meshes.mesh import corner_angles, mesh_of, triangle_areas
from starskel.blending.stitch import STRAY, Stitch, edge_distortions, edge_weights, graph_of
from starskel.blending.stitched import StitchedBlend
from starskel.correspondence import match
from starskel.decomposition import decompose
from starskel.errors import Cancelled
from starskel.outline import cross_themselves, signed_areas
from starskel.polar import PolarVectors
from starskel.task import Task
from tests.families import turned
from tests.starskel.blending.cases import CASES, decomposition_of

TIMES = np.linspace(0, 1, 103)


def mesh_for(name):
    decomposition = decomposition_of(name)
    return mesh_of(fans_of(decomposition, Task()))


@pytest.mark.parametrize("name", CASES)
def test_fans_tile_both_polygons_with_triangles_that_are_never_turned_over(name):
    decomposition, mesh = decomposition_of(name), mesh_for(name)
    for areas, ring in (
        (mesh.source_areas, decomposition.pair.source),
        (mesh.target_areas, decomposition.pair.target),
    ):
        assert areas.sum() == pytest.approx(float(signed_areas(ring)))
        assert areas.min() > -1e-12 * areas.sum()


@pytest.mark.parametrize("name", CASES)
def test_the_outline_and_all_hubs_are_linked_and_each_inner_edge_has_two_triangles(name):
    mesh = mesh_for(name)
    uses = np.bincount(mesh.sides.ravel())
    np.testing.assert_array_equal(uses, np.where(mesh.on_ring, 1, 2))
    assert mesh.on_ring.sum() == len(decomposition_of(name).pair)
    np.testing.assert_array_equal(np.unique(mesh.triangles), np.arange(len(mesh.source)))


@pytest.mark.parametrize("name", CASES)
def test_rotations_gain_at_every_corner_what_its_angle_gains(name):
    mesh = mesh_for(name)
    gains = corner_angles(mesh.target[mesh.triangles]) - corner_angles(mesh.source[mesh.triangles])
    rotations = mesh.wishes.rotations[mesh.sides]
    for corner in range(3):
        ahead, back = rotations[:, corner], rotations[:, corner - 1]
        np.testing.assert_allclose(back - ahead, gains[:, corner], atol=1e-6)


@pytest.mark.parametrize("name", CASES)
def test_wishes_are_the_edges_themselves_at_both_ends(name):
    mesh = mesh_for(name)
    ends = mesh.wishes.at(np.array([0.0, 1.0]))
    for vectors, points in zip(ends, (mesh.source, mesh.target), strict=True):
        i, j = mesh.edges.T
        np.testing.assert_allclose(vectors, points[j] - points[i], atol=1e-12 * mesh.size)


@pytest.mark.parametrize("name", CASES)
def test_needless_whole_turns_are_left_out(name):
    """The mean turn is half a turn at most, wherever the unwrapping began and however often it went round."""
    mesh = mesh_for(name)
    wishes, (i, j) = mesh.wishes, mesh.edges.T
    lengths = wishes.source_lengths / wishes.source_lengths.sum()
    lengths = lengths + wishes.target_lengths / wishes.target_lengths.sum()
    assert abs(wishes.rotations @ lengths) / lengths.sum() <= np.pi
    for turns in (-2, 1):
        vectors = [z[j] - z[i] for z in (mesh.source, mesh.target)]
        others = PolarVectors.between(*vectors, wishes.rotations + 2 * np.pi * turns)
        np.testing.assert_allclose(others.rotations, wishes.rotations, atol=1e-12)


def test_where_only_a_vertex_sees_everything_it_is_the_hub_and_is_not_doubled():
    """Edges on rays from vertex 0 leave nothing else in the kernel, and triangles without area in the fan."""
    source = np.array([(0, 0), (6, 0), (6, 3), (2, 1), (1, 2), (3, 6), (0, 6)], dtype=float)
    target = np.array([(0, 0), (6, 0), (8, 4), (2, 1), (1, 2), (2, 4), (0, 5)], dtype=float)
    decomposition = decompose(match(source, target, [(k, k) for k in range(7)]))
    fans = fans_of(decomposition, Task())
    assert fans.hubs == ((0,),)
    np.testing.assert_array_equal(fans.source, source)
    np.testing.assert_array_equal(sorted(fans.triangles.tolist()), [(0, k, k + 1) for k in range(1, 6)])
    frames = StitchedBlend(decomposition).frames(TIMES)
    assert np.isfinite(frames).all()
    assert not cross_themselves(frames).any()


@pytest.mark.parametrize("name", ["run-walk", "hand-open", "random-12-5"])
def test_frames_come_nearest_to_the_wishes(name):
    """Against the least-squares problem solved densely."""
    mesh = mesh_for(name)
    graph = graph_of(mesh)
    weights = edge_weights(mesh, 3.0, 0.0)
    points = Stitch.of(graph, weights, 0.0).points(np.array([0.4]))[0]
    incidence = np.zeros((len(mesh.edges), len(mesh.source)))
    rows = np.arange(len(mesh.edges))
    incidence[rows, mesh.edges[:, 1]], incidence[rows, mesh.edges[:, 0]] = 1, -1
    roots = np.sqrt(weights)[:, None]
    wishes = mesh.wishes.at(np.array([0.4]))[0]
    nearest = np.linalg.lstsq(roots * incidence, roots[:, 0] * wishes, rcond=None)[0]
    whole = [triangle_areas(z[mesh.triangles]).sum() for z in (points, nearest)]
    scaled = np.sqrt(whole[0] / whole[1]) * (nearest - nearest.mean())
    np.testing.assert_allclose(points - points.mean(), scaled, atol=1e-9 * mesh.size)


@pytest.mark.parametrize("name", ["letter-C-S", "run-walk", "hand-open", "spiral-opposite"])
def test_the_area_pass_brings_areas_nearer_to_the_linear_ones(name):
    mesh = mesh_for(name)
    graph = graph_of(mesh)
    plain = Stitch.of(graph, edge_weights(mesh, 3.0, 0.0), 0.0)
    deviations = []
    for area_share in (0.0, 0.5, 1.0):
        corners = replace(plain, area_share=area_share).points(TIMES)[:, mesh.triangles]
        wanted = np.outer(1 - TIMES, mesh.source_areas) + np.outer(TIMES, mesh.target_areas)
        total = triangle_areas(corners).sum(axis=1) / wanted.sum(axis=1)
        deviations.append(np.abs(total - 1).max())
    assert deviations[0] > deviations[1] > deviations[2]


@pytest.mark.parametrize("name", CASES)
def test_no_frame_of_these_pairs_crosses_itself(name):
    assert not cross_themselves(StitchedBlend(decomposition_of(name)).frames(TIMES)).any()


def test_a_blend_that_is_there_at_once_is_improved_until_it_is_simple():
    decomposition = decomposition_of("arms-over-under")
    first = StitchedBlend(decomposition, settled=False)
    crossings = [cross_themselves(first.frames(TIMES)).mean()]
    assert crossings[0] > 0
    for better in first.improvements():
        assert better.settled == (not cross_themselves(better.frames(TIMES)).any())
        crossings.append(cross_themselves(better.frames(TIMES)).mean())
        np.testing.assert_allclose(better.frames([0.0, 1.0]), first.frames([0.0, 1.0]), atol=1e-9)
    assert crossings[-1] == 0
    assert crossings[-1] < crossings[0]
    np.testing.assert_array_equal(better.frames(TIMES), StitchedBlend(decomposition).frames(TIMES))


def test_a_blend_that_is_simple_at_once_stays_as_it_is():
    decomposition = decomposition_of("run-walk")
    first = StitchedBlend(decomposition, settled=False)
    (settled,) = first.improvements()
    assert settled.settled
    assert list(settled.improvements()) == []
    np.testing.assert_array_equal(settled.frames(TIMES), first.frames(TIMES))
    np.testing.assert_array_equal(first.frames(TIMES), StitchedBlend(decomposition).frames(TIMES))


def test_improving_stops_when_it_is_told_to():
    first = StitchedBlend(decomposition_of("arms-over-under"), settled=False)
    asked = []

    def should_stop():
        asked.append(None)
        return len(asked) > 5

    with pytest.raises(Cancelled):
        list(first.improvements(should_stop=should_stop))
    assert len(asked) == 6


@pytest.mark.parametrize("name", CASES)
def test_edges_inside_insist_less_where_the_shape_changes(name):
    mesh = mesh_for(name)
    distortions = edge_distortions(mesh)
    assert distortions.min() >= 1
    even, yielding = (edge_weights(mesh, 3.0, power) for power in (0.0, 1.0))
    np.testing.assert_array_equal(even[mesh.on_ring], yielding[mesh.on_ring])
    inside = ~mesh.on_ring
    np.testing.assert_allclose(even[inside] / yielding[inside], distortions[inside])


def test_only_what_changes_its_shape_is_distorted():
    """A square's half is turned and enlarged, that is no distortion; of the other half two sides shrink."""
    ring = np.array([(0, 0), (4, 0), (4, 4), (0, 4)], dtype=float)
    target = 3 * turned(np.array([(0, 0), (4, 0), (4, 4), (1, 3)], dtype=float), 1.0)
    mesh = mesh_of(Fans(ring, target, np.array([(0, 1, 2), (0, 2, 3)]), ((0,),)))
    by_edge = dict(zip(map(tuple, mesh.edges.tolist()), edge_distortions(mesh), strict=True))
    assert by_edge[0, 1] == pytest.approx(1)
    assert by_edge[1, 2] == pytest.approx(1)
    assert by_edge[0, 3] > 1
    assert 1 < by_edge[0, 2] < by_edge[0, 3]


@pytest.mark.parametrize("name", CASES)
def test_the_whole_area_strays_little(name):
    """arms-over-under was twice as large half-way, settled by a balance that leaves areas as they come."""
    pair = decomposition_of(name).pair
    ends = signed_areas(pair.source), signed_areas(pair.target)
    areas = signed_areas(StitchedBlend(decomposition_of(name)).frames(TIMES))
    strayed = np.log(areas / ((1 - TIMES) * ends[0] + TIMES * ends[1]))
    assert np.abs(strayed).max() < STRAY
