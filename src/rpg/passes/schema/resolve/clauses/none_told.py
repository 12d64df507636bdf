"""Wishes that tell of no block at all: "clear the green patch", "nothing should be touching"."""

from __future__ import annotations

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    In,
    Loc,
    Manner,
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

TWO = Amount(2, 2)


def none_told(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with the blocks that are meant: those on the patch that is to be cleared, or all that there are."""
    things = [part for chain in chains for part in parts_of(chain)]
    if any(isinstance(x, Structure) or (isinstance(x, Noun) and x.head != "patch" and not _none(x)) for x in things):
        return chains
    clauses = [clause for chain in chains for clause in chain.clauses]
    if len(clauses) != 1:
        return chains
    return tuple(replace(chain, clauses=tuple(map(_of_blocks, chain.clauses))) for chain in chains)


def _of_blocks(clause: Meaning) -> Meaning:
    if not isinstance(clause, Clause) or clause.mode not in ("command", "goal"):
        return clause
    theme = clause.theme
    if theme is not None and _none(theme) and _in_a_region(clause):
        every = Noun(head="block", det="the", plural=True, span=theme.span)
        return replace(clause, theme=Noun(head="block", det="no", plural=True, part_of=every, span=theme.span))
    if (patch := _emptied(clause)) is not None:
        every = Noun(head="block", det="all", plural=True, span=patch.span)
        place = Using(members=patch, lead="from", span=patch.span)
        return Clause(verb="remove", lemma="remove", theme=every, adjuncts=(place,), span=clause.span, word=clause.word)
    if not isinstance(theme, Pronoun) or clause.negated:
        return clause
    if theme.word == "nothing" and any(map(_to_each_other, clause.adjuncts)):
        return replace(clause, theme=Noun(head="block", det="no", amount=TWO, plural=True, span=theme.span))
    return clause


def _none(theme: Meaning) -> bool:
    """ "No block (is in the front half)", where no other is spoken of: none of those that there are."""
    if isinstance(theme, Noun):
        return theme == Noun(head="block", det="no", plural=theme.plural, span=theme.span)
    return isinstance(theme, Pronoun) and theme.word == "nothing"


def _only_place(clause: Clause) -> In | Loc | None:
    """Where something is, if nothing more is said of it than that it may be there or not."""
    places = [x for x in clause.adjuncts if not (isinstance(x, Manner) and x.kind == "allowed")]
    place = places[0] if len(places) == 1 and not clause.negated else None
    return place if isinstance(place, In | Loc) and not place.negated else None


def _in_a_region(clause: Clause) -> bool:
    return isinstance(_only_place(clause), In)


def _to_each_other(place: Meaning) -> bool:
    return isinstance(place, Loc) and getattr(place.landmark, "word", "") == "each other"


def _emptied(clause: Clause) -> Noun | None:
    """The patch on which nothing must be left, if it is one: of several it is open what lies where."""
    theme, place = clause.theme, _only_place(clause)
    if theme is not None and _none(theme):  # "nothing may be on the patch"
        on_it = isinstance(place, Loc) and place.rel == "on" and clause.verb in ("be", "exist")
        theme = place.landmark if on_it and isinstance(place, Loc) else None
        emptied = True
    elif clause.verb == "remove" and clause.lemma in ("clear", "empty"):
        emptied = not clause.adjuncts
    else:  # "the patch must be empty", "leave the patch empty"
        told = clause.adjuncts[0] if clause.verb == "be" and len(clause.adjuncts) == 1 else None
        emptied = isinstance(told, Quality) and told.traits == Traits(empty=True)
    single = isinstance(theme, Noun) and theme.head == "patch" and not theme.plural and not clause.negated
    return theme if emptied and single and isinstance(theme, Noun) else None
