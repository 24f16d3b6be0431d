"""Blends of shapes do not depend on where, how large, and in which order shapes are given."""

import numpy as np
import pytest

import starskel
from starskel.files.projects.examples import example
from tests.starskel.shapes.drawn import moved
from tests.starskel.shapes.regions import holed_pair, parts_in_a_row

EXAMPLES = ("letters-a-r", "letters-i-j", "figure-9-fish")
METHODS = ("stitched", "rigid", "star-skeleton", "edge-angle", "vertex")
TIMES = np.array([0.2, 0.5, 0.9])


def given(name):
    """Both shapes as lists of rings, and marks that fix how rows correspond, so that none are suggested."""
    pair = example(name).pair(0)
    matched = starskel.match(pair.source, pair.target, pair.marks, pairing=pair.pairing)
    frames = starskel.blend(matched, method="vertex").frames([0, 1])
    return *frames, [[(k, k) for k in range(len(ring))] for ring in frames[0]]


def frames(source, target, marks, method):
    pairing = [(k, k) for k in range(len(source))]
    made = starskel.blend(starskel.Shape(source), starskel.Shape(target), marks, method, pairing=pairing)
    return [np.stack(rings) for rings in zip(*made.frames(TIMES), strict=True)]


def assert_like(found, expected):
    size = max(np.ptp(ring, axis=(0, 1)).max() for ring in expected)
    for one, other in zip(found, expected, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-7 * size)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", EXAMPLES)
def test_scaled_and_moved_shapes_have_the_same_frames(name, method):
    source, target, marks = given(name)
    expected = frames(source, target, marks, method)
    for scale, offset in ((1e6, 0.0), (1e-6, 100e-6)):
        found = frames(
            [scale * ring + offset for ring in source],
            [scale * ring + offset for ring in target],
            marks,
            method,
        )
        assert_like([(ring - offset) / scale for ring in found], expected)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", EXAMPLES)
def test_the_order_of_rings_does_not_matter(name, method):
    source, target, marks = given(name)
    expected = frames(source, target, marks, method)
    found = frames(source[::-1], target[::-1], marks[::-1], method)
    assert_like(found[::-1], expected)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", EXAMPLES)
def test_exchanged_shapes_go_the_same_way_back(name, method):
    source, target, marks = given(name)
    pairing = [(k, k) for k in range(len(source))]
    there, back = (
        starskel.blend(starskel.Shape(a), starskel.Shape(b), marks, method, pairing=pairing)
        for a, b in ((source, target), (target, source))
    )
    for t in TIMES:
        assert_like([r[None] for r in back.at(1 - t)], [r[None] for r in there.at(t)])


@pytest.mark.parametrize("method", ["star-skeleton", "stitched"])
@pytest.mark.parametrize("seed", [19, 26, 35])
def test_exchanged_parts_that_turn_and_have_holes_go_the_same_way_back(seed, method):
    """The target was always turned back, and bridges led this way or that as rows happened to be counted."""
    source, target = map(starskel.Shape, parts_in_a_row(seed))
    there, back = (starskel.blend(a, b, method=method) for a, b in ((source, target), (target, source)))
    ways = {link[::-1]: ring for link, ring in zip(back.pair.pairing, back.at(0.7), strict=True)}
    size = max(np.ptp(ring, axis=0).max() for ring in there.at(0))
    for link, ring in zip(there.pair.pairing, there.at(0.3), strict=True):
        shifts = [np.abs(ring - np.roll(ways[link], k, axis=0)).max() for k in range(len(ring))]
        assert min(shifts) < 1e-9 * size


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", [*EXAMPLES, "letters-b-8"])
def test_mirrored_shapes_have_mirrored_frames(name, method):
    source, target, marks = given(name)

    def mirrored(rings):
        return [(ring * [-1, 1])[::-1] for ring in rings]

    expected = frames(source, target, marks, method)
    found = frames(mirrored(source), mirrored(target), marks, method)
    assert_like([(ring * [-1, 1])[:, ::-1] for ring in found], expected)


@pytest.mark.parametrize("seed", [14])
def test_a_morph_of_all_rings_is_turned_mirrored_and_goes_back_as_the_shapes(seed):
    """The square round them lay straight, and the way was sought from the source, whatever that was."""
    source, target = starskel.blend(holed_pair(seed), method="vertex").frames([0, 1])
    marks = [[(k, k) for k in range(len(ring))] for ring in source]
    pairing = [(k, k) for k in range(len(source))]

    def half_way(one, other):
        made = starskel.blend(starskel.Shape(one), starskel.Shape(other), marks, "certified", pairing=pairing)
        assert made.how == "convex morph"
        return [ring[None] for ring in made.at(0.5)]

    expected = half_way(source, target)
    assert_like(half_way(target, source), expected)
    turned = half_way(*([1e-6 * ring for ring in moved(rings, 2.9)] for rings in (source, target)))
    assert_like([ring[None] for ring in moved([1e6 * ring[0] for ring in turned], -2.9)], expected)
    mirrored = half_way(*([(ring * [-1, 1])[::-1] for ring in rings] for rings in (source, target)))
    assert_like([(ring * [-1, 1])[:, ::-1] for ring in mirrored], expected)
