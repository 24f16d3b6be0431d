from dataclasses import replace

import numpy as np
import pytest

from starskel.blending.meshes.fans import fans_of
from starskel.blending.meshes.mesh import mesh_of, triangle_areas
from starskel.blending.rigid import RigidBlend
from starskel.blending.rigid_triangles import RigidTriangles, side_weights, triangle_rotations
from starskel.correspondence import match
from starskel.decomposition import decompose
from starskel.outline import cross_themselves
from starskel.polar import as_points
from starskel.task import Task
from tests.starskel.blending.cases import CASES, NAMED, decomposition_of

TIMES = np.linspace(0, 1, 103)


def mesh_for(name):
    decomposition = decomposition_of(name)
    return mesh_of(fans_of(decomposition, Task()))


def affine_maps(source, target):
    """The matrices that take the sides of each source triangle to those of the target's."""
    sides = [np.stack([as_points(z[:, k] - z[:, 0]) for k in (1, 2)], axis=-1) for z in (source, target)]
    return sides[1] @ np.linalg.inv(sides[0])


def flatness(corners):
    longest = np.abs(np.roll(corners, -1, axis=1) - corners).max(axis=1)
    return 2 * np.abs(triangle_areas(corners)) / longest**2


def with_area(mesh):
    areas = mesh.source_areas / mesh.source_areas.sum(), mesh.target_areas / mesh.target_areas.sum()
    return np.minimum(*areas) > 1e-6


@pytest.mark.parametrize("name", CASES)
def test_rotations_are_those_of_the_polar_decomposition(name):
    """Against the nearest rotation by singular values; the triangles are sheared strongly, too."""
    mesh = mesh_for(name)
    kept = with_area(mesh)
    left, _, right = np.linalg.svd(
        affine_maps(mesh.source[mesh.triangles[kept]], mesh.target[mesh.triangles[kept]])
    )
    nearest = left @ right
    np.testing.assert_allclose(np.linalg.det(nearest), 1.0)
    angles = np.arctan2(nearest[:, 1, 0], nearest[:, 0, 0])
    off = np.exp(1j * triangle_rotations(mesh)[kept]) - np.exp(1j * angles)
    np.testing.assert_allclose(np.abs(off), 0, atol=1e-6)


@pytest.mark.parametrize("name", CASES)
def test_triangles_turn_by_less_than_a_quarter_turn_more_than_each_of_their_edges(name):
    mesh = mesh_for(name)
    kept = with_area(mesh)
    turns = triangle_rotations(mesh)[kept, None] - mesh.wishes.rotations[mesh.sides[kept]]
    assert np.abs(turns).max() < np.pi / 2 + 1e-6


def test_a_spiral_unrolls_by_more_than_half_a_turn():
    """The shortest way would turn no triangle by more than half a turn from another."""
    rotations = triangle_rotations(mesh_for("spiral-opposite"))
    assert np.ptp(rotations) > 2 * np.pi


@pytest.mark.parametrize("name", ["run-walk", "hand-open", "random-12-5", "wrench-hammer"])
def test_frames_come_nearest_to_the_triangles_maps(name):
    """The gradient of the sum over both shapes of area times squared Frobenius norm vanishes.

    Triangles lower than a hundredth of their longest side count less, in proportion.
    """
    mesh = mesh_for(name)
    if not with_area(mesh).all():
        pytest.skip("triangles without area have no affine map")
    t = 0.4
    rotations = triangle_rotations(mesh)
    turn = np.stack(
        [np.cos(t * rotations), -np.sin(t * rotations), np.sin(t * rotations), np.cos(t * rotations)]
    )
    turn = np.moveaxis(turn.reshape(2, 2, -1), -1, 0)
    back = np.stack([np.cos(rotations), np.sin(rotations), -np.sin(rotations), np.cos(rotations)])
    back = np.moveaxis(back.reshape(2, 2, -1), -1, 0)
    maps = affine_maps(mesh.source[mesh.triangles], mesh.target[mesh.triangles])
    wished = turn @ ((1 - t) * np.eye(2) + t * back @ maps)

    masses = [
        np.abs(triangle_areas(z)) * np.minimum(flatness(z) / 0.01, 1)
        for z in (mesh.source[mesh.triangles], mesh.target[mesh.triangles])
    ]

    def energy(points):
        from_source = affine_maps(mesh.source[mesh.triangles], points[mesh.triangles]) - wished
        from_target = affine_maps(
            mesh.target[mesh.triangles], points[mesh.triangles]
        ) - wished @ np.linalg.inv(maps)
        squares = [(difference**2).sum(axis=(1, 2)) for difference in (from_source, from_target)]
        return float(masses[0] @ squares[0] + masses[1] @ squares[1])

    points = RigidTriangles.of(mesh).points(np.array([t]))[0]
    least = energy(points)
    rng = np.random.default_rng(3)
    for _ in range(20):
        step = 1e-3 * mesh.size * (rng.normal(size=len(points)) + 1j * rng.normal(size=len(points)))
        there, back_there = energy(points + step), energy(points - step)
        assert min(there, back_there) > least
        assert abs(there - back_there) < 0.02 * (there + back_there - 2 * least)


@pytest.mark.parametrize("name", CASES)
def test_weights_of_all_triangles_ask_for_nothing_negative(name):
    """Cotangents may be negative, the energy of a triangle may not, however flat it is."""
    mesh = mesh_for(name)
    weights = side_weights(mesh)
    for triangle in weights:
        matrix = np.zeros((3, 3))
        for c in range(3):
            d = (c + 1) % 3
            matrix[[c, d], [c, d]] += triangle[c]
            matrix[[c, d], [d, c]] -= triangle[c]
        assert np.linalg.eigvalsh(matrix).min() > -1e-9 * np.abs(matrix).max()


@pytest.mark.parametrize("name", [name for name in NAMED if name != "arms-over-under"])
def test_no_frame_of_these_pairs_crosses_itself(name):
    assert not cross_themselves(RigidBlend(decomposition_of(name)).frames(TIMES)).any()


@pytest.mark.parametrize("name", ["run-walk", "hand-open", "random-12-5"])
def test_the_problem_itself_is_the_same_from_either_shape(name):
    """Not only because the pair is put in order: the mesh exchanged moves backwards."""
    mesh = mesh_for(name)
    wishes = replace(
        mesh.wishes,
        source_lengths=mesh.wishes.target_lengths,
        target_lengths=mesh.wishes.source_lengths,
        rotations=-mesh.wishes.rotations,
    )
    exchanged = replace(
        mesh,
        source=mesh.target,
        target=mesh.source,
        source_areas=mesh.target_areas,
        target_areas=mesh.source_areas,
        wishes=wishes,
    )
    times = np.array([0.2, 0.5, 0.7])
    there, back = RigidTriangles.of(mesh).points(times), RigidTriangles.of(exchanged).points(1 - times)
    off = (there - there[:, :1]) - (back - back[:, :1])
    np.testing.assert_allclose(np.abs(off), 0, atol=1e-9 * mesh.size)


def test_a_vertex_that_is_the_hub_of_triangles_without_area_stays_in_place():
    """Edges on rays from vertex 0 leave nothing else in the kernel, and flat triangles in the fan."""
    source = np.array([(0, 0), (6, 0), (6, 3), (2, 1), (1, 2), (3, 6), (0, 6)], dtype=float)
    target = np.array([(0, 0), (6, 0), (8, 4), (2, 1), (1, 2), (2, 4), (0, 5)], dtype=float)
    blend = RigidBlend(decompose(match(source, target, [(k, k) for k in range(7)])))
    frames = blend.frames(TIMES)
    assert np.abs(blend.errors).max() < 1e-9
    assert not cross_themselves(frames).any()


def test_flat_in_both_shapes_a_triangle_turns_as_its_edges_do():
    source = np.array([0, 1, 3, 2 + 2j]) + 0j
    turn = np.exp(2.5j)
    mesh = mesh_for("letter-T-Y")
    flat = replace(
        mesh,
        source=source,
        target=turn * source,
        triangles=np.array([(0, 1, 2), (0, 2, 3)]),
        edges=np.array([(0, 1), (1, 2), (0, 2), (2, 3), (0, 3)]),
        sides=np.array([(0, 1, 2), (2, 3, 4)]),
        on_ring=np.ones(5, dtype=bool),
        wishes=replace(
            mesh.wishes,
            source_lengths=np.ones(5),
            target_lengths=np.ones(5),
            angles=np.zeros(5),
            rotations=np.full(5, 2.5),
        ),
        source_areas=triangle_areas(source[[(0, 1, 2), (0, 2, 3)]]),
        target_areas=triangle_areas((turn * source)[[(0, 1, 2), (0, 2, 3)]]),
    )
    np.testing.assert_allclose(triangle_rotations(flat), 2.5)
