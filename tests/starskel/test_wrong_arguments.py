"""All public functions, each parameter given what is wrong: only the library's own errors come."""

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import shapely

import starskel
from starskel.errors import StarskelError
from starskel.export.settings import even_times

SQUARE = [(0, 0), (8, 0), (8, 8), (0, 8)]
HOOK = [(0, 0), (6, 0), (6, 5), (3, 5), (3, 4), (5, 4), (5, 1), (0, 1)]
FRAME = starskel.Shape([SQUARE, [(2, 2), (6, 2), (6, 6), (2, 6)]])
PAIR = starskel.match(SQUARE, SQUARE, marks=[(0, 0)])
SHAPE_PAIR = starskel.match(FRAME, FRAME)
REGION_PAIR = SHAPE_PAIR.parts[0].pair
DECOMPOSITION = starskel.decompose(PAIR)
BLEND = starskel.blend(PAIR)
SHAPE_BLEND = starskel.blend(SHAPE_PAIR, method="vertex")

CALLS: list[tuple[str, Callable[..., Any], dict[str, Any]]] = [
    ("Polygon", starskel.Polygon, {"points": SQUARE}),
    ("Polygon.vertex_of", starskel.Polygon(SQUARE).vertex_of, {"given": 0}),
    ("Shape", starskel.Shape, {"rings": [SQUARE]}),
    ("Shape.of_parts", starskel.Shape.of_parts, {"parts": [(SQUARE, [])]}),
    ("Shape.holes", FRAME.holes, {"outline": 0}),
    ("Shape.part", FRAME.part, {"outline": 0}),
    ("match", starskel.match, {"source": SQUARE, "target": SQUARE}),
    ("match", starskel.match, {"source": FRAME, "target": FRAME}),
    ("suggest_marks", starskel.suggest_marks, {"source": SQUARE, "target": SQUARE}),
    ("suggest_pairing", starskel.suggest_pairing, {"source": FRAME, "target": FRAME}),
    ("decompose", starskel.decompose, {"pair": PAIR}),
    ("Decomposition.piece_at", DECOMPOSITION.piece_at, {"place": (1, 1)}),
    *(("blend", starskel.blend, {"source": PAIR, "method": method}) for method in starskel.METHODS),
    ("blend", starskel.blend, {"source": PAIR, "target": "rigid"}),
    ("blend", starskel.blend, {"source": SQUARE, "target": SQUARE, "marks": [(0, 0)]}),
    ("blend", starskel.blend, {"source": SHAPE_PAIR, "method": "vertex"}),
    ("blend", starskel.blend, {"source": FRAME, "target": FRAME, "method": "vertex"}),
    *(
        call
        for name, blend in (("Blend", BLEND), ("ShapeBlend", SHAPE_BLEND))
        for call in (
            (f"{name}.at", blend.at, {"t": 0.5}),
            (f"{name}.frames", blend.frames, {"ts": [0.5]}),
            (f"{name}.improvements", lambda blend=blend, **given: list(blend.improvements(**given)), {}),
            (f"{name}.rings", blend.rings, {"ts": [0.5]}),
            (f"{name}.negative_lengths", blend.negative_lengths, {"ts": [0.5]}),
            ("measure", starskel.measure, {"blend": blend, "frames": 2}),
        )
    ),
    ("even_times", even_times, {"count": 2}),
    ("ShapeBlend.shape_at", SHAPE_BLEND.shape_at, {"t": 0.5}),
]

LARGE, LARGER = 10**30, 10**400

WRONG = [
    None,
    -1,
    2.5,
    float("nan"),
    LARGE,
    LARGER,
    1j,
    "nonsense",
    b"nonsense",
    object(),
    [None],
    [[]],
    [(0,)],
    [(0, 0, 0)],
    [("a", "b")],
    {"a": "b"},
    {(0, None): 1},
    {(0, None): (1, float("nan"))},
    np.zeros((2, 2, 2)),
    np.array(["a", "b"]),
    np.array([None, 1]),
    shapely.Point(1, 1),
    shapely.LineString([(0, 0), (8, 0), (8, 8)]),
    shapely.MultiLineString([[(0, 0), (1, 1)], [(2, 0), (3, 3)]]),
    shapely.MultiPoint([(0, 0), (8, 0), (8, 8)]),
    shapely.MultiPolygon(),
    shapely.Polygon(),
    REGION_PAIR,
    starskel.decompose(starskel.match(HOOK, HOOK, marks=[(0, 0)])),
    BLEND.skeleton,
]

RIGHT = {
    ("blend", "turns"): [-1],
    ("blend", "root"): [LARGE, LARGER],  # where the method has no pieces
    ("suggest_marks", "count"): [LARGE, LARGER],
}
"""What is not wrong here, besides None where that is the default."""


def parameters(name: str, call: Callable[..., Any]) -> list[str]:
    if name.endswith("improvements"):
        return ["progress", "should_stop"]
    return list(inspect.signature(call).parameters)


def is_right(name: str, call: Callable[..., Any], parameter: str, value: object) -> bool:
    if value is None:
        return name.endswith("improvements") or inspect.signature(call).parameters[parameter].default is None
    return any(value is right for right in RIGHT.get((name, parameter), []))


@pytest.mark.parametrize(
    ("name", "call", "given", "parameter"),
    [
        pytest.param(name, call, given, parameter, id=f"{name}-{number}-{parameter}")
        for number, (name, call, given) in enumerate(CALLS)
        for parameter in parameters(name, call)
    ],
)
def test_what_is_wrong_ends_in_an_error_of_the_library(
    name: str, call: Callable[..., Any], given: dict[str, Any], parameter: str
) -> None:
    for value in WRONG:
        if is_right(name, call, parameter, value):
            continue
        with pytest.raises(StarskelError) as raised:
            call(**{**given, parameter: value})
        assert raised.value.what, value
        assert raised.value.mend, value


def test_all_public_functions_and_methods_are_walked() -> None:
    walked = {name for name, *_ in CALLS}
    made_by_others = {"Correspondence", "ShapeCorrespondence", "Skeleton", "Report", "ShapeReport"}
    pictures = {"ImageMorph", "PlacedImage", "image_morph", "trace"}
    public = {name: getattr(starskel, name) for name in starskel.__all__}
    for name in made_by_others | pictures | {"METHODS"}:
        del public[name]
    functions = {name for name, found in public.items() if inspect.isfunction(found)}
    methods = {
        f"{name}.{key}"
        for name, found in public.items()
        if inspect.isclass(found) and not issubclass(found, StarskelError)
        for key, method in inspect.getmembers(found, callable)
        if not key.startswith("_") and set(inspect.signature(method).parameters) - {"self"}
    }
    assert (functions | methods) - walked == set()
