""" "Four red cubes, so that there is one in each corner": one of those that are placed so, and no further ones."""

from __future__ import annotations

from rpg.language.meaning import Amount, Chain, Clause, In, Loc, Meaning, Noun, Pronoun, That, replace


def one_in_each(chain: Chain) -> Chain:
    """The sentence with "one of them" for the "one" that is to be in each place."""
    return replace(chain, clauses=tuple(map(_of_them, chain.clauses)))


def _of_them(clause: Meaning) -> Meaning:
    theme = clause.theme if isinstance(clause, Clause) else None
    if not isinstance(clause, Clause) or not isinstance(theme, Noun) or not theme.plural or theme.head == "patch":
        return clause
    return replace(clause, adjuncts=tuple(map(_so_that, clause.adjuncts)))


def _so_that(adjunct: Meaning) -> Meaning:
    if not isinstance(adjunct, That) or adjunct.kind != "so" or not isinstance(adjunct.clauses, Chain):
        return adjunct
    told = adjunct.clauses.clauses
    one = told[0] if len(told) == 1 else None
    if not isinstance(one, Clause) or one.negated or one.verb not in ("be", "exist"):
        return adjunct
    if not (isinstance(one.theme, Pronoun) and one.theme.word == "one") or not any(map(_each, one.adjuncts)):
        return adjunct
    them = Pronoun(word="them", span=one.theme.span)
    of_them = Noun(head="any", det="any", amount=Amount(1, 1), plural=True, part_of=them, span=one.theme.span)
    clauses = replace(adjunct.clauses, clauses=(replace(one, verb="be", theme=of_them),))
    return replace(adjunct, clauses=clauses)


def _each(place: Meaning) -> bool:
    if isinstance(place, In):
        return place.region.startswith("each_") and not place.negated
    return isinstance(place, Loc) and getattr(place.landmark, "det", "") == "each" and not place.negated
