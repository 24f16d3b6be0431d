"""Pages of figures, as HTML in one style: no scripts, nothing from elsewhere."""

from collections.abc import Collection, Iterable, Sequence
from html import escape

from starskel.files.projects.examples import resource_folder


def page(title: str, parts: Iterable[str]) -> str:
    """Give a page of a title and the parts of its body; empty ones are left out."""
    style = (resource_folder() / "gallery" / "style.css").read_text(encoding="utf-8")
    head = [
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{escape(title)}</title>\n<style>\n{style}</style>\n</head>\n<body>",
    ]
    return "\n".join([*head, *filter(None, parts), "</body>\n</html>\n"])


def table(heads: Sequence[str], rows: Iterable[Sequence[str]], wordy: Collection[str]) -> str:
    """Give a table of cells in HTML, whose first column names the rows; wordy columns are set like words."""
    kinds = [' class="words"' if head in wordy else "" for head in heads]
    lines = ['<div class="wide"><table>', "<thead><tr>"]
    lines += [f'<th scope="col"{kind}>{head}</th>' for head, kind in zip(heads, kinds, strict=True)]
    lines.append("</tr></thead>\n<tbody>")
    for first, *others in rows:
        cells = "".join(f"<td{kind}>{cell}</td>" for cell, kind in zip(others, kinds[1:], strict=True))
        lines.append(f'<tr><th scope="row">{first}</th>{cells}</tr>')
    return "\n".join([*lines, "</tbody></table></div>"])
