"""Numbered commands, "1. Put red on blue. 2. Put green on red": steps, one after the other."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.tokens import Token

_NUMBER = re.compile(r"\s*\(?(\d{1,2})[.)]\s*")
_AHEAD = frozenset({"please", "now", "just", "robot", ","})
_ACTS = frozenset({"place", "stack", "pick", "swap", "unstack", "reverse", "build"})
"""What is done once; a rule, "keep ..." or "use ...", holds beside the others."""


def as_steps(tokens: list[Token]) -> list[Token]:
    """The tokens with "then" before each numbered command but the first, where all that is numbered commands."""
    marks = [n for n, token in enumerate(tokens) if token.word == ";" and _NUMBER.fullmatch(token.raw)]
    begun = 1 if marks and marks[0] == 0 else 0
    colon = next((n for n, token in enumerate(tokens[: marks[0]]) if token.word == ":"), -1) if marks else -1
    if not marks[begun:] or not all(_acts(tokens, n) for n in (*([] if begun else [colon]), *marks)):
        return tokens
    then = {n: Token("word", "then", tokens[n].raw, tokens[n].span) for n in marks[begun:]}
    return [found for n, token in enumerate(tokens) for found in ((token, then[n]) if n in then else (token,))]


def _acts(tokens: list[Token], mark: int) -> bool:
    """Whether what follows a number is a command to do something."""
    first = next((token for token in tokens[mark + 1 :] if token.word not in _AHEAD), None)
    forms = lexicon.VERB.get(first.word, ()) if first is not None else ()
    return any(verb in _ACTS and tense == "base" for verb, _, tense in forms)
