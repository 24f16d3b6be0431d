from collections import Counter

import numpy as np
import pytest

from starskel.blending.meshes.distortion import Shapes
from starskel.blending.meshes.fans import fans_of
from starskel.blending.meshes.flips import flipped
from starskel.blending.meshes.hub_places import derivatives, free_fans, with_hubs_moved
from starskel.polar import as_complex
from starskel.task import Task
from tests.starskel.blending.cases import CASES, decomposition_of


def fans_for(name):
    decomposition = decomposition_of(name)
    fans = fans_of(decomposition, Task())
    shapes = Shapes.of(as_complex(fans.source), as_complex(fans.target), fans.triangles)
    return len(decomposition.source), fans.triangles, shapes


def test_the_distortion_is_that_of_the_singular_values():
    source, target = np.array([0, 2 + 1j, 1 + 3j]), np.array([1j, 3 + 2j, -1 + 2j])
    shapes = Shapes(source, target, (1.0, 1.0))
    sides = [np.array([[e.real, e.imag] for e in z[1:] - z[0]]).T for z in (source, target)]
    values = np.linalg.svd(sides[1] @ np.linalg.inv(sides[0]), compute_uv=False)
    areas = [abs(np.linalg.det(side)) / 2 for side in sides]
    expected = areas[0] * (values**2).sum() + areas[1] * (values**-2).sum()
    assert shapes.distortions(np.array([[0, 1, 2]]))[0] == pytest.approx(expected)


@pytest.mark.parametrize("name", CASES)
def test_moved_hubs_distort_less_and_no_triangle_loses_its_area(name):
    rows, triangles, shapes = fans_for(name)
    moved = with_hubs_moved(shapes, triangles, rows, Task())
    np.testing.assert_array_equal(moved.source[:rows], shapes.source[:rows])
    np.testing.assert_array_equal(moved.target[:rows], shapes.target[:rows])
    kept = shapes.have_area(triangles)
    np.testing.assert_array_equal(moved.have_area(triangles), kept)
    assert moved.distortions(triangles)[kept].sum() <= 1.01 * shapes.distortions(triangles)[kept].sum()


@pytest.mark.parametrize("name", ["run-walk", "hand-open", "random-16-7"])
def test_hubs_come_to_rest(name):
    rows, triangles, shapes = fans_for(name)
    fans = free_fans(shapes, triangles, rows)
    assert len(fans.hubs)
    moved = with_hubs_moved(shapes, triangles, rows, Task())
    there = fans.moved(
        np.stack(
            [
                part
                for z, w in ((moved.source, shapes.source), (moved.target, shapes.target))
                for part in ((z - w)[fans.hubs].real, (z - w)[fans.hubs].imag)
            ],
            axis=1,
        )
    )
    before, least = fans.distortions(shapes), fans.distortions(there)
    assert (least <= before).all()
    assert (least < 0.999 * before).any()
    at_rest = free_fans(there, triangles, rows)
    slopes, curvatures = derivatives(
        type(fans)(there, at_rest.hubs, at_rest.triangles, at_rest.owners, fans.spread)
    )
    gains = np.einsum("hi,hij,hj->h", slopes, np.linalg.inv(curvatures), slopes)
    assert (np.abs(gains) < 1e-6 * least).all()


def test_derivatives_are_those_of_the_distortion():
    rows, triangles, shapes = fans_for("run-walk")
    fans = free_fans(shapes, triangles, rows)
    slopes, curvatures = derivatives(fans)
    width = 1e-4
    axes = width * np.eye(4)

    def at(step):
        return fans.distortions(fans.moved(np.tile(step, (len(fans.hubs), 1))))

    for i in range(4):
        np.testing.assert_allclose(
            (at(axes[i]) - at(-axes[i])) / (2 * width), slopes[:, i], rtol=1e-2, atol=1e-4
        )
        for j in range(4):
            twice = (
                at(axes[i] + axes[j]) - at(axes[i] - axes[j]) - at(axes[j] - axes[i]) + at(-axes[i] - axes[j])
            )
            scale = np.abs(curvatures).max(axis=(1, 2))
            np.testing.assert_array_less(np.abs(twice / (4 * width**2) - curvatures[:, i, j]), 0.02 * scale)


@pytest.mark.parametrize("name", CASES)
def test_flipping_keeps_a_triangulation_of_both_and_lessens_the_distortion(name):
    _, triangles, shapes = fans_for(name)
    after = flipped(triangles, shapes, Task())
    assert after.shape == triangles.shape
    for before_areas, areas in zip(shapes.areas(triangles), shapes.areas(after), strict=True):
        assert areas.sum() == pytest.approx(before_areas.sum())
        assert areas.min() > -1e-12
    uses = Counter(
        (int(a), int(b)) for triangle in after for a, b in zip(triangle, np.roll(triangle, -1), strict=True)
    )
    assert max(uses.values()) == 1
    outer = {edge for edge in uses if edge[::-1] not in uses}
    old = {(int(a), int(b)) for tri in triangles for a, b in zip(tri, np.roll(tri, -1), strict=True)}
    assert outer == {edge for edge in old if edge[::-1] not in old}
    if not np.array_equal(after, triangles):
        assert shapes.distortions(after).sum() < shapes.distortions(triangles).sum()


def test_the_better_diagonal_of_a_sheared_square_is_taken():
    source = np.array([0, 1, 1 + 1j, 1j])
    target = np.array([0, 1, 2 + 1j, 1 + 1j])
    poor, good = np.array([(0, 1, 2), (0, 2, 3)]), np.array([(0, 1, 3), (1, 2, 3)])
    shapes = Shapes.of(source, target, poor)
    sums = [float(shapes.distortions(each).sum()) for each in (poor, good)]
    assert sums[0] == pytest.approx(sums[1])  # an affine map distorts every triangle alike
    np.testing.assert_array_equal(flipped(poor, shapes, Task()), poor)
    bent = Shapes.of(source, target + np.array([0, 0, 0.5j, 0]), poor)
    chosen = flipped(poor, bent, Task())
    least = min(float(bent.distortions(each).sum()) for each in (poor, good))
    assert float(bent.distortions(chosen).sum()) == pytest.approx(least)
