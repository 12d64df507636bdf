"""The documentation is true: its code runs, its files exist, its links lead somewhere."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from random import Random
from types import ModuleType
from typing import Any

import pytest

from rpg.blocks.state import BlockState, World
from rpg.cli.options import find
from rpg.language.frames.pieces import Unclear, coded, cut
from rpg.language.grammar.rows.turned import Turns, turned
from rpg.language.spelling import read_words
from rpg.language.tokens import tokenize
from rpg.passes.validate.bench import Bench
from rpg.pipeline import load_program
from tests.cli.conftest import SCHEMA
from tests.cli.conftest import compiled as compiled  # a fixture

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted((ROOT / "docs").glob("*.md"))
BLOCKS = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "extending.md").read_text(), re.DOTALL)


def run_block(containing: str) -> dict[str, Any]:
    (block,) = [block for block in BLOCKS if containing in block]
    module = sys.modules["docs_example"] = ModuleType("docs_example")
    exec(compile(block, "extending.md", "exec", dont_inherit=True), module.__dict__)
    return module.__dict__


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_files_and_links_lead_somewhere(page: Path) -> None:
    text = page.read_text()
    for path in re.findall(r"`((?:src|tests|docs|schemas|examples|library)/[\w./-]+)`", text):
        assert (ROOT / path).exists(), path
    for link in re.findall(r"\]\(([\w./-]+)\)", text):
        assert (page.parent / link).exists(), link


def test_the_example_gate(compiled: Path) -> None:
    gate = run_block("HeightGate")["HeightGate"]
    version = find("red-on-blue", compiled)
    program = load_program(version.directory, version.schema)
    report = gate().check(program, Bench(program))
    assert report.passed and report.figures["height_m"] == pytest.approx(0.08, abs=1e-3)
    strict = gate(highest_m=0.05).check(program, Bench(program))
    assert not strict.passed and strict.failures[0].facts["class"] == "bounds"


def test_the_example_way_of_speaking() -> None:
    space = run_block("totem")
    for text, plain in (
        ("From two red cubes and one blue cube make a totem pole, please.", "2 red blocks and 1 blue block"),
        ("Totem pole: red cubes, three in total", "3 red blocks"),
        ("Make a totem pole of red cubes.", None),
        ("No totem pole of two red cubes.", None),
    ):
        pieces = cut(coded(read_words(tokenize(text)[0])[0]), space["PATTERNS"])
        try:
            assert space["told"](pieces or []) == f"Build a tower from {plain}."
        except Unclear:
            assert plain is None


def test_the_example_turn_of_phrase() -> None:
    seated = Turns(run_block("SEATED")["SEATED"])
    for text, plain in (
        ("Put A on B. Let the red block ride on the blue cube.", "put A on B . put the red block on the blue cube ."),
        ("Let the red block ride with the blue cube.", "let the red block ride with the blue cube ."),
    ):
        tokens = turned(read_words(tokenize(text)[0])[0], seated)
        assert [token.word.lower() for token in tokens] == plain.lower().split()


def test_the_example_predicate() -> None:
    space = run_block("LevelPredicate")
    positions = {"red_block": (0.5, 0.0, 0.97), "blue_block": (0.5, 0.1, 0.97), "A_block": (0.5, 0.1, 1.01)}
    state = BlockState(World(SCHEMA.assets), positions, {})
    predicate = space["TABLE"]["level"]
    assert predicate.evaluate(space["Level"](a=("red_block", "blue_block")), state)
    assert not predicate.evaluate(space["Level"](a=("red_block", "A_block")), state)
    level = space["Level"](a=("red_block", "blue_block"))
    misses = list(predicate.near_misses(level, state, Random(0)))
    assert misses and not any(predicate.evaluate(level, miss.state) for miss in misses)


def test_the_example_command(compiled: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run_block("rpg colors")["run"]("red-on-blue", compiled)
    assert capsys.readouterr().out.strip() == "blue, green, ivory, red"
