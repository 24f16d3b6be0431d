import numpy as np
import pytest
import shapely

import starskel
from starskel.shapes.structure import structures_at
from tests.starskel.shapes.drawn import FACE, LETTERS, LONG_FACE, I, moved


@pytest.mark.parametrize("method", ["star-skeleton", "stitched", "rigid"])
@pytest.mark.parametrize("angle", [0.0, 2.5])
@pytest.mark.parametrize("name", ["i-j", "B-8", "face"])
def test_pieces_tile_every_part_at_both_ends(method, angle, name):
    source, target = LETTERS[name]
    made = starskel.blend(starskel.Shape(source), starskel.Shape(moved(target, angle, 7, 3)), method=method)
    for t in (0.0, 1.0):
        regions = made.shape_at(t)
        structures = tuple(structures_at(made, t))
        assert len(structures) == len(made.bodies) == len(regions.geoms)
        for structure, region in zip(structures, regions.geoms, strict=True):
            pieces = [
                shapely.Polygon(structure.points[list(p)]) for p in structure.blend.decomposition.pieces
            ]
            assert all(piece.is_valid for piece in pieces)
            assert sum(piece.area for piece in pieces) == pytest.approx(region.area, rel=1e-9)
            assert shapely.union_all(pieces).symmetric_difference(region).area < 1e-6 * region.area


def test_pieces_and_skeleton_move_with_their_part():
    made = starskel.blend(starskel.Shape(I), starskel.Shape(moved(I, 2.0, 30)), method="star-skeleton")
    for t in (0.2, 0.7):
        rings = made.at(t)
        places = made.meta_skeleton.places(np.array([t]))[0]
        for place, structure in zip(places, structures_at(made, t), strict=True):
            own = rings[structure.number]
            np.testing.assert_allclose(structure.points[: len(own)], own, atol=1e-9)
            root = structure.skeleton[structure.blend.skeleton.root]
            np.testing.assert_allclose(root, [place.real, place.imag], atol=1e-9)


def test_what_has_no_pieces_shows_none():
    face, long = starskel.Shape(FACE), starskel.Shape(LONG_FACE)
    for method in ("vertex", "edge-angle", "certified"):
        assert not tuple(structures_at(starskel.blend(face, long, method=method), 0.5))
    lonely = starskel.blend(starskel.Shape(I), starskel.Shape(I[:1]), pairing=[(0, 0), (1, None)])
    assert [structure.number for structure in structures_at(lonely, 0.5)] == [0]
    polygons = starskel.blend(I[0], I[0] * 2)
    (only,) = structures_at(polygons, 0.5)
    np.testing.assert_array_equal(only.points[: len(I[0])], polygons.at(0.5))


def test_the_root_of_a_part_is_where_it_is_wanted():
    source, target = (starskel.Shape(rings) for rings in LETTERS["B-8"])
    usual = starskel.blend(source, target, method="star-skeleton")
    (structure,) = structures_at(usual, 0.0)
    decomposition, root = structure.blend.decomposition, structure.blend.skeleton.root
    other = next(k for k in range(len(decomposition.pieces)) if k != root)
    roots = {(0, 0): tuple(decomposition.source_origins[other])}
    (steered,) = structures_at(starskel.blend(source, target, method="star-skeleton", roots=roots), 0.0)
    assert steered.blend.skeleton.root == other
    for method in ("stitched", "vertex"):  # these know no root
        made = starskel.blend(source, target, method=method, roots=roots)
        plain = starskel.blend(source, target, method=method)
        assert all(map(np.array_equal, made.at(0.4), plain.at(0.4)))


def test_roots_of_what_has_none_are_refused():
    source, target = (starskel.Shape(rings) for rings in LETTERS["B-8"])
    with pytest.raises(starskel.StarskelError, match=r"\(1, 1\) is no pair of outlines.*\(0, 0\)"):
        starskel.blend(source, target, roots={(1, 1): (0, 0)})
    with pytest.raises(starskel.StarskelError, match="two polygons have one root"):
        starskel.blend(I[0], I[0], roots={(0, 0): (0, 0)})
