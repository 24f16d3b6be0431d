"""The page that sums a batch up."""

from collections.abc import Iterable, Sequence
from html import escape
from statistics import median
from typing import Any

from starskel.command.batches.work import Outcome
from starskel.files.page import page, table
from starskel.sheet.words import counted, percent


def summary_page(outcomes: Iterable[Outcome], methods: Sequence[str]) -> str:
    """Give the page: figures of each method over all pairs, failures by name, a line for each pair."""
    ordered = sorted(outcomes, key=lambda outcome: outcome.key)
    failed = [outcome for outcome in ordered if outcome.error]
    rows = [_method_row(method, ordered) for method in methods]
    pairs = [[escape(o.key), *(_verdict(o, method) for method in methods)] for o in ordered]
    failures = [[escape(outcome.key), escape(outcome.error)] for outcome in failed]
    heads = ("Method", "Pairs", "Simple", "Natural", "Crossing", "Median area drift")
    return page(
        "starskel batch",
        [
            "<main>",
            f"<h1>{counted(len(ordered), 'pair')}, {counted(len(failed), 'failure')}</h1>",
            table(heads, rows, ()),
            *(["<h2>Failures</h2>", table(("Pair", "Why"), failures, ("Why",))] if failures else []),
            "<h2>Pairs</h2>",
            table(("Pair", *methods), pairs, methods),
            "</main>",
        ],
    )


def _method_row(method: str, outcomes: Sequence[Outcome]) -> list[str]:
    own = [figures for outcome in outcomes for figures in outcome.figures if figures["method"] == method]
    kinds = [_kind(figures) for figures in own]
    drift = percent(median(figures["area_deviation"] for figures in own)) if own else "-"
    return [
        method,
        str(len(own)),
        *(str(kinds.count(kind)) for kind in ("simple", "natural", "crosses")),
        drift,
    ]


def _kind(figures: dict[str, Any]) -> str:
    if figures["simple"]:
        return "simple"
    return "crosses" if figures["harmful_frames"] or not figures["natural_frames"] else "natural"


def _verdict(outcome: Outcome, method: str) -> str:
    own = next((figures for figures in outcome.figures if figures["method"] == method), None)
    return "-" if own is None else f"{_kind(own)}, {percent(own['area_deviation'])}"
