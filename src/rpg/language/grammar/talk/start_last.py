"""How blocks start, told at the end of what is so: "blue on green on red at the start"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

START_LAST = frozenset({"start", "beginning", "initially", "first", "originally", "outset"})
_AT_THE_START = (
    ("at", "the", "start"), ("at", "the", "beginning"), ("in", "the", "beginning"), ("at", "the", "outset"),
    ("at", "first"), ("initially",), ("originally",),
)  # fmt: skip
_PLACES = frozenset({"on", "in", "left", "right", "behind", "front", "next", "beside"})
_VERBS = frozenset({"must", "should", "shall", "is", "are", "be", "has", "have", "do", "does", "will", "i", "we", "you",
                    "if", "that", "not", "no", "there", "what", "which", "where", "from"})  # fmt: skip


def start_last(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with that told ahead of all that is so, where nothing but places is told and no verb says of what it
    is told; behind two or more of them it is told of each."""
    begin = 0
    for end in (n for n in range(len(words) + 1) if n == len(words) or words[n] in STOPS):
        said = words[begin:end]
        lead = next((k for k in range(1, len(said)) if length_at(said, k, _AT_THE_START) == len(said) - k), 0)
        told = said[:lead]
        several = sum(word in _PLACES for word in told) > 1
        plain = _VERBS.isdisjoint(told) and all(word not in lexicon.VERB or word in _PLACES for word in told)
        if lead and several and plain and told[0] not in lexicon.COMMANDS:
            ahead = [*tokens[begin + lead : end], tokens[begin].saying(",")]
            return [*tokens[:begin], *ahead, *tokens[begin : begin + lead], *tokens[end:]]
        begin = end + 1
    return None
