""" "Of the red, green and blue cubes, put only the green one on the mat": what there is, in front of what is done."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Coord, In, Loc, Manner, Meaning, Noun, Pronoun, Structure, replace

_OF = ("of", "out of", "from", "from among", "among", "of all", "given")
_SOME = frozenset({"only", "just", "one", "but", "except", "without", "nothing", "not", "none", "no", "single", "two",
                   "three", "alone", "exactly", "neither", "every", "each", "apart"})  # fmt: skip
"""One of these tells of some of them, and not of all."""


def out_of_these(p: Parser, i: int) -> Results[Clause]:
    j = p.any_of(i, _OF) if not i else 0
    for theme, k in noun_phrase(p, j) if j else ():
        comma = p.opt(k, ",", ":")
        if not several(theme) or comma >= p.end or _SOME.isdisjoint(p.words[comma:]):
            continue
        yield Clause(verb="exist", lemma="stock", theme=_there(theme), mode="given", span=p.span(i, k), cost=3), comma


def several(theme: Meaning) -> bool:
    """Several blocks, all of them named or counted."""
    if isinstance(theme, Coord):
        return theme.op == "and" and all(isinstance(x, Noun) and _told(x) for x in theme.items)
    if not isinstance(theme, Noun) or not _told(theme):
        return False
    looks = max(len(theme.traits.colors), len(theme.traits.labels))
    return looks > 1 or (theme.amount is not None and theme.amount.low > 1)


def _told(noun: Noun) -> bool:
    plain = not isinstance(noun.part_of, Pronoun | Structure | Noun) and not noun.conditions and noun.head != "patch"
    return plain and bool(noun.traits.colors or noun.traits.labels) and noun.det in ("the", "bare", "a")


def _there(theme: Meaning) -> Meaning:
    """What is named for the first time."""
    if isinstance(theme, Coord):
        return replace(theme, items=tuple(map(_there, theme.items)))
    return replace(theme, det="bare") if isinstance(theme, Noun) and theme.det == "the" and theme.amount else theme


def none_of_the_others(found: Meaning) -> Meaning:
    """ "Out of red, blue and green, put red on the mat and nothing else": only red is there."""
    if not isinstance(found, Clause) or found.theme is None or found.negated:
        return found
    places = [a for a in found.adjuncts if isinstance(a, Loc | In)]
    more = [a for a in found.adjuncts if isinstance(a, Manner) and a.kind == "no more"]
    if len(places) != 1 or not more or len(found.adjuncts) != 2 or isinstance(found.theme, Pronoun):
        return found
    alone = Coord(op="only", items=(found.theme,), span=found.theme.span)
    return replace(found, theme=alone, adjuncts=(places[0],))
