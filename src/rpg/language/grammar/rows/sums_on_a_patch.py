"""Digits on a patch of which the sum is told: "there are the digits 3, 4, 6 and 9; the sum of the two digits on the mat
must be 10", told as those that have it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations
from math import prod

from rpg.language.grammar.rows.parting import STOPS, sentences, text_of
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MUST, PATCH
from rpg.language.lexicon import NUMBER
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_DIGITS = f"(?:(?:digit|number)s?(?: {CUBE}s)?|{CUBE}s|ones)"
_STOCK = on_demand(
    f"(?:(?:there are|here are|we have|i have|you have|given|with|available) )?(?::|the|only|these| )*(?:{_DIGITS} ?)?"
    "(?:available|to choose from)?(?: ?(?:are|:))? ?(?P<list>\\d(?: , \\d)+(?: ,)?(?: and)? \\d|\\d to \\d)"
    "(?: are (?:there|available))?(?: [.;])?"
)
_ON = f"(?P<on>(?:on|in) (?:the|an?) (?:{COLOR} )?{PATCH})"
_MANY = "(?P<many>two|three|2|3)"
_KIND = "(?P<kind>sum|total|product|difference)"
_IS = f"(?:{MUST} be|{MUST} equal|is|equals)"
_RESULT = "(?P<result>\\d+|[a-z]+)(?: [.!])?"
_ASKED = (
    on_demand(f"the {_KIND} of the {_MANY} {_DIGITS} (?:that are )?{_ON} {_IS} {_RESULT}"),
    on_demand(f"the {_MANY} {_DIGITS} {_ON} {MUST} (?:add up|sum up|sum|come) to {_RESULT}"),
    on_demand(f"(?:put|place|lay|move) {_MANY} (?:{_DIGITS}|of (?:them|these)) {_ON}(?: ,)? (?:whose|so that "
               f"(?:the|their)|such that their|with the|so their) {_KIND} (?:{_IS} |of )?{_RESULT}"),
    on_demand(f"(?:put|place|lay|move) {_MANY} (?:{_DIGITS}|of (?:them|these)) {_ON}(?: ,)? (?:that|which|so that "
               f"they|so they) (?:add up|sum up|sum) to {_RESULT}"),
)  # fmt: skip
_WORKED_OUT: dict[str, Callable[[Sequence[int]], int]] = {
    "sum": sum, "total": sum, "product": prod, "difference": lambda two: abs(two[0] - two[-1]),
}  # fmt: skip
_TELLING = frozenset({"sum", "total", "product", "difference", "add"})
_FEW = 3
"""So many ways may be told one by one."""


_OF_THESE = on_demand(
    f"(?:put|place|lay|move) (?:exactly )?{_MANY} of the {_DIGITS} "
    f"(?P<list>\\d(?: , \\d)*(?: ,)?(?: and)? \\d|\\d to \\d) (?={_ON})"
)


def _stock_first(parts: list[list[Token]]) -> list[list[Token]]:
    """ "Put two of the digits 1, 2, 3 and 4 on the mat so that their sum is 5": there are these; put two of them."""
    met = _OF_THESE.match(text_of(parts[0])) if 0 < len(parts) < 3 else None
    if met is None:
        return parts
    end = len(met[0].split())
    begin = end - len(met["list"].split())
    first = next(n for n, token in enumerate(parts[0]) if token.word == "of")
    say = parts[0][begin].saying
    asked = [*(token for token in parts[0][: first + 1] if token.word != "exactly"), say("them"), *parts[0][end:]]
    if len(parts) == 2:  # "... on the mat. Their sum is 5"
        asked = [*asked[: len(asked) - (asked[-1].word in STOPS)], say("so"), say("that"), *parts[1]]
    return [[*map(say, ("the", "digits", "are")), *parts[0][begin:end]], asked]


def sums_on_a_patch(tokens: list[Token]) -> list[Token]:
    """The tokens with the digits that have such a sum, where it is told which digits there are."""
    if _TELLING.isdisjoint(token.word for token in tokens):
        return tokens
    parts = _stock_first(sentences(tokens))
    stock = _STOCK.fullmatch(text_of(parts[0])) if len(parts) == 2 else None
    asked = next((m for one in _ASKED if stock and (m := one.fullmatch(text_of(parts[1])))), None)
    if stock is None or asked is None:
        return tokens
    listed = [token for token in parts[0] if token.word in (",", "and", "to") or token.kind == "number"]
    shown = [int(token.word) for token in listed if token.kind == "number"]
    digits = [*map(str, range(shown[0], shown[1] + 1) if len(shown) == 2 else shown)]
    many, result = (NUMBER.get(asked[name]) or int(asked[name]) for name in ("many", "result"))
    kind = asked.groupdict().get("kind") or "sum"
    ways = [c for c in combinations(digits, many) if _WORKED_OUT[kind]([*map(int, c)]) == result]
    if not 0 < len(ways) <= _FEW or (kind == "difference" and many > 2):
        return tokens
    those = [f"{' , '.join(c[:-1])} and {c[-1]} must be {asked['on']}" for c in ways]
    told = f". exactly {asked['many']} of the digits must be {asked['on']} . {'either ' * (len(ways) > 1)}"
    told += f"{' or '.join(those)} ."
    say = parts[1][-1 - (parts[1][-1].word in STOPS)].saying  # in the place of the result, which is not lost so
    ahead = [*map(say, ("there", "are", "the", "digits")), *listed]
    return [
        *ahead,
        *(
            replace(say(word), kind="number", value=float(word)) if word in digits else say(word)
            for word in told.split()
        ),
    ]
