"""The command as a user has it: a process of its own, in an empty folder."""

import json
import os
import shutil
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

from starskel.files.pairs import write_pairs

SHAPES = Path(__file__).parents[1] / "shapes"
LETTERS = SHAPES / "letters.json"
COMMAND = [sys.executable, "-c", "import sys; from starskel.cli import main; sys.exit(main())"]


def starskel(folder, *words, **options):
    return subprocess.run(
        [*COMMAND, *map(str, words)], cwd=folder, capture_output=True, text=True, check=False, **options
    )


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_the_installed_command_answers_help(tmp_path):
    command = shutil.which("starskel", path=Path(sys.executable).parent)
    assert command, "the package is not installed"
    done = subprocess.run([command, "--help"], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.startswith("usage: starskel")
    assert "render" in done.stdout


@pytest.mark.parametrize("name", ["out.svg", "out.eps", "out.ps", "out.json", "OUT.SVG"])
def test_blend_writes_one_file_and_says_nothing(tmp_path, name):
    done = starskel(tmp_path, "render", LETTERS, "--id", "letter-T-Y", "--method", "vertex", "-o", name)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert names(tmp_path) == [name]


def test_compare_writes_a_sheet(tmp_path):
    done = starskel(tmp_path, "render", LETTERS, "--layout", "sheet", "--id", "letter-T-Y", "-o", "sheet.svg")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert names(tmp_path) == ["sheet.svg"]


def test_a_file_that_is_missing_is_named_in_one_line_with_status_2(tmp_path):
    done = starskel(tmp_path, "render", "gone.json", "-o", "out.svg")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (
        "starskel: gone.json cannot be read: No such file or directory; give the path of a readable file\n"
    )


def test_measure_goes_on_after_a_pair_that_fails(tmp_path, shape_pairs):
    write_pairs(tmp_path / "two.json", [shape_pairs["letter-T-Y"], shape_pairs["letter-E-F"]])
    document = json.loads((tmp_path / "two.json").read_text())
    document["pairs"][0]["p"][0] = document["pairs"][0]["p"][1]
    (tmp_path / "two.json").write_text(json.dumps(document))
    done = starskel(tmp_path, "measure", "two.json", "--method", "vertex")
    assert done.returncode == 2
    assert 'starskel: two.json: pair "letter-T-Y": source (p): vertices 0 and 1 are both at' in done.stderr
    assert "letter-E-F" in done.stdout


def test_an_output_that_nobody_reads_is_no_error(tmp_path):
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run(
        [*COMMAND, "measure", str(LETTERS), "--method", "vertex"],
        cwd=tmp_path,
        stdout=writing,
        stderr=subprocess.PIPE,
        check=False,
    )
    os.close(writing)
    assert (done.returncode, done.stderr) == (141, b"")


def test_standard_output_can_be_written_to(tmp_path):
    words = ["render", LETTERS, "--id", "letter-T-Y", "--method", "vertex", "-o"]
    plain = starskel(tmp_path, *words, "out.svg")
    assert plain.returncode == 0
    (tmp_path / "pipe.svg").symlink_to("/dev/stdout")
    piped = starskel(tmp_path, *words, "pipe.svg")
    assert piped.stdout == (tmp_path / "out.svg").read_text()
    assert (tmp_path / "pipe.svg").is_symlink()


def test_the_version_is_that_of_the_package(tmp_path):
    result = starskel(tmp_path, "--version")
    assert (result.returncode, result.stdout) == (0, f"starskel {version('starskel')}\n")
