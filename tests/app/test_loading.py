import os
import subprocess
import sys


def test_the_window_opens_without_what_only_the_worker_and_exports_need() -> None:
    code = "import sys, app.view.start; print(*sys.modules)"
    loaded = subprocess.run(
        [sys.executable, "-c", code],
        check=True,
        capture_output=True,
        text=True,
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
    ).stdout.split()
    late = {"scipy", "starskel.blending.methods", "starskel.quality", "starskel.export.film", "PIL"}
    assert not late.intersection(loaded)
