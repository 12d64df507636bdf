""" "Take two blocks off the tower of five and make a second tower": the second one is made of two of the five."""

from __future__ import annotations

from rpg.language.meaning import Amount, Chain, Clause, Loc, Meaning, Noun, Pronoun, Structure, Traits, Using, replace
from rpg.passes.schema.resolve.things.world import refuse

_TAKEN = frozenset({"take", "remove", "get", "pull", "pick", "lift", "grab"})
_THEM = frozenset({"them", "these", "those", "it"})


def taken_off(chain: Chain) -> Chain:
    """The sentence with what is made of blocks that are taken off a structure told as made of some of its blocks."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for n, clause in enumerate(chain.clauses):
        taken = clauses[-1] if clauses else None
        made = _made_of_some(taken, clause) if chain.links[n] in ("and", "then") else None
        if made is not None:
            links = [*links[:-1], *["and"] * len(made)]
            clauses = [*clauses[:-1], *made]
            continue
        clauses.append(clause)
        links.append(chain.links[n])
    for left in clauses:
        _none_of_its_own(left)
    told = tuple(clauses)
    return chain if told == chain.clauses else replace(chain, clauses=told, links=tuple(links))


def _whole(taken: Clause) -> Structure | Pronoun | None:
    """What plain blocks are taken off, if a clause says just that."""
    place = taken.adjuncts[0] if len(taken.adjuncts) == 1 else None
    theme = taken.theme
    plain = isinstance(theme, Noun) and theme.traits == Traits() and theme.part_of is None and not theme.conditions
    counted = isinstance(theme, Noun) and theme.amount is not None and theme.amount.low == theme.amount.high
    if taken.lemma not in _TAKEN or taken.negated or not plain or not counted or getattr(theme, "head", "") == "patch":
        return None
    if isinstance(place, Loc):
        mark = place.landmark if place.rel == "off" and not place.negated else None
    else:
        mark = place.members if isinstance(place, Using) and place.lead == "out of" else None
    return mark if isinstance(mark, Structure | Pronoun) else None


def _made_of_some(taken: Meaning | None, clause: Meaning) -> tuple[Clause, ...] | None:
    """The structure that there is, and the one that is made of some of its blocks."""
    if not isinstance(taken, Clause) or not isinstance(clause, Clause) or clause.negated:
        return None
    whole, theme = _whole(taken), taken.theme
    if whole is None or not isinstance(theme, Noun):
        return None
    if isinstance(whole, Structure) and (whole.plural or whole.det != "the" or not isinstance(whole.members, Noun)):
        return None
    shape = clause.theme if clause.verb == "build" else None
    if clause.verb == "stack" and getattr(clause.theme, "word", "") in _THEM and not clause.adjuncts:
        shape = Structure(kind="stack", det="another", amount=Amount(1, 1), span=clause.span)
    bare = isinstance(shape, Structure) and shape.det in ("a", "another") and not (shape.plural or shape.sizes)
    if not bare or not isinstance(shape, Structure) or any(isinstance(a, Using) for a in clause.adjuncts):
        return None
    if shape.kind != "stack" and getattr(whole, "kind", "row") != "stack":
        return None  # the blocks of a row are in a row already
    if shape.members is not None and getattr(shape.members, "word", "") not in _THEM:
        return None
    them = Pronoun(word="them", span=theme.span)
    some = Noun(head="any", det="some", amount=theme.amount, plural=True, part_of=them, span=theme.span)
    using = Using(members=some, span=theme.span)
    made = replace(
        clause, verb="build", theme=replace(shape, members=None, det="another"), adjuncts=(using, *clause.adjuncts)
    )
    if isinstance(whole, Pronoun):
        return (made,)
    there = replace(whole, det="a", amount=Amount(1, 1))
    return (Clause(verb="exist", theme=there, mode="given", span=taken.span), made)


def _none_of_its_own(clause: Meaning) -> None:
    """Refuse "take a block off the tower of three": it would be a fourth block, beside the three."""
    place = clause.adjuncts[0] if isinstance(clause, Clause) and clause.adjuncts else None
    whole = _whole(clause) if isinstance(clause, Clause) and isinstance(place, Loc) else None
    if isinstance(whole, Structure) and (whole.members is not None or whole.sizes):
        raise refuse("ambiguous", "it is not clear which of its blocks this is", clause.span,
                     "name the block by its colour or its symbol")  # fmt: skip
