"""Phrases that rules look for: each table of them is kept in one place."""

from __future__ import annotations

from rpg.language import phrases
from tests.corpus.entries import load
from tests.corpus.run import read


def test_no_rule_puts_its_phrases_together_anew_for_every_sentence() -> None:
    """Their trees would be grown each time, and be kept."""
    entries = load("dev")[::80]
    for entry in entries:
        read(entry)
    grown = {*phrases.TREES}
    for entry in entries:
        read(entry)
    assert grown
    assert {*phrases.TREES} == grown
