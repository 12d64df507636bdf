"""Whatever is typed, the front end answers: a task or a diagnostic, never a traceback, in bounded time."""

import random
import string
import time

import pytest

from rpg.core.codes import CODES
from rpg.language.spelling import vocabulary
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.corpus.entries import load

TEXTS = 300
SENTENCES = [entry.text for entry in load("heldout")]
SIGNS = ("(", ")", "not", "and", ":", "?", ".", ",", "=", "'", "2x2", "of", "A", "3")


def garbage(rng: random.Random) -> str:
    """Known words in any order, unknown ones, signs, letters; sentences cut off, and with signs in them."""
    words = sorted(vocabulary())
    kind = rng.randrange(5)
    if kind == 0:
        return "".join(rng.choice(string.printable) for _ in range(rng.randrange(1, 120)))
    length = rng.randrange(1, 25)
    if kind == 4:
        said = rng.choice(SENTENCES).split()
        said.insert(rng.randrange(len(said) + 1), rng.choice(SIGNS))
        return " ".join([*said[: rng.randrange(1, len(said) + 1)], rng.choice(SIGNS)])
    if kind == 1:
        return " ".join(rng.choice(words) for _ in range(length))
    common = [
        "put",
        "the",
        "red",
        "blue",
        "block",
        "blocks",
        "on",
        "and",
        "a",
        "of",
        "row",
        "tower",
        "two",
        ",",
        "it",
        "left",
        "to",
        "with",
        "A",
        "3",
    ]
    if kind == 2:
        return " ".join(rng.choice(common) for _ in range(length))
    return " ".join(rng.choice(common if rng.random() < 0.8 else words) for _ in range(length)) + rng.choice(".!?")


def test_no_text_breaks_the_front_end() -> None:
    rng = random.Random(7)
    for _ in range(TEXTS):
        text = garbage(rng)
        began = time.process_time()
        schema, diagnostics = BuiltinFrontEnd().read(text)
        assert time.process_time() - began < 5.0, text
        assert (schema is None) == any(d.severity == "error" for d in diagnostics), text
        assert all(d.code in CODES for d in diagnostics), (text, diagnostics)


@pytest.mark.parametrize(
    "text",
    [
        "Stack 1000000 blocks",
        "Put 99999 red blocks on the blue patch",
        "Build a 1000x1000 grid",
        "Build a 100x100x100 cube",
        "Build a pyramid with a base of 5000 blocks",
        "Build a staircase of 900 steps",
        "Build 5000 towers",
        "Make a circle of 100000 blocks",
        "Sort 500 letters into 100 piles",
    ],
)
def test_numbers_beyond_every_table_are_refused_at_once(text: str) -> None:
    began = time.process_time()
    _, diagnostics = BuiltinFrontEnd().read(text)
    assert time.process_time() - began < 5.0
    assert [d.code for d in diagnostics] == ["too-many-blocks"]


def test_the_longest_text_is_read_in_time() -> None:
    text = ("put the red block and the blue block and the green block on the yellow block and " * 12)[:990]
    began = time.process_time()
    BuiltinFrontEnd().read(text)
    assert time.process_time() - began < 20.0


def test_reading_is_deterministic() -> None:
    text = "build a tower of three blocks and put a red block next to it"
    assert BuiltinFrontEnd().read(text) == BuiltinFrontEnd().read(text)
