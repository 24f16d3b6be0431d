"""The share of whole icon sets that opens: python -m tests.benchmarks.icon_sets [--every N]. Needs npm."""

import argparse
import subprocess
import tempfile
from collections import Counter
from pathlib import Path
from time import process_time

from starskel.errors import InvalidFile
from starskel.reading.readers import read_shapes

SETS = {
    "lucide-static": "icons",
    "bootstrap-icons": "icons",
    "@tabler/icons": "icons",
}


def share(package: str, files: list[Path]) -> None:
    failures, repairs, start = [], Counter[str](), process_time()
    for path in files:
        try:
            repairs.update(repair for found in read_shapes(path).shapes for repair in found.repairs)
        except InvalidFile as error:
            failures.append(str(error))
    each = 1000 * (process_time() - start) / len(files)
    opened = len(files) - len(failures)
    print(f"{package}: {opened} of {len(files)} open, {each:.0f} ms of processor time each")
    for words, count in [*repairs.most_common(), *((failure, 1) for failure in failures)]:
        print(f"  {count:5} {words}")


def main(every: int) -> None:
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["npm", "install", "--silent", "--prefix", folder, *SETS], check=True)
        for package, inside in SETS.items():
            files = sorted((Path(folder) / "node_modules" / package / inside).rglob("*.svg"))
            share(package, files[::every])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Say how many icons of public sets open.")
    parser.add_argument("--every", type=int, default=1, help="look at one in so many")
    main(parser.parse_args().every)
