"""What comes first in a line, told in a sentence of its own: "Stack red, green and blue. Start with green."."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.tokens import Token

_IT = "it|them|this|the_row|the_line|the_tower|the_stack|the_column|the_order|the_pattern|the_sequence"
_FIRST = Patterns(f"please|and|but? start|begin {_IT}? with|from|by")
_LAST = Patterns(f"please|and|but? end|finish {_IT}? with|on|by")
_LEADS = frozenset({"start", "begin", "end", "finish"})
_LINES = frozenset({"row", "line", "tower", "stack", "column", "rows", "stacks", "towers", "lines", "stacked",
                    "alternate", "alternating", "pile"})  # fmt: skip
_SIDES = frozenset({"at", "on", "from", "in", "the", "bottom", "top", "left", "right", "front", "back", "end", "side",
                    "near", "far", "leftmost", "rightmost", "lowest"})  # fmt: skip
_ONE = frozenset({"the", "a", "an", "one", "block", "cube", "letter", "number", "digit"})


def with_beginnings(tokens: list[Token]) -> list[Token]:
    """The text with what is first or last in a line put behind the sentence that tells of the line."""
    if _LEADS.isdisjoint(token.word for token in tokens):
        return tokens
    out: list[list[Token]] = []
    ahead: list[Token] | None = None
    for part in sentences(tokens):
        told, lined = _told(part), not _LINES.isdisjoint(token.word for token in part)
        if told is not None and out and not _LINES.isdisjoint(token.word for token in out[-1]):
            out[-1] = _joined(out[-1], told)
        elif told is not None and not out and any(token.word == "the" for token in part):
            ahead = told
        elif ahead is not None and not lined:
            return tokens
        else:
            out.append(_joined(part, ahead) if ahead is not None else part)
            ahead = None
    return tokens if ahead is not None else [token for part in out for token in part]


def _joined(part: list[Token], told: list[Token]) -> list[Token]:
    stop = part[-1:] if part[-1].word in STOPS else []
    return [*part[: len(part) - len(stop)], *told, *stop]


def _told(part: Sequence[Token]) -> list[Token] | None:
    """What is set behind the line; None where no more than one block, and where it is, is told."""
    part = part[:-1] if part[-1].word in STOPS else part
    for lead, said in ((_FIRST, "starting"), (_LAST, "ending")):
        end = max(lead.matches(Parser([*part]), 0), default=0) if part else 0
        rest = part[end:]
        if end and rest and all(map(_plain, rest)):
            return [part[0].saying(","), part[0].saying(said), part[0].saying("with"), *rest]
    return None


def _plain(token: Token) -> bool:
    shown = token.kind in ("number", "literal") or (len(token.raw) == 1 and token.raw.isalpha())
    return shown or token.word in _ONE | _SIDES or token.word in lexicon.COLOR
