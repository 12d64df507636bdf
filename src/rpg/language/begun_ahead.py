"""What there is, told ahead of an order that undoes it, with no word of when: "One stack of six blocks. Split it." """

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


def _asks(part: Sequence[Token]) -> bool:
    return " ".join(token.word for token in part).startswith(_ASKING)
