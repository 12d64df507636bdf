"""What is said of all letters or all digits is said of those that the rest of the instruction names."""

from __future__ import annotations

from rpg.language.meaning import (
    Chain,
    Clause,
    Loc,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    Traits,
    parts_of,
    replace,
)


def of_a_kind(clause: Meaning) -> bool:
    """ "All letters should be upright", "every digit is on the mat": of blocks that nothing else here names."""
    theme = clause.theme if isinstance(clause, Clause) and clause.verb in ("be", "turn", "keep", "place") else None
    if not isinstance(clause, Clause) or not isinstance(theme, Noun) or theme.head != "block":
        return False
    if clause.mode not in ("goal", "command") or theme.det not in ("all", "each") or theme.amount or theme.part_of:
        return False
    kind = theme.traits.kind
    return kind in ("letter", "digit", "symbol") and theme.traits == Traits(kind=kind) and not _names(clause)


def _names(meaning: Meaning) -> bool:
    """Whether symbols are named: "A, B and C", "the word CAT"."""
    parts = parts_of(meaning)
    return any((isinstance(x, Noun) and x.traits.labels) or (isinstance(x, Structure) and x.letter) for x in parts)


def kinds_last(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """In each sentence whose clauses follow one another in no time, those of a kind behind those that name symbols."""
    return tuple(_last(chain) for chain in chains)


def _last(chain: Chain) -> Chain:
    told = [c for c in chain.clauses if of_a_kind(c)]
    rest = [c for c in chain.clauses if not of_a_kind(c)]
    if not told or not any(map(_names, rest)) or any(link != "and" for link in chain.links):
        return chain
    return replace(chain, clauses=(*rest, *told))


def waits(chain: Chain, chains: tuple[Chain, ...]) -> bool:
    """Whether a sentence of a kind alone is to be read behind the others, for these name its symbols, or count it."""
    others = [other for other in chains if other is not chain]
    if all(map(_of_nothing, chain.clauses)):  # "nothing may touch the red block": of none of all that there are
        told = parts_of((*(clause.adjuncts for clause in chain.clauses if isinstance(clause, Clause)), *others))
        return all(x.word == "each other" for x in told if isinstance(x, Pronoun))
    hues = [_denied_hue(clause) for clause in chain.clauses]
    if all(hues):
        counted = {x.traits.colors for x in parts_of(tuple(others)) if isinstance(x, Noun) and _counts(x)}
        return counted.issuperset(hues)
    return all(map(of_a_kind, chain.clauses)) and any(map(_names, others))


def _of_nothing(clause: Meaning) -> bool:
    """ "Nothing", or "no block", is to be somewhere, or is not to be touched."""
    if not isinstance(clause, Clause) or clause.verb != "be" or clause.mode != "goal" or not clause.adjuncts:
        return False
    theme, named = clause.theme, [x.landmark for x in clause.adjuncts if isinstance(x, Loc)]
    nothing = isinstance(theme, Pronoun) and theme.word == "nothing"
    bare = isinstance(theme, Noun) and (theme.head, theme.det, theme.part_of, theme.amount) == (
        "block",
        "no",
        None,
        None,
    )
    none = nothing or (bare and isinstance(theme, Noun) and theme.traits == Traits() and not theme.conditions)
    if not none or not named or not all(isinstance(x, Loc | Manner) for x in clause.adjuncts):
        return False
    return all(isinstance(x, Noun) and x.head != "patch" and x.det == "the" for x in named)


def _denied_hue(clause: Meaning) -> tuple[str, ...]:
    """The colour of "no red block is next to another red block", told of blocks that other sentences bring up."""
    theme = clause.theme if isinstance(clause, Clause) and (clause.verb, clause.mode) == ("be", "goal") else None
    if not isinstance(theme, Noun) or theme.det != "no" or theme.head == "patch" or theme.part_of or theme.conditions:
        return ()
    return theme.traits.colors if theme.traits == Traits(colors=theme.traits.colors[:1]) else ()


def _counts(noun: Noun) -> bool:
    return noun.head != "patch" and noun.det == "bare" and noun.amount is not None and noun.part_of is None
