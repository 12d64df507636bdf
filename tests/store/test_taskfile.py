"""task.yaml reads back as what was written, reads well, and says where it is wrong."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from rpg.core.diagnostics import UsageError
from rpg.ir.assets import ColoredCube, GoalPatch, SemanticCube
from rpg.ir.goal import All, Count, On, OnPatch, Sequence, Spells, Stack, Stage
from rpg.ir.node import Lowest
from rpg.ir.order import Order
from rpg.ir.schema import InitialState, Start, TaskSchema
from rpg.store import dump_schema, parse_schema, read_schema
from rpg.store.yamltext import dump

RICH = TaskSchema(
    name="a-bit-of-all",
    instruction='Put "A" on: the blue, then — spell NO # quickly',
    author="on",
    assets=(
        ColoredCube(name="red_block", color="red"),
        ColoredCube(name="blue_block", color="blue", size=0.05),
        SemanticCube(name="N_block", label="N"),
        SemanticCube(name="5_block", label="5"),
        GoalPatch(name="patch", color="green", size=(0.2, 1e-5), position=(0.5, -0.1)),
    ),
    init=InitialState(
        arranged=(On(a="blue_block", b="red_block"),),
        heaps=(("N_block", "5_block"),),
        poses=(Start(block="N_block", position=(0.5, 0.0), yaw=0.1),),
    ),
    goal=All(
        goals=(
            On(a="red_block", b=Lowest(lowest=("blue_block", "N_block")), span=(4, 9), gap=2e-7),
            Spells(blocks=("N_block",), word="N", readable=False),
            Stack(blocks=("red_block", "blue_block"), order=Order(by="given", ranks=(("red_block",), ("blue_block",)))),
            Count(over=("red_block", "blue_block"), at_least=1, goal=OnPatch(a="each", patch="patch")),
            Sequence(stages=(Stage(goal=On(a="red_block", b="blue_block"), undone=True),)),
        )
    ),
    assumptions=("a patch is green unless said",),
)


def test_a_task_survives_its_file(tmp_path: Path) -> None:
    text = dump_schema(RICH)
    (tmp_path / "task.yaml").write_text(text)
    assert read_schema(tmp_path / "task.yaml") == RICH
    assert dump_schema(read_schema(tmp_path / "task.yaml")) == text


def test_any_yaml_reader_gives_the_same() -> None:
    assert TaskSchema.model_validate(yaml.safe_load(dump_schema(RICH))) == RICH


def test_it_reads_well() -> None:
    text = dump_schema(RICH)
    lines = text.splitlines()
    assert lines[0] == "format: 1"
    assert '    - kind: "on"' in lines
    assert "      tilt: 15.0" in lines
    assert "      span: [4, 9]" in lines
    for noise in ("null", ": []", ": {}", ": false\n    -", ': ""', "&id", "!!", "exact:", "paraphrases:"):
        assert noise not in text
    assert max(map(len, lines)) <= 120


SCALARS = st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | st.text()
DATA = st.recursive(
    SCALARS,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(min_size=1), inner, max_size=4),
    max_leaves=12,
)


@settings(max_examples=300, deadline=None)
@given(st.dictionaries(st.text(min_size=1, max_size=12), DATA, max_size=4))
def test_whatever_is_written_is_read_back(data: dict[str, object]) -> None:
    assert yaml.safe_load(dump(data)) == data


@pytest.mark.parametrize(
    "word",
    ["on", "y", "No", "5", "1e5", "0x1", "12:30", "1_000", "~", "null", "-", "- a", "a: b", "a #b", "'", '"', "\\",
     " a", "a ", "", "\n", "\t", "é", "😀", "\x85", "\u2028", "%", "@", "=", "<<", "*a", "&a", "!a", "|", ">", "?", "[",
     "{", "2026-01-01", "..", "---"],
)  # fmt: skip
def test_words_that_yaml_takes_for_something_else(word: str) -> None:
    assert yaml.safe_load(dump({word: [word, {word: word}]})) == {word: [word, {word: word}]}


GOOD = """\
format: 1
name: red-on-blue
instruction: Red on blue
assets:
  - type: ColoredCube
    name: red_block
    color: red
  - type: ColoredCube
    name: blue_block
    color: blue
goal:
  kind: on
  a: red_block
  b: blue_block
"""


def test_hand_written_words_are_words() -> None:
    schema = parse_schema(GOOD)
    assert isinstance(schema.goal, On)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("color: red", "colr: red", "7: `assets[0].colr` is not known here; did you mean `color`?"),
        ("color: red", "color: rde", "7: `assets[0].color` cannot be 'rde'; did you mean `red`?"),
        ("    color: red\n", "", "5: `assets[0].color` is missing"),
        ("kind: on", "kind: onn", "12: `goal.kind` cannot be 'onn'; did you mean `on`?"),
        ("  kind: on\n", "", "11: `goal` needs a `kind`"),
        ("name: red_block", "name: 5", '6: `assets[0].name` should be text, not 5; write "5" in quotes'),
        ("color: red", "color: red\n    size: big", "8: `assets[0].size` should be a number, not 'big'"),
        ("color: red", "color: red\n    size: 5", "8: `assets[0].size` should be at most 0.12, not 5"),
        ("b: blue_block", "b: blue_block\n  gap: 5.0", "15: `goal.gap` should be at most 1.0, not 5.0"),
        ("b: blue_block", "b: blue_block\n  slack: -0.1", "15: `goal.slack` should be at least 0.0, not -0.1"),
        ("b: blue_block", "b: blue_block\n  tilt: 400", "15: `goal.tilt` should be at most 90.0, not 400"),
        (
            "b: blue_block",
            "b: blue_block\n  offset_edges: 99",
            "15: `goal.offset_edges` should be at most 10.0",
        ),
        ("format: 1", "format: 1\nseed: -1", "2: `seed` should be at least 0, not -1"),
        ("a: red_block", "a: {foot: red_block}", "13: `goal.a` should be a name, a list of names"),
        ("b: blue_block", "b: green_block", "the task mentions 'green_block', but its assets are red_block"),
        ("name: red-on-blue", "name: Red!", "2: `name` should be lower-case words and numbers joined by hyphens"),
        ("format: 1", "format: 2", "1: `format` cannot be 2"),
        ("format: 1", "format: 1\nformat: 1", "2: `format` stands here twice"),
        ("color: red", "color: &c red", None),
        ("color: blue", "color: [red", "11: did not find"),
        ("goal:", "goal: x", "12: mapping values are not allowed"),
        ("a: red_block", "a: !!python/name:os.system x", "13: "),
        (GOOD, "", "1: a task is a mapping"),
        (GOOD, "- 1\n", "1: a task is a mapping"),
        (GOOD, "\0", "not YAML"),
        (GOOD, "[" * 5000 + "]" * 5000, "nested too deeply"),
        (GOOD, "a: &a [x]\nb: *a\n", "no anchors"),
    ],
)
def test_what_is_wrong_is_said_with_its_line(old: str, new: str, said: str | None) -> None:
    text = GOOD.replace(old, new, 1)
    if said is None:
        assert parse_schema(text) == parse_schema(GOOD)
        return
    with pytest.raises(UsageError) as error:
        parse_schema(text, "task.yaml")
    assert said in str(error.value)
    assert str(error.value).startswith("task.yaml")


def test_many_problems_are_said_at_once() -> None:
    with pytest.raises(UsageError) as error:
        parse_schema(GOOD.replace("color: red", "color: rde").replace("kind: on", "kind: onn"))
    assert len(str(error.value).splitlines()) == 2


def test_files_that_are_no_text(tmp_path: Path) -> None:
    path = tmp_path / "task.yaml"
    for data, said in ((b"\xff\xfe", "not UTF-8"), (b"#" * 1_000_001, "too long")):
        path.write_bytes(data)
        with pytest.raises(UsageError, match=said):
            read_schema(path)
    with pytest.raises(UsageError, match="cannot read"):
        read_schema(tmp_path / "missing.yaml")
    with pytest.raises(UsageError, match="cannot read"):
        read_schema(tmp_path)


def test_a_byte_order_mark_and_windows_lines_are_read() -> None:
    assert parse_schema(textwrap.dedent(GOOD).replace("\n", "\r\n")) == parse_schema(GOOD)
