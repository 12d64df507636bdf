"""What there is, told ahead of an order, with no word of when: "One stack of six blocks. Split it.", "A, B and C stand
in a row. ... Straighten it." """

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences
from rpg.language.tokens import Token

_WISHED = frozenset({"must", "should", "shall", "will", "goal", "end", "finally", "start", "starts", "begin", "begins",
                     "initially", "first", "want", "wants", "would", "like", "please", "let", "then", "task", "aim",
                     "never", "always", "no", "may", "if", "ends", "ended", "ending", "finish", "finishes", "finished",
                     "final", "eventually", "ultimately", "result", "later", "become", "becomes", "stay",
                     "stays", "remain", "remains", "keep", "keeps", "still"})  # fmt: skip
"""With these a sentence tells of the end, or says itself when it is so."""
_STAND = frozenset({"stand", "stands", "lie", "lies", "sit", "sits"})
_GOING = frozenset({"leave", "leaves", "move", "moves", "stay", "stays"})
_TO_BE = frozenset({"must", "should", "shall", "will", "want", "goal", "end", "finally", "has", "have", "needs", "to"})
_ASKING = ("i want", "i would", "we want", "please", "now", "then", "at the end", "in the end", "finally")


def begun_ahead(tokens: Sequence[Token]) -> list[Token] | None:
    """The words with the first sentence told of the start; None where it may not be meant so.

    Only for texts that contradict themselves if all of them is so at the end.
    """
    first, *rest = sentences([*tokens])
    words = {token.word for token in first}
    orders = first[0].word in lexicon.COMMANDS or not words.isdisjoint(_WISHED) or "?" in words
    follows = any(part[0].word in lexicon.COMMANDS or _asks(part) for part in rest)
    if orders or not follows:
        return None
    lead = [first[0].saying(word) for word in ("at", "the", "start", ",")]
    return [*lead, *tokens]


def stands_first(words: Sequence[Token]) -> bool:
    """Whether a text begins with how blocks stand in a figure, as a fact, and goes on with an order: what is told first
    is there at the start, and is not what is to be built."""
    first, *rest = sentences([*words])
    said = {token.word for token in first}
    there = first[0].word == "there" and any(map(_goes_off, rest))
    fact = (there or not said.isdisjoint(_STAND)) and said.isdisjoint(_TO_BE) and first[0].word not in lexicon.COMMANDS
    built = any(token.word in lexicon.STRUCTURE for token in first)
    return fact and built and any(part[0].word in lexicon.COMMANDS or _goes_off(part) for part in rest)


def _goes_off(part: Sequence[Token]) -> bool:
    """Whether a sentence tells what leaves what was told, or stays: "the two on top go on the patch"."""
    words = {token.word for token in part}
    on_patch = not words.isdisjoint(lexicon.PATCH) and not words.isdisjoint(("go", "goes"))
    return on_patch or not words.isdisjoint(_GOING)


def _asks(part: Sequence[Token]) -> bool:
    return " ".join(token.word for token in part).startswith(_ASKING)
