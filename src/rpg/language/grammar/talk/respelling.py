"""One word made of another: "the blocks currently say TAC, make them say CAT", "turn TAC into CAT"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

_TURN = frozenset({"turn", "change", "transform", "convert", "rearrange", "reorder", "unscramble", "correct", "fix"})
_SHOWN = frozenset({"spell", "spells", "say", "says", "read", "reads", "show", "shows", "is", "are"})
_WHAT = frozenset({"the", "blocks", "cubes", "letters", "word", "row", "it", "they", "this", "them", "spelling"})
_NOW = frozenset({"now", "currently", "presently", "at", "moment", "right", "present"})
_MARKS = frozenset({",", ".", ";", ":"})
_SPELT = frozenset({"please", "wrong", "mistake", "typo", "spelled", "spelt", "misspelled", "swap", "so", "that"})
_BEFORE = _TURN | _SHOWN | _WHAT | _NOW | _MARKS | _SPELT
_TO_BE = frozenset({"make", "becomes", "should", "must", "into", "to", "become", "needs", "need", "so", "let", *_TURN})
_BETWEEN = _BEFORE | _TO_BE | {"but", "and", "be", "that", "has", "have", "instead", "really", "actually"}
RESPELT = frozenset({"unscramble", "become", "becomes", *_TURN, *_SHOWN})
"""Words without one of which no word is made of another."""
MADE = frozenset(
    form
    for form, senses in lexicon.VERB.items()
    for sense, _, tense in senses
    if sense == "build" and tense in ("base", "ing")
)
"""What is done with a word that is built."""
_BEHIND = frozenset({"instead", ".", "!", "please", "now"})


def respelling(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with both said plainly: the blocks spell one word at the start, and must spell the other at the end.

    Only of two words of the same letters: what else is to be done with the blocks is not said.
    """
    shown = [n for n, token in enumerate(tokens) if _word(token)]
    if len(shown) != 2:
        return _rearranged(tokens, words)
    first, second = shown
    old, new = (words[n] for n in shown)
    before, between = frozenset(words[:first]), frozenset(words[first + 1 : second])
    if old == new or sorted(old) != sorted(new) or not before <= _BEFORE or not between <= _BETWEEN:
        return _rearranged(tokens, words)
    made = not between.isdisjoint({"become", "becomes"})
    told = made or not before.isdisjoint(_TURN) or (not before.isdisjoint(_SHOWN) and not before.isdisjoint(_WHAT))
    if not told or between.isdisjoint(_TO_BE) or not frozenset(words[second + 1 :]) <= _BEHIND:
        return None
    now = [tokens[first].saying(word) for word in ("at", "the", "start", "the", "blocks", "spell")]
    then = [tokens[second].saying(word) for word in (".", "at", "the", "end", "they", "must", "spell")]
    return [*now, tokens[first], *then, tokens[second]]


def _rearranged(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Unscramble T, A and C to spell CAT": rearrange them."""
    if "unscramble" not in words[:2]:
        return None
    at = words.index("unscramble")
    return [*tokens[:at], tokens[at].saying("rearrange"), *tokens[at + 1 :]]


def word_made(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Build CAT from letter blocks": the word CAT. A text all in capitals names no word that way."""
    if any(len(token.raw) > 1 and token.raw.isupper() for token in tokens if token.word in MADE):
        return None
    for at in range(len(words) - 1):
        if words[at] in MADE and _word(tokens[at + 1]):
            named = [tokens[at].saying("the"), tokens[at].saying("word")]
            return [*tokens[: at + 1], *named, *tokens[at + 1 :]]
    return None


def _word(token: Token) -> bool:
    """A word in capitals, or in quotes."""
    capitals = token.raw.isupper() and token.raw.isalpha() and len(token.raw) > 1
    return capitals or (token.kind == "quote" and token.word.isalpha() and len(token.word) > 1)
