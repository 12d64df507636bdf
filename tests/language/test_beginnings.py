"""Rules are run only before words that they ask for: they say so themselves, and it is true."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from rpg.core.diagnostics import Refusal
from rpg.language.grammar import core
from rpg.language.grammar.clauses.clauses import clause
from rpg.language.grammar.core import BEGINNINGS, Parser, choice
from rpg.language.read import read_sentences
from rpg.language.spelling import read_words
from rpg.language.tokens import tokenize
from tests.corpus.entries import load


def texts(every: int) -> list[str]:
    return [entry.text for entry in load("dev")][::every]


def read(text: str) -> object:
    try:
        return read_sentences(read_words(tokenize(text)[0])[0])
    except Refusal as refusal:
        return refusal.diagnostics


def parser(text: str) -> Parser:
    return Parser(read_words(tokenize(text)[0])[0])


def test_every_rule_tells_what_it_asks_for() -> None:
    """A rule that does not (it looks into a word, or at another place, before it has found its first word) is run at
    every place, and so is every rule that tries it: use `one`, `opt`, `any_of`, `standing`, `lex`, `peek`, `stands` and
    `follows` for the first word."""
    for text in texts(20):
        read(text)
    rules = [each for each in BEGINNINGS if each.body.__module__.startswith("rpg.language")]
    silent = [each.body.__qualname__ for each in rules for known in each.firsts.values() if known is None]
    assert not silent


def test_rules_that_are_spared_would_have_found_just_that(monkeypatch: pytest.MonkeyPatch) -> None:
    spared = [read(text) for text in texts(40)]
    monkeypatch.setattr(core, "head_of", lambda token: None)
    assert [read(text) for text in texts(40)] == spared


def test_a_rule_is_run_only_before_its_words() -> None:
    tried: list[str] = []

    def body(p: Parser, i: int) -> core.Results[str]:
        if not isinstance(p, core.Inquiry):
            tried.append(p.words[i])
        if (j := p.one(i, "red")) or (j := p.any_of(i, ("the blue", "green"))):
            yield "found", j

    rule = noted(body)
    p = parser("the red block and the green one")
    assert [i for i in range(p.end) if list(rule(p, i))] == [1, 5]
    assert tried == ["the", "red", "the", "green"]


def test_a_rule_that_looks_around_is_run_everywhere() -> None:
    def body(p: Parser, i: int) -> core.Results[str]:
        if p.words[i + 1] == "block":
            yield "found", i + 1

    rule = noted(body)
    p = parser("the red block")
    assert [i for i in range(p.end) if list(rule(p, i))] == [1]


def test_what_stands_before_is_asked_for_too() -> None:
    def body(p: Parser, i: int) -> core.Results[str]:
        if p.follows(i, ("red",)):
            yield "found", i

    rule = noted(body)
    p = parser("the red block")
    assert [i for i in range(p.end) if list(rule(p, i))] == [2]


def noted(body: Callable[[Parser, int], Any]) -> Callable[[Parser, int], Any]:
    """A rule that is not kept among those of the grammar."""
    rule = choice(body)
    BEGINNINGS.pop()
    return rule


def test_a_clause_begins_with_words_of_the_language() -> None:
    p = parser("and then")
    assert clause(p, p.end) == []
