"""The gallery: a page of many pairs, each with its sheet and figures."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from statistics import median

from starskel.files.page import page, table
from starskel.quality import Report, ShapeReport
from starskel.sheet.drawing import Drawing
from starskel.sheet.words import (
    counted,
    crossing_counts,
    finer_words,
    kind_of,
    overlap_words,
    percent,
    verdict,
)

SIGNS = {"simple": "✓", "natural": "≈", "harmful": "✕"}
"""What is said by colours is said by signs, too."""

_ORDERS = (
    ("given", "as given"),
    ("name", "by name"),
    ("crossings", "most crossing frames first"),
    ("area", "largest area drift first"),
)

_SCALE = 1.4
"""Pixels of the page for a point of a sheet: all sheets in one size of letters."""

_FIGURES = {
    "Area drift": "the largest deviation of the area from the linear blend of both areas",
    "Length drift": "the mean deviation of edge lengths from their linear blend",
    "Angle drift": "the mean deviation of turning angles from their linear blend",
    "Stretched": "the mean conformal distortion of the star pieces' fans beyond what the pair demands",
    "Spread": "the mean deviation of the areas of the fans' triangles from their linear blend",
    "Folded": "the largest part of the fans, in any frame, that is turned over",
    "Roughness": "how far a vertex strays at most from even motion within a fiftieth of the time,"
    " as a part of the size",
}
"""What is told of each method, and what it means."""


@dataclass(frozen=True, eq=False)
class Exhibit:
    """A pair on the page.

    Attributes
    ----------
    name : str
        The name of its sheet without the ending, and of its place on the page.
    title, text : str
        What is shown above the sheet.
    sheet : Drawing
    reports : dict
        What was measured, by method.
    """

    name: str
    title: str
    text: str
    sheet: Drawing
    reports: dict[str, Report | ShapeReport]


def gallery_page(exhibits: Sequence[Exhibit], failures: Sequence[str]) -> str:
    """Give the page as HTML; the sheets are expected beside it."""
    methods = list(exhibits[0].reports) if exhibits else []
    parts = [_header(exhibits, methods), _list(exhibits), "<main>", *map(_section, exhibits), "</main>"]
    return page("Blends side by side", [*parts, _failures(failures)])


def _header(exhibits: Sequence[Exhibit], methods: Sequence[str]) -> str:
    words = {
        "simple": "no frame crosses itself",
        "natural": "the shape crosses itself, but only lies over itself in layers",
        "harmful": "it is twisted or turned inside out",
    }
    legend = "; ".join(f"{_sign(kind)}{kind}: {text}" for kind, text in words.items())
    meanings = "\n".join(f"<dt>{name}</dt><dd>{meaning}.</dd>" for name, meaning in _FIGURES.items())
    rows = [_summary_row(method, [exhibit.reports[method] for exhibit in exhibits]) for method in methods]
    return f"""<header>
<h1>Blends side by side</h1>
<p>{counted(len(exhibits), "pair")}, each blended by {counted(len(methods), "method")} from t = 0 to t = 1.
Crossing frames are outlined in red.</p>
<p>{legend}. Proven: simple for every t, not only in the frames looked at.</p>
{table(("Method", "Simple", "Proven", "Natural", "Harmful", "Median area drift"), rows, ())}
<details><summary>What the figures mean</summary>
<dl>
{meanings}
</dl>
</details>
</header>"""


def _summary_row(method: str, reports: Sequence[Report | ShapeReport]) -> list[str]:
    kinds = [kind_of(report) for report in reports]
    proven = sum(report.simple and report.proven for report in reports)
    drift = percent(median(report.area_deviation for report in reports))
    return [method, *(str(n) for n in (kinds.count("simple"), proven, kinds.count("natural"))),
            str(kinds.count("harmful")), drift]  # fmt: skip


def _list(exhibits: Sequence[Exhibit]) -> str:
    """Give the list of pairs. The style sheet sorts it by the ranks that each pair carries."""
    ranks = {
        "name": _ranks([_alphabetical(exhibit.title) for exhibit in exhibits]),
        "crossings": _ranks([-sum(len(r.crossing_frames) for r in e.reports.values()) for e in exhibits]),
        "area": _ranks([-max(r.area_deviation for r in e.reports.values()) for e in exhibits]),
    }
    lines = ['<nav aria-label="Pairs">']
    for number, (order, words) in enumerate(_ORDERS):
        checked = " checked" if number == 0 else ""
        lines.append(f'<label><input type="radio" name="order" id="by-{order}"{checked}> {words}</label>')
    lines.append("<ol>")
    for number, exhibit in enumerate(exhibits):
        style = "; ".join(f"--{order}: {places[number]}" for order, places in ranks.items())
        lines.append(f'<li style="{style}"><a href="#{exhibit.name}">{escape(exhibit.title)}</a><br>')
        lines += [_chip(method, report) for method, report in exhibit.reports.items()]
        lines.append("</li>")
    return "\n".join([*lines, "</ol>\n</nav>"])


def _ranks(keys: Sequence[str] | Sequence[float]) -> list[int]:
    order = sorted(range(len(keys)), key=lambda k: (keys[k], k))
    return [order.index(k) for k in range(len(keys))]


def _alphabetical(title: str) -> str:
    """Give what titles are ordered by: without regard to capitals, numbers by their value."""
    return re.sub(r"\d+", lambda number: number[0].zfill(9), title.casefold())


def _chip(method: str, report: Report | ShapeReport) -> str:
    kind = kind_of(report)
    return f'<span class="{kind}" title="{escape(verdict(report))}">{SIGNS[kind]} {method}</span>'


def _section(exhibit: Exhibit) -> str:
    words = "; ".join(f"{method}: {verdict(report)}" for method, report in exhibit.reports.items())
    rows = [_figures(method, report) for method, report in exhibit.reports.items()]
    width, height = _SCALE * exhibit.sheet.width, _SCALE * exhibit.sheet.height
    return f"""<section id="{exhibit.name}">
<h2><a href="#{exhibit.name}">{escape(exhibit.title)}</a></h2>
<p>{escape(exhibit.text)}</p>
<div class="sheet"><img src="{exhibit.name}.svg" width="{width:.0f}" height="{height:.0f}"
 loading="lazy" alt="{escape(f"{exhibit.title}, frames by each method. {words}")}"></div>
<details><summary>All figures</summary>
{table(("Method", *_FIGURES, "Verdict"), rows, ("Verdict",))}
</details>
</section>"""


def _figures(method: str, report: Report | ShapeReport) -> list[str]:
    kind = kind_of(report)
    words = ", ".join((crossing_counts(report), *overlap_words(report)))
    return [
        method,
        percent(report.area_deviation),
        percent(report.length_deviation),
        *finer_words(report),
        f'<span class="{kind}">{_sign(kind)}{words}</span>',
    ]


def _failures(failures: Sequence[str]) -> str:
    if not failures:
        return ""
    items = "\n".join(f"<li>{escape(failure)}</li>" for failure in failures)
    return f"<footer>\n<p>Not shown:</p>\n<ul>\n{items}\n</ul>\n</footer>"


def _sign(kind: str) -> str:
    return f'<span class="sign {kind}" aria-hidden="true">{SIGNS[kind]}</span>'
