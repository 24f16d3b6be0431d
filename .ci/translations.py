"""Bring the translations up to date with the texts in the code, and compile them.

    python .ci/translations.py [FOLDER]

FOLDER holds the .ts files, by default resources/translations. Texts that are new stand there unfinished
afterwards; those that are gone are dropped. Needs PySide6, whose lupdate and lrelease do the work.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import PySide6

ROOT = Path(__file__).parents[1]
EXAMPLES = ROOT / "resources" / "examples"
TOOLS = Path(PySide6.__file__).parent

LUPDATE = (
    "-silent",
    "-no-obsolete",
    *("-locations", "none"),  # line numbers would change the files with every edit of the code
    *("-tr-function-alias", "QT_TR_NOOP=told"),  # the library's own marking, in starskel/errors.py
)

PLURALS = "starskel_en.ts"
"""The code is English; all that is left to say is what to write for one thing and for several."""


def main(folder: Path) -> None:
    with tempfile.TemporaryDirectory() as place:
        examples = Path(place, "examples.py")
        examples.write_text(example_texts(), encoding="utf-8")
        code = [path for package in ("app", "starskel") for path in sorted((ROOT / package).rglob("*.py"))]
        for file in sorted(folder.glob("*.ts")):
            only = ("-pluralonly",) if file.name == PLURALS else ()
            subprocess.run([TOOLS / "lupdate", *LUPDATE, *only, *code, examples, "-ts", file], check=True)
            subprocess.run([TOOLS / "lrelease", "-silent", file], check=True)


def example_texts() -> str:
    """Give names and descriptions of the examples as code, for lupdate to read."""
    examples = [json.loads(path.read_text("utf-8")) for path in sorted(EXAMPLES.glob("*.json"))]
    texts = [example.get(part) for example in examples for part in ("name", "description")]
    return "\n".join(f'QT_TRANSLATE_NOOP("Example", {json.dumps(text)})' for text in texts if text)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "resources" / "translations")
