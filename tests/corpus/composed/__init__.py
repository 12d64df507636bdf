"""Sentences composed of a frame and of phrasings for its gaps, each with what it means: a module for each family.

A family's `composed` draws one from a random generator; `python -m tests.corpus.composed.run FAMILY` reads many.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Composed:
    """A sentence, the frame that it came from, and what it means: the keys of an entry of the corpus, without `say`."""

    frame: str
    text: str
    meaning: dict[str, Any]
