""" "Every cube goes on the mat unless it is green": every one but the green ones."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.adjectives import adjectives
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Coord, Meaning, Noun, Pronoun, Traits, replace

_UNLESS = ("unless it is", "unless they are", "except if it is", "except when it is", "except if they are",
           "except when they are", "only not if it is", "except where it is")  # fmt: skip


_EXCEPT = ("except for", "except", "apart from", "save for", "with the exception of", "excluding")
_EXCEPTING = frozenset({"except", "apart", "save", "exception", "excluding"})
_ENDS = frozenset({".", ";", "!"})
WORDS = frozenset({"unless", *_EXCEPTING})
"""Words without one of which nothing is taken from what is said."""


def _but_these(p: Parser, at: int, said: Meaning) -> Results[Clause]:
    """ "Every block goes into the left half, except the red one": of the rest."""
    start = p.any_of(p.opt(at, ","), _EXCEPT)
    if not start or not isinstance(said, Clause) or said.negated or said.mode in ("start", "given"):
        return
    theme = said.theme
    if isinstance(theme, Pronoun) and theme.word == "everything":
        theme = Noun(head="block", det="all", plural=True, span=theme.span)
    if not isinstance(theme, Noun) or theme.det not in ("all", "each") or theme.head == "patch" or theme.conditions:
        return
    if theme.traits != Traits() or theme.part_of is not None:
        return
    for those, end in noun_phrase(p, start):
        one = isinstance(those, Noun) and those.det == "the" and those.head != "patch" and not those.conditions
        if one and (end >= p.end or p.words[end] in _ENDS):
            whole = Coord(op="except", items=(theme, those), span=theme.span)
            yield replace(said, theme=whole, span=p.span(at, end)), end


def unless(p: Parser, at: int, said: Meaning) -> Results[Clause]:
    """The clause without those of its blocks that are told behind it."""
    k = p.any_of(p.opt(at, ","), _UNLESS)
    theme = said.theme if k and isinstance(said, Clause) and not said.negated else None
    if k == 0:
        yield from _but_these(p, at, said)
    every = isinstance(theme, Noun) and theme.det in ("each", "all", "the", "any") and theme.head != "patch"
    if not every or not isinstance(theme, Noun) or not isinstance(said, Clause) or theme.conditions:
        return
    if theme.det == "the" and not theme.plural:
        return
    for marks, end in adjectives(p, p.opt(k, "a", "an")):
        end = p.opt(end, "one", "ones", "cube", "block")
        if {*marks} <= {"colors", "kind"} and len(marks) == 1 and (end >= p.end or p.words[end] in (",", ";", ".")):
            those = Noun(head="block", det="all", plural=True, traits=Traits(**marks), span=p.span(k, end))
            whole = Coord(op="except", items=(theme, those), span=theme.span)
            yield replace(said, theme=whole, span=p.span(at, end)), end
