"""The page that sums a batch up."""

from collections.abc import Iterable, Sequence
from html import escape
from statistics import median
from typing import Any

from starskel.command.batches.work import Outcome
from starskel.files.examples import resource_folder
from starskel.sheet.words import counted, percent


def summary_page(outcomes: Iterable[Outcome], methods: Sequence[str]) -> str:
    """Give the page: figures of each method over all pairs, failures by name, a line for each pair."""
    ordered = sorted(outcomes, key=lambda outcome: outcome.key)
    failed = [outcome for outcome in ordered if outcome.error]
    style = (resource_folder() / "gallery" / "style.css").read_text("utf-8")
    rows = [_method_row(method, ordered) for method in methods]
    pairs = [[outcome.key, *(_verdict(outcome, method) for method in methods)] for outcome in ordered]
    failures = [[outcome.key, outcome.error] for outcome in failed]
    return "\n".join(
        [
            '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>starskel batch</title>\n<style>\n{style}</style>\n</head>\n<body>\n<main>",
            f"<h1>{counted(len(ordered), 'pair')}, {counted(len(failed), 'failure')}</h1>",
            _table(("Method", "Pairs", "Simple", "Natural", "Crossing", "Median area drift"), rows),
            *(["<h2>Failures</h2>", _table(("Pair", "Why"), failures)] if failures else []),
            "<h2>Pairs</h2>",
            _table(("Pair", *methods), pairs),
            "</main>\n</body>\n</html>\n",
        ]
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


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = ['<div class="wide"><table>', "<thead><tr>"]
    lines += [f'<th scope="col">{escape(head)}</th>' for head in heads]
    lines.append("</tr></thead>\n<tbody>")
    for first, *others in rows:
        cells = "".join(f'<td class="words">{escape(cell)}</td>' for cell in others)
        lines.append(f'<tr><th scope="row">{escape(first)}</th>{cells}</tr>')
    return "\n".join([*lines, "</tbody></table></div>"])
