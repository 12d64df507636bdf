""" "Two towers of three, one in the left half and one in the right half": each with a place of its own."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    Amount,
    Chain,
    Clause,
    Coord,
    In,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    Traits,
    replace,
)

_ONE = frozenset({"one", "the other", "the other one", "the second one", "another", "the third one"})


def one_here_one_there(chain: Chain) -> Chain:
    """The sentence with such structures built one by one."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        told = _apart(clause) if isinstance(clause, Clause) else ()
        clauses += told or (clause,)
        links += [link, *("and" for _ in told[1:])]
    return replace(chain, clauses=tuple(clauses), links=tuple(links)) if len(clauses) > len(chain.clauses) else chain


def _apart(clause: Clause) -> tuple[Clause, ...]:
    shape, told = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if clause.verb != "build" or clause.negated or not isinstance(shape, Structure) or not isinstance(told, Coord):
        return ()
    parts = [x for x in told.items if isinstance(x, Absolute) and _one(x.theme) and all(map(_placed, x.adjuncts))]
    several = shape.plural and shape.det == "bare" and shape.amount == Amount(len(parts), len(parts))
    if told.op != "absolutes" or len(parts) < len(told.items) or not several or not _each_so(shape):
        return ()
    single = replace(shape, plural=False, amount=Amount(1, 1), each_size=False)
    patches = any(_mark(x, "patch") for part in parts for x in part.adjuncts)
    return tuple(
        replace(clause, theme=replace(single, det="another" if n else "a"), adjuncts=_on_patches(part, patches))
        for n, part in enumerate(parts)
    )


def _on_patches(part: Absolute, patches: bool) -> tuple[Meaning, ...]:
    """ "On the green and (one) on the yellow patch": both are patches."""
    if not patches:
        return part.adjuncts
    return tuple(
        replace(x, landmark=replace(x.landmark, head="patch"))
        if isinstance(x, Loc) and isinstance(x.landmark, Noun) and _mark(x, "any")
        else x
        for x in part.adjuncts
    )


def _mark(place: Meaning, head: str) -> bool:
    mark = place.landmark if isinstance(place, Loc) and place.rel == "on" else None
    return isinstance(mark, Noun) and mark.head == head and (head == "patch" or bool(mark.traits.colors))


def _one(theme: Meaning | None) -> bool:
    """ "One", "the other one", and no look."""
    if isinstance(theme, Noun):
        return theme.head == "any" and theme.traits == Traits() and not theme.plural and not theme.conditions
    return isinstance(theme, Pronoun) and theme.word in _ONE


def _placed(place: Meaning) -> bool:
    return isinstance(place, In | Loc) and not place.negated


def _each_so(shape: Structure) -> bool:
    """Whether it is told what each of them is, and not what all of them are made of together."""
    members = shape.members
    return members is None or (isinstance(members, Noun) and (shape.each_size or members.amount is None))
