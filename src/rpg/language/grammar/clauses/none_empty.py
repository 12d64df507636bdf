"""Patches on each of which something lies: "every patch is occupied", "no patch stays empty", "none may be free"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Amount, Clause, Loc, Meaning, Noun, replace

_BE = (
    "is", "are", "should be", "must be", "shall be", "has to be", "have to be", "is to be", "are to be", "will be",
    "gets", "get", "must end up", "should end up", "ends up",
)  # fmt: skip
_OCCUPIED = frozenset({"occupied", "taken", "covered", "filled", "used", "full"})
_LEFT = (
    *_BE, "stays", "stay", "remains", "remain", "may be", "can be", "may stay", "may remain", "should stay",
    "should remain", "must stay", "must remain", "is left", "are left", "may be left", "should be left", "must be left",
    "stands", "lies",
)  # fmt: skip
_EMPTY = frozenset({"empty", "free", "unoccupied", "vacant", "bare", "uncovered", "unused", "clear"})
_NONE = ("none of", "not one of", "neither of", "not a single one of")
_TELLING = _OCCUPIED | _EMPTY
_CLOSED = frozenset({",", ".", ";", "and", "but", "then"})
_EACH = frozenset({"each", "all", "both", "every"})


@choice
def none_empty(p: Parser, i: int, mode: str) -> Results[Clause]:
    """One block at least on each of several patches."""
    if not p.rarely(_TELLING):
        return
    for patch, j in simple(p, i):
        told = p.one(p.any_of(j, _BE), _OCCUPIED) if _is_patch(patch) else 0
        each = isinstance(patch, Noun) and (patch.det in _EACH or patch.plural)
        if told and each and (told >= p.end or p.stands(told, _CLOSED)) and isinstance(patch, Noun):
            yield _on_each(p, i, told, patch, mode), told
        left = p.one(p.any_of(j, _LEFT), _EMPTY) if _is_patch(patch) else 0
        if left and isinstance(patch, Noun) and patch.det == "no":
            yield _on_each(p, i, left, patch, mode), left
    none = p.any_of(i, _NONE)
    for patch, j in simple(p, none) if none else ():
        left = p.one(p.any_of(j, _LEFT), _EMPTY) if _is_patch(patch) else 0
        if left and isinstance(patch, Noun) and patch.plural:
            yield _on_each(p, i, left, patch, mode), left


def _is_patch(meaning: Meaning) -> bool:
    return isinstance(meaning, Noun) and meaning.head == "patch"


def _on_each(p: Parser, i: int, end: int, patch: Noun, mode: str) -> Clause:
    if patch.plural and patch.det not in ("each", "no") and patch.part_of is None:
        whole = replace(patch, det="the", amount=Amount(2, 2) if patch.det == "both" else patch.amount)
        each = Noun(head="patch", det="each", plural=True, part_of=whole, span=patch.span)
    else:
        each = replace(patch, det="each", plural=False, amount=None)
    on = Loc(rel="on", landmark=each, span=patch.span)
    block = Noun(head="block", det="a", amount=Amount(1, 1), span=p.span(i, end))
    return Clause(verb="be", theme=block, adjuncts=(on,), mode=mode, span=p.span(i, end))
