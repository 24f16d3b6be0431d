"""GeoJSON and WKT read."""

import json

import pytest
import shapely

from starskel.errors import InvalidFile
from starskel.reading.readers import ENDINGS, read_shapes

SQUARE = [[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]
HOLE = [[2, 2], [2, 4], [4, 4], [2, 2]]
ISLAND = [[20, 0], [23, 0], [20, 4], [20, 0]]


def geojson(folder, *geometries, **properties):
    features = [{"type": "Feature", "properties": properties, "geometry": own} for own in geometries]
    path = folder / "map.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    return read_shapes(path)


def wkt(folder, text):
    (folder / "map.wkt").write_text(text)
    return read_shapes(folder / "map.wkt")


def test_features_become_shapes_with_their_names_parts_and_holes(tmp_path):
    parts = {"type": "MultiPolygon", "coordinates": [[SQUARE, HOLE], [ISLAND]]}
    reading = geojson(tmp_path, parts, {"type": "Polygon", "coordinates": [ISLAND]}, name="land")
    assert [found.name for found in reading.shapes] == ["land", "land 2"]
    assert reading.shapes[0].shape.outer == (-1, 0, -1)
    assert reading.shapes[0].shape.area == 81 - 2 + 6
    assert reading.repairs == reading.notes == ()


def test_a_bare_geometry_and_a_closed_line_are_shapes_too_and_points_are_not(tmp_path):
    (tmp_path / "a.geojson").write_text(json.dumps({"type": "LineString", "coordinates": SQUARE[:-1]}))
    (found,) = read_shapes(tmp_path / "a.geojson").shapes
    assert (found.name, found.shape.area, found.repairs) == ("shape 1", 81, ("an open path was closed",))
    reading = geojson(
        tmp_path, {"type": "Point", "coordinates": [0, 0]}, {"type": "Polygon", "coordinates": [SQUARE]}
    )
    assert reading.notes == ("features without an area were left out: 1",)


def test_wkt_holds_one_geometry_or_many_on_one_line_or_several(tmp_path):
    shapes = [shapely.Polygon(SQUARE, [HOLE]), shapely.MultiPolygon([shapely.Polygon(ISLAND)])]
    assert wkt(tmp_path, shapes[0].wkt).shapes[0].shape.area == 79
    reading = wkt(tmp_path, "SRID=4326;" + "\n".join(shape.wkt.replace(", ", ",\n") for shape in shapes))
    assert [found.shape.area for found in reading.shapes] == [79, 6]
    assert [
        found.shape.area for found in wkt(tmp_path, "POLYGON Z ((0 0 5, 4 0 5, 0 4 5, 0 0 5))").shapes
    ] == [8]


def test_an_area_that_crosses_itself_is_mended_and_told(tmp_path):
    (found,) = wkt(tmp_path, "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))").shapes
    assert found.shape.area == pytest.approx(8)
    assert "Self-intersection at (2 2)" in found.repairs[0]


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.geojson", "{", "is damaged"),
        ("a.geojson", '{"type": "Recipe"}', "is no GeoJSON"),
        ("a.geojson", '{"type": "FeatureCollection", "features": []}', "holds no shape"),
        ("a.geojson", '{"type": "Polygon", "coordinates": [[[0, 0], [1, 1]]]}', "is damaged"),
        ("a.wkt", "hello", "is no WKT"),
        ("a.wkt", "POLYGON ((0 0, 1 1", "geometry 1 of the WKT is damaged"),
        ("a.wkt", "POINT (1 1)", "holds no shape"),
        ("a.dxf", "", f"end.* in {ENDINGS[0]}"),
    ],
)
def test_what_cannot_be_read_is_told(tmp_path, name, text, message):
    (tmp_path / name).write_text(text)
    with pytest.raises(InvalidFile, match=message) as caught:
        read_shapes(tmp_path / name)
    assert name in str(caught.value)
