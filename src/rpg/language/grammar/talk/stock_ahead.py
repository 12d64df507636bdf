""" "Five black cubes: two on the red mat, the others on the blue one": what there is, beside what is asked for."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.tokens import Token

_JOINTS = frozenset({"and", ",", "a", "an", "plus"})
_STOPS = frozenset({".", ";", "distractor", "distractors"})
_NOUNS = (lexicon.COLOR, lexicon.COLOR_PLURAL, lexicon.BLOCK, lexicon.PATCH)


def stock_ahead(tokens: list[Token]) -> list[Token] | None:
    """The words with that in a sentence of its own: "there are five black cubes. Two on the red mat ..."."""
    colons = [n for n, token in enumerate(tokens) if token.word == ":" and token.kind == "punct"]
    if len(colons) != 1:
        return None
    before, after = tokens[: colons[0]], tokens[colons[0] + 1 :]
    while after and after[-1].word in (".", "!"):
        after = after[:-1]
    if _listed(before) and after:
        return _told(before, after)
    ordered = bool(before) and before[0].word in lexicon.VERB and not any(t.word in _STOPS for t in before)
    return _told(after, before) if _listed(after) and ordered else None


def _listed(tokens: list[Token]) -> bool:
    """Whether blocks and patches are counted, and no more is said."""
    counts = [token for token in tokens if _counts(token)]
    known = all(_counts(t) or t.word in _JOINTS or any(t.word in table for table in _NOUNS) for t in tokens)
    first = bool(tokens) and (_counts(tokens[0]) or tokens[0].word in ("a", "an"))
    return known and first and bool(counts) and len(tokens) > 2 and any(t.word in lexicon.BLOCK for t in tokens)


def _counts(token: Token) -> bool:
    return token.kind == "number" or token.word in lexicon.NUMBER


def _told(listed: list[Token], rest: list[Token]) -> list[Token]:
    there, are = (replace(listed[0], kind="word", word=word, raw=word, value=None) for word in ("there", "are"))
    stop = replace(listed[-1], kind="punct", word=".", raw=".", value=None)
    return [there, are, *listed, stop, *rest]
