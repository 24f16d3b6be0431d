import numpy as np

from app.compute import trace_of
from starskel import match

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]


def test_a_vertex_leads_to_its_partner_and_back() -> None:
    pair = match(SQUARE, np.array(SQUARE) + 20, [(0, 1)])
    trace = trace_of(pair, "source", 3)
    assert trace is not None
    assert (trace.source, trace.source_vertex) == ((0, 10), 3)
    assert (trace.target, trace.target_vertex) == ((20, 20), 0)
    assert trace_of(pair, "target", 0) == trace


def test_a_partner_may_be_inserted() -> None:
    pair = match(SQUARE, [(0, 0), (10, 0), (5, 10)], [(0, 0), (1, 1)])
    traces = [trace_of(pair, "source", vertex) for vertex in range(4)]
    inserted = [trace for trace in traces if trace is not None and trace.vertex("target") is None]
    assert len(inserted) >= 1
    assert all(pair.target[trace.row].tolist() == list(trace.place("target")) for trace in inserted)


def test_an_unknown_vertex_has_no_partner() -> None:
    assert trace_of(match(SQUARE, SQUARE, [(0, 0)]), "target", 9) is None
