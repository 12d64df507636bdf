"""The reference of the instruction language: its words, and what every condition means, from the code itself."""

from __future__ import annotations

import inspect
from pathlib import Path

import yaml

from rpg.ir import goal as g
from rpg.ir.node import Node
from rpg.ir.walk import ATOMS
from rpg.language import lexicon

EXAMPLES = Path(__file__).parent / "language_examples.yaml"
CONNECTIVES: tuple[type[Node], ...] = (g.All, g.Any, g.Not, g.Count, g.Sequence, g.Always)
TABLES = (
    ("Colours", lexicon.COLORS),
    ("Blocks and patches", {"block": lexicon.BLOCK_NOUNS, "patch": lexicon.PATCH_NOUNS, "table": lexicon.TABLE_NOUNS}),
    ("Symbols", {"letter": lexicon.LETTER_NOUNS, "digit": lexicon.DIGIT_NOUNS, "any symbol": lexicon.SYMBOL_NOUNS}),
    ("Structures", lexicon.STRUCTURES),
    ("Sizes", lexicon.SIZES),
    ("Verbs", lexicon.VERBS),
    ("Lengths, in metres", lexicon.UNITS),
)
INTRODUCTION = """# The language of instructions

Directions are the viewer's, who looks at the table from the robot's side: left and right as seen, in front is nearer,
behind is farther. A block's edge is 4 cm unless an instruction says otherwise. A word that means nothing here is
refused by name, not skipped. The examples are compiled by a test.
"""


def language_page() -> str:
    """The whole page."""
    examples = yaml.safe_load(EXAMPLES.read_text(encoding="utf-8"))
    parts = [INTRODUCTION, "## Words\n"]
    parts += [_table(title, words) for title, words in TABLES]
    parts.append("## Conditions\n")
    parts += [_condition(kind, examples) for kind in ATOMS]
    parts.append("## Connectives\n")
    parts += [_condition(kind, examples) for kind in CONNECTIVES]
    return "\n".join(parts)


def _table(title: str, words: dict[str, str]) -> str:
    rows = "\n".join(f"| {sense} | {', '.join(listed.split())} |" for sense, listed in words.items())
    return f"### {title}\n\n| sense | words |\n|---|---|\n{rows}\n"


def _condition(node: type[Node], examples: dict[str, list[str]]) -> str:
    kind = node.model_fields["kind"].default
    text = inspect.cleandoc(node.__doc__ or node.__mro__[1].__doc__ or "")
    said = "\n".join(f"- “{example}”" for example in examples[kind])
    return f"### {kind}\n\n{text}\n\n{said}\n{_tolerances(node)}"


def _tolerances(node: type[Node]) -> str:
    numbers = {n: f.default for n, f in node.model_fields.items() if isinstance(f.default, float)}
    if not numbers or node not in ATOMS:
        return ""
    listed = ", ".join(f"`{name}` {value:g}" for name, value in numbers.items())
    return f"\nDefaults: {listed}.\n"
