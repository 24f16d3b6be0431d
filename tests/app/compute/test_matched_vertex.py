import numpy as np

from app.compute import matched_vertex
from starskel import match

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]


def test_a_vertex_leads_to_its_partner_and_back() -> None:
    pair = match(SQUARE, np.array(SQUARE) + 20, [(0, 1)])
    matched = matched_vertex(pair, "source", 3)
    assert matched is not None
    assert (matched.source, matched.source_vertex) == ((0, 10), 3)
    assert (matched.target, matched.target_vertex) == ((20, 20), 0)
    assert matched_vertex(pair, "target", 0) == matched


def test_a_partner_may_be_inserted() -> None:
    pair = match(SQUARE, [(0, 0), (10, 0), (5, 10)], [(0, 0), (1, 1)])
    vertices = [matched_vertex(pair, "source", vertex) for vertex in range(4)]
    inserted = [each for each in vertices if each is not None and each.vertex("target") is None]
    assert len(inserted) >= 1
    assert all(pair.target[each.row].tolist() == list(each.place("target")) for each in inserted)


def test_an_unknown_vertex_has_no_partner() -> None:
    assert matched_vertex(match(SQUARE, SQUARE, [(0, 0)]), "target", 9) is None
