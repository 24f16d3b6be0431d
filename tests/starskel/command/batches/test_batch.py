"""Batches: every pair once, whatever happens in between."""

import json
import multiprocessing
import os
import random
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from distributed import Client, LocalCluster

import starskel
from starskel.cli import main
from starskel.command.batches import cluster, processes
from starskel.command.batches.jobs import jobs_of
from starskel.command.batches.journal import FORMAT, Journal, Terms
from starskel.command.batches.work import PackedJob
from starskel.errors import InvalidFile
from starskel.files.pairs import ShapePair, write_pairs
from starskel.files.raster_writing import write_image
from starskel.polygon import Polygon

WORDS = ["--methods", "vertex", "--frames", "11"]
ICONS = Path(__file__).parents[3] / "files" / "icons"


@pytest.fixture(autouse=True)
def empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def star(seed, count=9):
    radii = np.random.default_rng(seed).uniform(1, 4, count)
    angles = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return Polygon(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]))


def pairs(count):
    return [ShapePair(f"p{k}", star(k), star(k + 1000), ((0, 0),)) for k in range(count)]


def write(folder, count, name="pairs.json"):
    Path(folder).mkdir(exist_ok=True)
    write_pairs(Path(folder) / name, pairs(count))


def results(folder="out"):
    return [json.loads(line) for line in (Path(folder) / "results.jsonl").read_text().splitlines()]


def batch(*words):
    return main(["batch", *words, "-o", "out", *WORDS, "--processes", "2"])


def test_every_pair_of_a_folder_is_measured_as_the_library_does():
    write("in", 3)
    (Path("in") / "recipes.json").write_text('{"format": "recipes"}')
    assert batch("in") == 0
    lines = {line["key"]: line for line in results()}
    assert set(lines) == {f"pairs.json#p{k}" for k in range(3)}
    for k, pair in enumerate(pairs(3)):
        report = starskel.measure(starskel.blend(pair.source, pair.target, pair.marks, "vertex"), frames=11)
        (figures,) = lines[f"pairs.json#p{k}"]["figures"]
        assert figures["area_deviation"] == report.area_deviation
        assert figures["simple"] == report.simple
    assert "3 pairs, 0 failures" in Path("out/index.html").read_text()


def test_a_file_of_pairs_of_pictures_is_found_in_a_folder_like_any_other():
    Path("in").mkdir()
    write_image(Path("in") / "dot.png", np.full((9, 9, 4), 255, dtype=np.uint8))
    side = {"image": "dot.png", "outline": [[1, 1], [8, 1], [8, 8], [1, 8]]}
    document = {"format": "image-pairs/1", "pairs": [{"id": "dot", "p": side, "q": side}]}
    (Path("in") / "pictures.json").write_text(json.dumps(document))
    (job,) = jobs_of(Path("in"))
    assert job.key == "pictures.json#dot"
    assert len(job.load().source) == 4


def test_what_is_finished_is_not_done_again_and_a_broken_line_is(capsys):
    write("in", 4)
    batch("in")
    whole = Path("out/results.jsonl").read_bytes().splitlines(keepends=True)
    Path("out/results.jsonl").write_bytes(b"".join(whole[:2]) + whole[2][:40])
    capsys.readouterr()
    assert batch("in", "--json") == 0
    assert json.loads(capsys.readouterr().out)["done_now"] == 2
    after = Path("out/results.jsonl").read_bytes().splitlines(keepends=True)
    assert after[:2] == whole[:2]
    assert sorted(line["key"] for line in results()) == [f"pairs.json#p{k}" for k in range(4)]


def test_a_file_that_has_changed_is_measured_again():
    write("in", 2)
    batch("in")
    first = results()
    write("in", 3)
    batch("in")
    assert [line["digest"] for line in results()] != [line["digest"] for line in first]
    assert len(results()) == 3


def test_results_of_pairs_that_are_gone_stay_and_are_not_counted(capsys):
    write("in", 3)
    write("in", 2, "more.json")
    batch("in")
    document = json.loads(Path("in/more.json").read_text())
    document["pairs"][0]["p"][1] = document["pairs"][0]["p"][0]
    Path("in/more.json").write_text(json.dumps(document))
    assert batch("in") == 2
    Path("in/more.json").unlink()
    capsys.readouterr()
    assert batch("in", "--json") == 0
    counts = json.loads(capsys.readouterr().out)
    assert (counts["pairs"], counts["done_now"], counts["failed"], counts["gone"]) == (3, 0, 0, 2)
    assert len(results()) == 5
    page = Path("out/index.html").read_text()
    assert "3 pairs, 0 failures" in page
    assert "more.json" not in page
    assert batch("in") == 0
    assert "3 pairs, 0 failed; results of 2 more" in capsys.readouterr().out


def test_one_batch_at_a_time_writes_to_a_folder_and_a_damaged_line_keeps_no_lock(capsys):
    write("in", 1)
    batch("in")
    lines = Path("out/results.jsonl")
    whole = lines.read_bytes()
    lines.write_bytes(b"{}\n")
    terms = Terms(FORMAT, ["vertex"], 11)
    held = Journal(Path("out"), terms)
    with pytest.raises(InvalidFile, match="line 1 is damaged"):
        held.__enter__()
    lines.write_bytes(whole)
    with Journal(Path("out"), terms):
        assert batch("in") == 2
        assert "another batch is writing to out" in capsys.readouterr().err
    assert batch("in") == 0
    assert lines.read_bytes() == whole


def test_failures_are_named_the_others_go_on_and_failures_can_be_tried_again(capsys):
    write("in", 3)
    document = json.loads(Path("in/pairs.json").read_text())
    document["pairs"][1]["p"][1] = document["pairs"][1]["p"][0]
    Path("in/bad.json").write_text(json.dumps(document))
    assert batch("in") == 2
    assert 'bad.json#p1: in/bad.json: pair "p1"' in capsys.readouterr().err
    assert [line["key"] for line in results() if line["error"]] == ["bad.json#p1"]
    assert batch("in", "--json") == 2
    assert json.loads(capsys.readouterr().out)["done_now"] == 0
    assert batch("in", "--retry", "--json") == 2
    assert json.loads(capsys.readouterr().out)["done_now"] == 1
    assert len(results()) == 6


def test_a_file_of_pairs_is_a_batch_by_itself():
    write("in", 3)
    assert batch("in/pairs.json") == 0
    assert sorted(line["key"] for line in results()) == [f"pairs.json#p{k}" for k in range(3)]


def test_a_manifest_names_files_pairs_and_drawings():
    write("in", 3)
    club, gear = ICONS / "bootstrap-suit-club-fill.svg", ICONS / "bootstrap-gear-fill.svg"
    lines = [
        {"file": "in/pairs.json", "id": "p2"},
        {"source": str(club), "target": str(club)},
        {"source": str(gear), "target": str(gear)},
        {"file": "gone.json"},
    ]
    Path("list").write_text("\n".join(map(json.dumps, lines)))
    assert batch("list") == 2
    found = {line["key"]: line["error"] for line in results()}
    assert len(found) == 4
    assert [key for key, error in found.items() if error] == ["gone.json"]


@pytest.mark.parametrize("line", ["{", "{}", '{"file": "a", "source": "b", "target": "c"}', '{"name": "a"}'])
def test_a_wrong_line_of_a_manifest_is_named(line):
    Path("list").write_text(line)
    with pytest.raises(InvalidFile, match="list: line 1"):
        list(jobs_of(Path("list")))


def test_a_folder_of_results_belongs_to_one_batch(capsys):
    write("in", 1)
    batch("in")
    assert main(["batch", "in", "-o", "out", "--methods", "vertex", "--frames", "12"]) == 2
    assert "give the same methods and frames" in capsys.readouterr().err


def test_killed_and_resumed_every_pair_is_there_exactly_once():
    write("in", 40)
    command = [sys.executable, "-c", "import sys; from starskel.cli import main; sys.exit(main())"]
    words = ["batch", "in", "-o", "out", *WORDS, "--processes", "2"]
    seen = set()
    chance = random.Random(3)
    for _ in range(2):
        with subprocess.Popen([*command, *words], stdout=subprocess.DEVNULL) as running:
            want = len(seen) + chance.randint(1, 15)
            while running.poll() is None and len(finished()) < want:
                time.sleep(0.01)
            running.kill()
        now = finished()
        assert seen <= now
        seen = now
    assert subprocess.run([*command, *words], check=True, stdout=subprocess.DEVNULL).returncode == 0
    keys = [line["key"] for line in results()]
    assert sorted(keys) == sorted({f"pairs.json#p{k}" for k in range(40)})


def finished():
    path = Path("out/results.jsonl")
    lines = path.read_bytes().splitlines(keepends=True) if path.exists() else []
    return {json.loads(line)["key"] for line in lines if line.endswith(b"\n")}


def tasks(count):
    return [PackedJob(pair.id, "", pair, ("vertex",), 11) for pair in pairs(count)]


def test_a_process_that_dies_takes_no_pair_along():
    found = []
    for outcome in processes.outcomes(tasks(12), 2):
        if not found:
            multiprocessing.active_children()[0].kill()
        found.append(outcome)
    assert sorted(outcome.key for outcome in found) == sorted(task.key for task in tasks(12))
    assert {outcome.error for outcome in found} == {""}


@pytest.mark.filterwarnings("ignore")  # a cluster that is shut down warns of what it leaves
def test_a_cluster_that_loses_a_worker_does_every_pair_once():
    with LocalCluster(2, threads_per_worker=1, dashboard_address=None) as local, Client(local) as client:
        pids = list(client.run(os.getpid).values())
        found = []
        for outcome in cluster.outcomes(tasks(30), local.scheduler_address):
            if not found:
                os.kill(pids[0], 9)
            found.append(outcome)
    assert sorted(outcome.key for outcome in found) == sorted(task.key for task in tasks(30))
    assert {outcome.error for outcome in found} == {""}


def test_a_scheduler_that_does_not_answer_is_told(monkeypatch):
    monkeypatch.setattr(cluster, "_PATIENCE", "0.2s")
    with pytest.raises(InvalidFile, match="no scheduler answers at tcp:"):
        list(cluster.outcomes(tasks(1), "tcp://127.0.0.1:9"))


def test_a_folder_of_another_version_is_left_alone(capsys):
    write("in", 1)
    assert batch("in") == 0
    terms = json.loads(Path("out/batch.json").read_text())
    Path("out/batch.json").write_text(json.dumps({**terms, "format": "starskel-batch/2"}))
    before = {path: path.read_bytes() for path in Path("out").iterdir()}
    assert batch("in") == 2
    assert 'batch.json has the format "starskel-batch/2"; give another folder' in capsys.readouterr().err
    assert {path: path.read_bytes() for path in Path("out").iterdir()} == before


def test_links_that_lie_in_the_folder_lose_nothing():
    write("in", 1)
    Path("kept").write_text("not to be touched")
    Path("out").mkdir()
    Path("out/.lock").symlink_to("../kept")
    assert batch("in") == 0
    assert Path("kept").read_text() == "not to be touched"
