"""What a sentence is read as: its blocks, states that must hold, and near misses that must not; what is told of its
task in English, or with which code it is refused."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.corpus.entries import entry
from tests.corpus.judge import judge
from tests.corpus.run import read


def assert_means(text: str, meant: Mapping[str, Any]) -> None:
    """Fail, with the reason, where a sentence is refused or misread. `meant`: as in an entry of the corpus."""
    score = judge(entry("meant", "told", text, dict(meant)), read)
    assert score.outcome == "right", score.why


def means(text: str) -> str:
    """What a text means: its task, told in English."""
    task, notes = BuiltinFrontEnd().read(text)
    assert task is not None, notes
    return describe(task)


def start_and_end(text: str) -> tuple[str, str]:
    """What is told of the start, and what of the end."""
    sentences = means(text).replace("\n", " ").split(". ")
    start = ". ".join(x for x in sentences if x.startswith("At the start"))
    return start, ". ".join(x for x in sentences if " must " in x)


def code_of(text: str) -> str:
    """The code of the diagnostic with which a text is refused."""
    task, notes = BuiltinFrontEnd().read(text)
    assert task is None, describe(task)
    return notes[0].code
