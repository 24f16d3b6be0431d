"""Fuzz one reader by following coverage: atheris keeps the inputs that reach new places of the code.

python -m tests.fuzzing.following READER EXAMPLES SEED

It begins with the same valid files as guessing and with what earlier runs found, in build/fuzzing/READER,
and changes them in the same ways besides its own.
"""

import random
import sys

import atheris

_WATCHED = ["starskel", "app", "svgelements", "defusedxml", "PIL"]

with atheris.instrument_imports(include=_WATCHED):
    from tests.fuzzing.bounds import BYTES, LAST, SECONDS, Bounded
    from tests.fuzzing.mutations import WORDS, broken_once
    from tests.fuzzing.readers import READERS

_LARGEST = 200_000
"""Bytes of an input at most."""


def follow(name: str, examples: int, first: int) -> None:
    """Give a reader so many inputs, and tell what came of them; it ends the process."""
    with atheris.instrument_imports(include=_WATCHED):  # what is loaded only when it is needed
        for content in READERS[name].seeds():
            READERS[name].read(content)
    bounded = Bounded(READERS[name])

    def run(content: bytes) -> None:
        try:
            bounded.read(content)
        except BaseException:
            print(f"kept as {bounded.keep()}", file=sys.stderr, flush=True)
            raise
        if bounded.count == examples:
            print(bounded, flush=True)

    corpus, words = LAST / name, LAST / f"{name}.words"
    corpus.mkdir(exist_ok=True)
    for number, content in enumerate(READERS[name].seeds()):
        (corpus / f"seed-{number}").write_bytes(content)
    words.write_text("".join(f'"{_escaped(word)}"\n' for word in WORDS))
    options = {
        "runs": examples,
        "seed": first + 1,  # 0 would leave the choice to chance
        "max_len": _LARGEST,
        "len_control": 0,
        "dict": words,
        "timeout": round(10 * SECONDS),
        "rss_limit_mb": 2 * BYTES >> 20,
        "artifact_prefix": f"{LAST}/",
    }
    given = [f"-{option}={value}" for option, value in options.items()]
    atheris.Setup([sys.argv[0], *given, str(corpus)], run, custom_mutator=_changed)
    atheris.Fuzz()


def _changed(content: bytes, most: int, chance: int) -> bytes:
    """Change an input as guessing does, or as libFuzzer does, by turns."""
    numbers = random.Random(chance)
    if numbers.random() < 1 / 2:
        return atheris.Mutate(content, most)
    return broken_once(content, numbers)[:most]


def _escaped(word: bytes) -> str:
    return "".join(f"\\x{byte:02x}" for byte in word)


follow(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
