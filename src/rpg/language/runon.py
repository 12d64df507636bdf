"""Sentences that run on: "the red block goes on the blue one the green one goes on the red one"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.meaning import At, Chain, Clause, In, Loc
from rpg.language.tokens import Token

_NAMES = (lexicon.COLOR, lexicon.COLOR_PLURAL)
_NOUNS = (lexicon.BLOCK, lexicon.PATCH)
_ENDS = frozenset({"one", "ones", "it", "them", "that", "table"})
_STEPS = frozenset({"step", "second", "third", "secondly", "thirdly", "fourth", "next", "finally", "lastly"})


def runs_on(tokens: list[Token], n: int) -> bool:
    """Could one sentence end before this word, with a block or a patch, and the next one begin with it?"""
    last, first = tokens[n - 1], tokens[n]
    ended = last.word in _ENDS or _symbol(last) or any(last.word in table for table in (*_NAMES, *_NOUNS))
    named = first.raw in ("the", "a", "an") or _symbol(first) or any(first.word in table for table in _NAMES)
    beside = first.word == "next" and n + 1 < len(tokens) and tokens[n + 1].word == "to"
    return ended and (named or (first.word in _STEPS and not beside))


def _symbol(token: Token) -> bool:
    return token.kind == "word" and len(token.raw) == 1 and token.raw.isupper()


def places(chain: Chain) -> bool:
    """Whether every clause says where something is: a sentence that runs on may have been parted nowhere else."""
    return all(
        isinstance(clause, Clause)
        and clause.theme is not None
        and (clause.mode == "command" or any(isinstance(a, Loc | In | At) for a in clause.adjuncts))
        for clause in chain.clauses
    )
