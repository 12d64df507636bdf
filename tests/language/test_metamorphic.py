"""What a change of words does to a task: another name, another order, politeness nothing; another meaning always."""

from __future__ import annotations

import re
from functools import cache
from itertools import combinations
from random import Random

import pytest

from rpg.blocks.equivalence import equivalent
from rpg.ir.schema import TaskSchema
from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.corpus.entries import load

PLAIN = ["red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "gray", "white"]
TURNED = dict(zip(PLAIN, [*PLAIN[1:], PLAIN[0]], strict=True))
SAMPLE = 90
"""Texts of the corpus for each kind of change."""
POLITE = ("please {}", "hello, {}", "{}, please", "I would like you to do this: {}", "{}. Thanks a lot!")
OTHER = {
    "left": "right", "right": "left", "two": "three", "three": "four", "four": "five", "five": "six", "six": "eight",
    "behind": "in front of", "under": "on", "ascending": "descending", "descending": "ascending",
    "without": "before", "near": "far from", "exactly": "more than", "horizontal": "vertical", "clockwise": "twice",
    "smallest": "largest", "largest": "smallest", "not": "", "except": "and",
}  # fmt: skip
"""Words and what would mean something else in their place."""
PASSING = re.compile(
    r"step|stage|other two|twice|or more|\d\)|both ends|back (?:again|to)|the two|its two|symm|mirror"
    r"|\b(?:er|um|uh|sorry)\b|except that|(?:be|is) left (?:on|there)|second (?:one )?from the|across the top|actually"
    r"|\bI mean\b|or rather|four arms",
    re.I,
)
"""Texts in which some of these words are said in passing, or "left" is what remains, or arms may be counted with the
block in their middle."""
CLAUSES = (
    "put the red block on the blue block", "the pink block must be left of the white block",
    "put A on B", "build a tower of two green blocks", "put the letters C, D and E in a row in that order",
    "put the black block on the gray patch", "the cyan block must not touch the brown block",
    "exactly two of the three orange blocks go on the yellow patch", "build a 2x2 grid of purple blocks",
)  # fmt: skip


@cache
def read(text: str) -> TaskSchema | None:
    return BuiltinFrontEnd().read(text)[0]


def sample(seed: int) -> list[str]:
    """Texts of the corpus that are read."""
    texts = sorted({entry.text for entry in load("dev") if not entry.refuse and len(entry.text) < 120})
    return Random(seed).sample(texts, SAMPLE)


def told(schema: TaskSchema, colors: dict[str, str]) -> str:
    """The task with other names for its colours."""
    data = schema.model_dump(include={"assets", "goal", "init"}, mode="json")
    bare = re.sub(r"'span': (?:\[[^\]]*\]|None)", "", repr(data))
    return re.sub(rf"(?<![a-z])(?:{'|'.join(PLAIN)})(?![a-z])", lambda found: colors[found.group()], bare)


def _chosen(schema: TaskSchema) -> bool:
    """Whether some colours are not said."""
    return any("colour" in note for note in schema.assumptions)


@pytest.mark.parametrize("text", sample(1))
def test_other_colors_change_nothing_else(text: str) -> None:
    schema = read(text)
    if schema is None or re.search(r"rainbow|gradient|spectrum|colou?rs? ", text) or _chosen(schema):
        return
    if any(re.search(rf"\b{color.upper()}\b", text) for color in PLAIN):  # a word that is spelt
        return
    if not {a.color for a in schema.assets} - {"ivory"} <= set(re.findall(r"\w+", text.lower())):
        return
    other = read(
        re.sub(rf"\b(?:{'|'.join(PLAIN)})(?=s?\b)", lambda found: TURNED[found.group().lower()], text, flags=re.I)
    )
    assert other is not None
    assert told(other, {c: c for c in PLAIN}) == told(schema, TURNED)


@pytest.mark.parametrize("text", sample(2))
def test_politeness_changes_nothing(text: str) -> None:
    schema = read(text)
    polite = POLITE[len(text) % len(POLITE)].format(text.rstrip(".!?"))
    other = read(polite)
    if polite.startswith("please") and schema is not None and schema.init.arranged:
        return  # "Two blocks lie on the mat. Then ..." is how it starts; with "please" that is asked for, too
    assert schema is None or other is None or same(schema, other), polite


@pytest.mark.parametrize("text", sample(3))
def test_another_word_is_another_task(text: str) -> None:
    schema = read(text)
    if schema is None or PASSING.search(text) or _chosen(schema):
        return
    words = {m.span(): OTHER[m.group()] for m in re.finditer(r"\w+", text) if m.group() in OTHER}
    for color in {a.color for a in schema.assets}:
        found = [m.span() for m in re.finditer(rf"\b{color}\b", text)]
        free = next(c for c in PLAIN if c not in text.lower() and c not in {a.color for a in schema.assets})
        words |= {found[0]: free} if len(found) == 1 else {}
    for (begin, end), instead in words.items():
        changed = text[:begin] + instead + text[end:]
        other = read(changed)
        assert other is None or not same(schema, other), changed


@pytest.mark.parametrize(("one", "two"), [*combinations(CLAUSES, 2)])
def test_independent_clauses_come_in_any_order(one: str, two: str) -> None:
    first, second = read(f"{one}. {two}."), read(f"{two}. {one}.")
    assert first is not None and second is not None
    assert equivalent(first, second)
    for single in (one, two):
        alone = read(single)
        assert alone is not None and not same(first, alone)
