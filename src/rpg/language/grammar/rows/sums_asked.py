"""A sum that is asked for, and then to be shown: "What is 3 plus 4? Lay out the whole equation with the answer."."""

from __future__ import annotations

import re

from rpg.language.grammar.rows.parting import sentences, text_of
from rpg.language.grammar.structures.equations import value_of
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_ASKED = on_demand("(?:how much|what)(?: is| are| does| do| makes?| 's)? (?P<sum>.+?)(?: (?:make|give|equal))? \\?")
_SIGNS = {"plus": "+", "+": "+", "minus": "-", "-": "-", "times": "*", "x": "*", "*": "*", "/": "/", "divided": "/",
          "multiplied": "*"}  # fmt: skip
_LEAD = (
    "(?:(?:please|now|then|and|so|just|let|have|make|get|ask|can|could|would|will|should|must|it|him|her|us|me|you|i|"
    "want|to|see|the|a|robot|arm|,) )*"
)
_DO = (
    "(?:lay|write|show|build|make|put|spell|form|display|arrange|place|set|solve|see|have|read)(?: (?:out|down|up|"
    "together))?(?: (?:me|us))?"
)
_WHOLE = "(?:the |that |this |it as |as )*(?:an? )?(?:(?:whole|complete|full|entire|right|correct|true) )*"
_SUM = "(?:equation|calculation|sum|addition|subtraction|multiplication|division|problem)"
_CUBES = (
    "(?:(?: ,)? (?:with|using|in|from|out of|on)(?: the| our| my)?(?: (?:number|digit|symbol|sign|letter))?"
    "(?: (?:and|or) (?:sign|symbol)s?)? (?:blocks|cubes|tiles|table))"
)
_PARTS = (
    "(?:(?: ,| with| and| including| together with| plus)+(?: (?:the|its|an?))?(?: (?:right|correct))? (?:result|"
    "answer|solution|(?:\\w+ )?sign|=|\\+|-|\\*|/))"
)
_SHOW_IT = on_demand(
    f"{_LEAD}{_DO} (?:{_WHOLE}{_SUM}|(?:the |its )?(?:answer|result|solution) as {_WHOLE}{_SUM})"
    f"(?:(?:{_CUBES}|{_PARTS})*|{_CUBES}?(?P<where> (?:on|in|at) the .+?))(?: [.!?])?"
)
_IT = f"(?: (?:it|this|that|the (?:answer|result)|{_WHOLE}{_SUM}))?"
_AS_TOLD = on_demand(f"{_LEAD}{_DO}{_IT}(?: out)?{_CUBES}? (?:: |, )?_EQUATION(?: [.!?])?")


def sums_asked(tokens: list[Token]) -> list[Token]:
    """The tokens with the sum that is asked for as one to be solved and laid out, or as the equation that is told
    behind it, if that has it on one of its sides."""
    parts = sentences(tokens)
    asked = _ASKED.fullmatch(text_of(parts[0])) if len(parts) > 1 and parts[0][0].word in ("what", "how") else None
    if asked is None:
        return tokens
    begin = text_of(parts[0])[: asked.start("sum")].count(" ")
    found = parts[0][begin : begin + asked["sum"].count(" ") + 1]
    side = _symbols(found)
    behind, rest = parts[1], [token for part in parts[2:] for token in part]
    say = tokens[0].saying
    if not side or value_of(side) is None:
        return tokens
    if (shown := _SHOW_IT.fullmatch(text_of(behind))) and _signs(behind) <= {*side}:
        where = (shown["where"] or "").split()
        at = text_of(behind)[: max(shown.start("where"), 0)].count(" ") + 1
        return [say("solve"), *found, *behind[at : at + len(where)], say("."), *rest]
    told = [token for token in behind if token.kind == "equation"]
    text = " ".join("_EQUATION" if token in told else token.word for token in behind)
    if len(told) == 1 and side in str(told[0].value).split("=") and _AS_TOLD.fullmatch(text):
        return [say("write"), *told, say("."), *rest]
    return tokens


def _symbols(tokens: list[Token]) -> str:
    """The calculation in numbers and signs; nothing where it is none."""
    shown = [str(token.many) if token.many else _SIGNS.get(token.word, "") for token in tokens if token.word != "by"]
    side = "".join(shown)
    return side if all(shown) and re.fullmatch("\\d+(?:[-+*/]\\d+)+", side) else ""


def _signs(tokens: list[Token]) -> set[str]:
    """The signs of operations that are named."""
    return {_SIGNS[token.word] for token in tokens if token.word in _SIGNS and token.word != "x"}
