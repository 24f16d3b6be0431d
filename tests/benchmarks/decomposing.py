"""How visibility and decomposition grow with the number of vertices."""

import time

import numpy as np
import shapely

from starskel.correspondence import Correspondence
from starskel.decomposition import decompose
from starskel.decomposition.verify import faults
from starskel.points import points_of
from starskel.rings import Rings
from starskel.triangulation import triangulate
from starskel.visibility import visibility
from tests.benchmarks.timing import exponent, seconds, table
from tests.families import blob, comb, related, spiral, subdivided, two_opt

SHAPES = {
    "smooth": lambda n: (blob(n, 1), blob(n, 2)),
    "spiral": lambda n: (spiral(n, 2), spiral(n, 1.5)),
    "random": lambda n: (two_opt(n, 1), two_opt(n, 1)),
}


def paired(source, target) -> Correspondence:
    rows = np.arange(len(source))
    return Correspondence(source, target, (), rows, rows)


def ground_of(ring):
    return triangulate(points_of(ring), Rings.of([range(len(ring))]))


def all_pairs(ring):
    return visibility(ground_of(ring))


def all_pairs_by_shapely(ring):
    polygon = shapely.Polygon(ring)
    shapely.prepare(polygon)
    i, j = np.triu_indices(len(ring), 1)
    return shapely.covers(polygon, shapely.linestrings(np.stack([ring[i], ring[j]], axis=1)))


def visibility_against_shapely(most: int) -> None:
    """Time all pairs of the first shape of each kind; shapely as far as it ends within a second or two."""
    for name, shapes in SHAPES.items():
        rows, times = [], []
        sizes = [n for n in (50, 100, 200, 400, 1000, 2000) if n <= most]
        for n in sizes:
            ring, _ = shapes(n)
            times.append(seconds(lambda r=ring: all_pairs(r)))
            theirs = seconds(lambda r=ring: all_pairs_by_shapely(r)) if n <= 400 else float("nan")
            triangulated = seconds(lambda r=ring: ground_of(r))
            seen = float(all_pairs(ring).sees.mean())
            rows.append((n, times[-1] * 1e3, triangulated * 1e3, theirs * 1e3, theirs / times[-1], seen))
        title = f"Visibility of all pairs, {name} rings: grows by the power {exponent(sizes, times):.2f}"
        table(title, ("vertices", "ms", "of it triangles", "shapely ms", "times faster", "share seen"), rows)


def growth(most: int) -> None:
    sizes = [n for n in (50, 100, 250, 500, 1000, 2000) if n <= most]
    for name, shapes in SHAPES.items():
        rows, times = [], []
        for n in [n for n in sizes if name != "random" or n <= 500]:
            pair = paired(*shapes(n))
            times.append(seconds(lambda p=pair: decompose(p)))
            rows.append((n, times[-1] * 1e3, times[-1] / times[0], len(decompose(pair).pieces)))
        tail = [k for k, row in enumerate(rows) if row[0] >= 250]
        fitted = (
            exponent([rows[k][0] for k in tail], [times[k] for k in tail]) if len(tail) > 1 else float("nan")
        )
        title = f"Decomposition, {name}: grows by the power {fitted:.2f} from 250 vertices on"
        table(title, ("vertices", "ms", f"times n={sizes[0]}", "pieces"), rows)


def stopping(most: int) -> None:
    """Show for how long work may go on before it asks whether to stop, in processor time."""
    kinds = {
        **SHAPES,
        "smooth, spiral": lambda n: (blob(n, 5), spiral(n, 2)),
        "two random": lambda n: (two_opt(n, 1), two_opt(n, 2)),
    }
    rows = []
    for name, shapes in kinds.items():
        pair = paired(*shapes(most))
        asked = [time.process_time()]

        def should_stop(asked=asked) -> bool:
            asked.append(time.process_time())
            return False

        placed = len(decompose(pair, should_stop=should_stop).source) - most
        rows.append((name, placed, asked[-1] - asked[0], len(asked) - 1, float(np.diff(asked).max()) * 1e3))
    columns = ("shapes", "Steiner", "seconds", "times asked", "longest gap ms")
    table(f"Asking whether to stop, {most} vertices", columns, rows)


def steiner_vertices(seed: int, pairs: int) -> None:
    families = {
        "random 12": lambda k: (two_opt(12, seed + k), two_opt(12, seed + k + 1000)),
        "random 20": lambda k: (two_opt(20, seed + k), two_opt(20, seed + k + 1000)),
        "related 20": lambda k: related(20, seed + k),
    }
    rows = []
    for name, family in families.items():
        found = [decompose(paired(*family(k))) for k in range(pairs)]
        placed = [len(d.source) - len(d.pair) for d in found]
        pieces = [len(d.pieces) for d in found]
        rows.append(
            (name, float(np.median(placed)), float(np.mean(placed)), max(placed), float(np.mean(pieces)))
        )
    table("Steiner vertices", ("family", "median", "mean", "most", "mean pieces"), rows)


def mixed_pair(kind: int, n: int, first: int, second: int) -> Correspondence:
    grid = int(np.ceil(1.5 * np.sqrt(n))) + first % 4  # on fuller grids a tour seldom untangles
    match kind:
        case 0:
            return paired(two_opt(n, first), two_opt(n, second))
        case 1:
            return paired(two_opt(n, first, grid), two_opt(n, second, grid))
        case 2:
            return paired(*related(min(n, 40), first))
        case 3:
            return paired(spiral(n // 2 * 2, 2), np.roll(spiral(n // 2 * 2, 1.2), first % n, axis=0))
        case 4:
            return paired(comb(max(2, n // 4)), np.roll(comb(max(2, n // 4)), first % n, axis=0))
        case _:
            return paired(
                subdivided(two_opt(n // 5 + 3, first), 5), subdivided(two_opt(n // 5 + 3, second), 5)
            )


def any_seed(seed: int, pairs: int) -> None:
    """Decompose pairs of all kinds and prove every result."""
    rng = np.random.default_rng(seed)
    wrong = 0
    for k in range(pairs):
        first, second = (int(s) for s in rng.integers(2**31, size=2))
        wrong += bool(faults(decompose(mixed_pair(k % 6, int(8 + 192 * rng.random() ** 2), first, second))))
    print(f"\n{pairs} pairs of seed {seed}: {pairs - wrong} proven, {wrong} wrong")
