"""What ends up on top of the other one: "start with red on blue; swap them so that blue ends up on top"."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences, text_of
from rpg.language.grammar.rows.vocabulary import COLOR
from rpg.language.tokens import Token

_SWAP = re.compile(
    "(?:(?:and|then|now) )*(?:swap|exchange|switch|reverse|flip) (?:them|it|the two|both)(?: around| over)?(?: ,)? "
    f"so(?: that)? (?:the )?({COLOR})(?: one| block| cube)? (?:ends up|is|comes|goes|lands)(?: up)? on top(?: [.!])?"
)


def swapped_over(tokens: list[Token]) -> list[Token]:
    """The tokens, with the block that is to be on top as on the only other one that was told of."""
    if not {"swap", "exchange", "switch", "reverse", "flip"} & {token.word for token in tokens}:
        return tokens
    out: list[Token] = []
    for sentence in sentences(tokens):
        told = _SWAP.fullmatch(text_of(sentence))
        known = list(dict.fromkeys(token.word for token in out if token.word in lexicon.COLOR))
        if told is not None and len(known) == 2 and told[1] in known:
            other = known[1 - known.index(told[1])]
            say = sentence[0].saying
            out += map(say, ("the", told[1], "block", "must", "be", "on", "the", other, "block", "."))
        else:
            out += sentence
    return out
