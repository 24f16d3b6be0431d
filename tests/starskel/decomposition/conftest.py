import pytest

from tests.families import comb, spiral, subdivided, turned, two_opt

RINGS = {
    "random": two_opt(24, 1),
    "grid": two_opt(24, 2, 6),
    "comb": comb(4),
    "spiral": spiral(30),
    "rounded straight runs": turned(subdivided(two_opt(8, 6), 3), 0.4),
}


@pytest.fixture(params=list(RINGS))
def ring(request):
    return RINGS[request.param]
