""" "Red is on the mat. Blue should be there too": whether what was told can be told again of the end, and whether what
should be is said of the same things."""

from __future__ import annotations

import re

from rpg.language.meaning import (
    Chain,
    Clause,
    Meaning,
    Noun,
    Pronoun,
    Quality,
    Structure,
    Traits,
    Using,
    parts_of,
    replace,
)

SHOULD = re.compile(
    r"\b(?:(?:must|should|ought)(?:n't)?|shall|has to|have to|needs? to|(?:is|are) (?:not )?to)\b", re.IGNORECASE
)


def of_these(wish: Clause, fact: Clause) -> bool:
    """Whether it is one of the things that the fact tells of, or "it", "they", "the tower"."""
    theme = _told_of(wish)
    if any(isinstance(x, Pronoun) for x in parts_of(theme)):
        return True
    if isinstance(theme, Structure) and theme.det == "the" and theme.members is None:
        return any(isinstance(x, Structure) and x.kind == theme.kind for x in parts_of(fact)) or fact.verb == theme.kind
    if isinstance(theme, Noun) and theme.head == "any" and theme.traits == Traits():
        return True  # "exactly one (of them)"
    named = [x.traits for x in parts_of(fact) if isinstance(x, Noun) and x.head != "patch"]
    return any(_looks_so(x.traits, one) for x in parts_of(theme) if isinstance(x, Noun) for one in named)


def of_a_part(wish: Clause) -> bool:
    """ "Its top block must be red", "the middle one must be on the mat": what is said of a part of what is told."""
    theme = wish.theme
    looks = any(isinstance(x, Quality) for x in wish.adjuncts)
    part = isinstance(theme, Noun) and (theme.det == "its" or theme.traits.rank is not None)
    return looks or part or (isinstance(theme, Noun) and theme.part_of is not None)


def _looks_so(traits: Traits, told: Traits) -> bool:
    """Whether a look is that of one of the blocks that a noun tells of: "C" of "A, B and C", also "A and C"."""
    looks = {*traits.colors, *traits.labels}
    among = not looks.isdisjoint({*told.colors, *told.labels}) and traits.size in (None, told.size)
    return among or (not looks and traits.size is not None and traits.size == told.size)


def definite(fact: Clause) -> bool:
    """Whether what a fact tells of can be spoken of again: single things, blocks that are named one by one, and blocks
    of one look that are counted; and whether it does not tell of a structure by more than its kind."""
    if fact.verb == "spell":
        return True
    nouns, theme = [x for x in parts_of(fact) if isinstance(x, Noun)], _told_of(fact)
    counted = isinstance(theme, Noun) and theme.amount is not None and bool(theme.traits.colors)
    single = all(x.det in ("the", "bare") and not x.amount and not x.plural for x in nouns if x is not theme)
    known = single and (counted or not nouns or (nouns[0].det in ("the", "bare") and _one_by_one(nouns[0])))
    shapes = [x for x in parts_of(fact) if isinstance(x, Structure)]
    return known and all(x == Structure(kind=x.kind, amount=x.amount, dims=x.dims, members=x.members, span=x.span)
                         for x in shapes)  # fmt: skip


def _one_by_one(noun: Noun) -> bool:
    """ "the red block", "A, B and C"."""
    return not noun.plural or len(noun.traits.labels) > 1 or len(noun.traits.colors) > 1


def _told_of(fact: Clause) -> Meaning | None:
    """What a fact tells of: in "six blocks form a circle" and "a circle of six blocks is on the mat" the blocks."""
    made_of = fact.adjuncts[0] if len(fact.adjuncts) == 1 and isinstance(fact.theme, Structure) else None
    if isinstance(made_of, Using):
        return made_of.members
    return fact.theme.members if isinstance(fact.theme, Structure) else fact.theme


def known_by_then(fact: Clause) -> Clause:
    """The fact, of blocks that are there by then: "the two red blocks"."""
    noun = _told_of(fact)
    if not isinstance(noun, Noun) or noun.amount is None or noun.det not in ("a", "bare"):
        return fact
    known = replace(noun, det="the", amount=noun.amount if noun.plural else None)
    if isinstance(fact.theme, Structure) and fact.theme.members is not None:
        return replace(fact, theme=replace(fact.theme, members=known))
    if isinstance(fact.theme, Structure):
        return replace(fact, adjuncts=tuple(replace(x, members=known) for x in fact.adjuncts if isinstance(x, Using)))
    return replace(fact, theme=known)


def made_so(chain: Chain, said: str) -> bool:
    """ "A, B and C are stacked", "the letters spell STOP": one structure, in the indicative."""
    made = chain.clauses[0]
    one = len(chain.clauses) == 1 and isinstance(made, Clause) and made.verb in _MAKING and not made.negated
    return one and isinstance(made, Clause) and made.mode == "goal" and _IS.search(said) is not None


_MAKING = ("stack", "build", "arrange", "spell")
_IS = re.compile(r"\S \b(?:is|are|forms?|makes?|spells?|reads?|shows?|stands?|lies?)\b", re.IGNORECASE)
