"""Whatever is typed gets a task or a reason, soon: no traceback, no hang, no silence.

`python -m tests.cli.test_garbage 10000` tries that many instructions.
"""

from __future__ import annotations

import random
import re
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import rpg.language.lexicon as lexicon
from rpg.cli.report import diagnostic_lines
from rpg.passes.schema.frontend import BuiltinFrontEnd

ROOT = Path(__file__).resolve().parents[2]
WORDS = sorted(set(re.findall(r"[a-z]+", Path(lexicon.__file__).read_text())))
LINES = [
    line for line in (ROOT / "examples" / "instructions.txt").read_text().splitlines() if line[:1] not in ("", "#")
]
JOINTS = (" and ", ". ", ", then ", " or ", ", but not ")
SECONDS = 10.0


def garbage(rng: random.Random) -> str:
    """Words without sense, sentences with words lost and added, characters of any kind, sentences run together."""
    kind = rng.random()
    if kind < 0.4:
        return " ".join(rng.choice(WORDS) for _ in range(rng.randint(1, 15)))
    if kind < 0.7:
        words = rng.choice(LINES).split()
        for _ in range(rng.randint(1, 5)):
            at = rng.randrange(len(words) + 1)
            words[at : at + rng.randint(0, 2)] = [rng.choice(WORDS)] if rng.random() < 0.6 else []
        return " ".join(words)
    if kind < 0.85:
        ranges = ((32, 127), (1, 0x3000), (0x1F300, 0x1F600))
        return "".join(chr(rng.randrange(*rng.choice(ranges))) for _ in range(rng.randint(0, 80)))
    return rng.choice(LINES) + rng.choice(JOINTS) + rng.choice(LINES).lower()


def outcomes(count: int, seed: int) -> Iterator[bool]:
    """Whether each of `count` instructions became a task; fails where one got neither a task nor a reason."""
    rng, front_end = random.Random(seed), BuiltinFrontEnd()
    for _ in range(count):
        text = garbage(rng)
        begun = time.perf_counter()
        schema, diagnostics = front_end.read(text, name=None, seed=0, author=None)
        assert time.perf_counter() - begun < SECONDS, text
        assert schema is not None or any(diagnostic.severity == "error" for diagnostic in diagnostics), text
        for diagnostic in diagnostics:
            assert list(diagnostic_lines(diagnostic, text)), text
        yield schema is not None


def test_garbage_gets_a_reason() -> None:
    found = list(outcomes(400, seed=11))
    assert 0 < sum(found) < len(found) / 2


def test_long_instructions_get_a_reason_soon() -> None:
    front_end = BuiltinFrontEnd()
    for text in (
        "put " * 2500,
        "a" * 10_000,
        "Put the red block on the blue block. " * 270,
        "(" * 10_000,
        "7" * 10_000,
    ):
        begun = time.perf_counter()
        schema, diagnostics = front_end.read(text, name=None, seed=0, author=None)
        assert schema is not None or diagnostics
        assert time.perf_counter() - begun < SECONDS


if __name__ == "__main__":
    results = list(outcomes(int(sys.argv[1]), seed=1))
    print(f"{len(results)} instructions: {sum(results)} tasks, {len(results) - sum(results)} refusals")
