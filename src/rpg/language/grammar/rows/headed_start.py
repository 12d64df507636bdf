"""A start told in several notes under one heading: "Start: red on blue; green on yellow. Goal: red on green." has both
at the start."""

from __future__ import annotations

from rpg.language.grammar.rows.parting import STOPS, sentences, text_of
from rpg.language.grammar.rows.said_short import PLACE
from rpg.language.grammar.rows.vocabulary import MUST
from rpg.language.lexicon import COMMANDS, POSTURE
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_STATE = "(?:state|scene|configuration|situation|arrangement|position|setup|layout|condition|conditions)"
_START = on_demand(
    f"(?:the )?(?:start|beginning|initial|init|before|initially|given|(?:initial|start|starting) {_STATE}|"
    "(?:at|in) the (?:start|beginning)) :"
)
_END = on_demand(
    f"(?:and )?(?:the )?(?:(?:goal|end|target|final|after|result|task|finally|finish|(?:goal|final|end|target|desired) "
    f"{_STATE}|(?:at|in) the end) :|(?:at|in) the end\\b|finally\\b)"
)
_NOTE = on_demand(f"(?!.*\\b(?:{MUST}|not|then|if|when)\\b)(?:.+ )?{PLACE} .+")
_STARTS = frozenset({"start", "beginning", "initial", "init", "before", "initially", "given", "starting"})


def headed_start(tokens: list[Token]) -> list[Token]:
    """The tokens with every note told as of the start that stands between a heading of the start and one of the end,
    or behind such a heading before the first full stop."""
    if _STARTS.isdisjoint(token.word for token in tokens) or not any(token.word == ":" for token in tokens):
        return tokens
    parts = sentences(tokens)
    told = [text_of(part) for part in parts]
    begin = next((n for n, text in enumerate(told) if _START.match(text)), len(parts))
    end = next((n for n in range(begin + 1, len(parts)) if _END.match(told[n])), 0)
    if not end:  # "Start: red on blue; green on yellow. Put green on red."
        end = next((n + 1 for n in range(begin, len(parts) - 1) if parts[n][-1].word != ";"), 0)
    between = range(begin + 1, end)
    if not between or not all(_is_note(parts[n], told[n]) for n in between):
        return tokens
    for n in between:
        mark = parts[n][0].saying
        parts[n] = [*map(mark, ("at", "the", "start", ":")), *parts[n]]
    return [token for part in parts for token in part]


def _is_note(part: list[Token], text: str) -> bool:
    """Whether a sentence only says where something is."""
    first = part[0].word
    commands = first in COMMANDS and first not in POSTURE
    return not commands and part[-1].word in STOPS and _NOTE.match(text) is not None
