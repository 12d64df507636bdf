"""Short talk of what was built: "black tower of three, white tower of three, black one left of white one"."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Coord, Into, Loc, Meaning, Noun, Structure, Traits, replace


def named_again(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, with "the" where two structures told before, each of one look, are told by looks alone."""
    looks: set[str] = set()
    out = []
    for chain in chains:
        clauses: list[Meaning] = []
        for clause in chain.clauses:
            clauses.append(_the(clause, looks) if looks else clause)
            looks |= set(_looks(clause))
        out.append(replace(chain, clauses=tuple(clauses)))
    return tuple(out)


def _looks(clause: Meaning) -> list[str]:
    """The colours of the structures that a clause tells of."""
    if not isinstance(clause, Clause) or clause.negated:
        return []
    told = [clause.theme, *(a.structure for a in clause.adjuncts if isinstance(a, Into))]
    shapes = [x for one in told for x in (one.items if isinstance(one, Coord) else (one,)) if isinstance(x, Structure)]
    colors = [x.traits.colors or (x.members.traits.colors if isinstance(x.members, Noun) else ()) for x in shapes]
    colors += [
        clause.theme.traits.colors for x in told[1:] if isinstance(x, Structure) and isinstance(clause.theme, Noun)
    ]
    return [found[0] for found in colors if len(found) == 1]


def _the(clause: Meaning, looks: set[str]) -> Meaning:
    if not isinstance(clause, Clause) or clause.verb not in ("be", "place", "build") or len(clause.adjuncts) != 1:
        return clause
    place, theme = clause.adjuncts[0], clause.theme
    mark = place.landmark if isinstance(place, Loc) else None
    if not isinstance(place, Loc) or not _bare(theme, looks) or not _bare(mark, looks):
        return clause
    return replace(clause, theme=_named(theme), adjuncts=(replace(place, landmark=_named(mark)),))


def _bare(thing: Meaning | None, looks: set[str]) -> bool:
    """ "Black tower", "black one": with no article, and with nothing else said of it."""
    if not isinstance(thing, Noun | Structure) or thing.det != "bare" or thing.plural:
        return False
    traits = thing.traits
    if len(traits.colors) != 1 or traits != Traits(colors=traits.colors) or traits.colors[0] not in looks:
        return False
    if isinstance(thing, Noun):
        return thing.head == "any" and thing.amount is None and thing.part_of is None and not thing.conditions
    return thing == Structure(kind=thing.kind, det="bare", amount=thing.amount, traits=traits, span=thing.span)


def _named(thing: Meaning | None) -> Meaning | None:
    return replace(thing, det="the") if isinstance(thing, Noun | Structure) else thing
