""" "Exactly one of them goes there, not two": a number that the exact one rules out, said for emphasis."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.tokens import Token

_NOT = Patterns("and|so|but|definitely|certainly? not|never just|only|even?")
_ALL = Patterns("all|both|every_one of? them|these|those|the_blocks|the_cubes?", "any more", "a_single_one more")
_ALSO = ("or", "and", "nor", ", not", "and not", "or even")
EXACTLY = frozenset({"exactly", "precisely", "only", "just"})


def number_denied(p: Parser, i: int) -> Results[None]:
    """At the end of a sentence that has told an exact number, another one."""
    for k in _NOT.matches(p, i):
        told = {p.number(n + 1) for n in range(i) if p.words[n] in EXACTLY} - {None}
        for end in _numbers(p, k, told) if len(told) == 1 else ():
            if end >= p.end:
                yield None, end


def _numbers(p: Parser, k: int, told: set[int | None]) -> list[int]:
    ends = [*_ALL.matches(p, k)]
    if (every := p.one(k, "all")) and p.number(every) not in told | {None}:
        ends.append(every + 1)
    if (number := p.number(k)) is not None and number not in told:
        all_ = p.any_of(k + 1, ("of them", "of these")) or k + 1
        ends += [all_, *(last for last in [p.any_of(all_, _ALSO)] if last for last in _numbers(p, last, told))]
    return ends


_HOW_MANY = frozenset({"not", "or", "and", ",", "all", "both", "just", "only", "even", "of", "them"})


def denies_a_number(part: list[Token]) -> bool:
    """ "Not two!": behind a sentence with a number that is exact, and no sentence of its own."""
    told = [token for token in part if token.word not in _HOW_MANY]
    return part[0].word == "not" and len(part) > 1 and all(t.kind == "number" or t.word in lexicon.NUMBER for t in told)
