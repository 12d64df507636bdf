""" "Red is in the left half, blue in the right half. At the end it should be the other way round": each in the place
of the other one."""

from __future__ import annotations

from rpg.language.meaning import (
    At,
    Chain,
    Clause,
    In,
    Loc,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    parts_of,
    replace,
)


def other_way_round(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, with what is told of two things before such a clause told of each other at the end."""
    chains = _of_relations(chains)
    said = [(n, k) for n, chain in enumerate(chains) for k in range(len(chain.clauses))]
    for at in range(2, len(said)):
        (n, k), facts = said[at], said[at - 2 : at]
        turned = chains[n].clauses[k]
        told = [chains[m].clauses[j] for m, j in facts]
        begun = any(_starts(x) for fact in told if isinstance(fact, Clause) for x in fact.adjuncts)
        places = [_placed(fact, begun) for fact in told]
        if not isinstance(turned, Clause) or not _turns(turned) or not _alike(places[0], places[1]):
            continue
        ends = [_ends_at(turned, fact, place) for fact, place in zip(told, reversed(places), strict=True)]
        chain = chains[n]
        clauses, links = (*chain.clauses[:k], *ends), (*chain.links[:k], chain.links[k], "and")
        chains = (
            *chains[:n],
            replace(chain, clauses=(*clauses, *chain.clauses[k + 1 :]), links=(*links, *chain.links[k + 1 :])),
            *chains[n + 1 :],
        )
        return _begun(chains, facts)
    return chains


def _of_relations(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "(Red is on blue.) Make it the other way round": so it should be, and not as it is, where no line was told that
    is made anew."""
    if any(isinstance(x, Structure) for chain in chains for x in parts_of(chain)):
        return chains
    found: list[Chain] = []
    for chain in chains:
        said = chain.clauses[0]
        if isinstance(said, Clause) and len(chain.clauses) == 1 and (_turns(said) or _made_so(said)) and found:
            chain = replace(chain, clauses=(replace(said, verb="be", lemma="", mode="goal"),))
            facts = [(len(found) - 1, k) for k in range(len(found[-1].clauses))]
            plain = [_placed(c, False) is not None for c in found[-1].clauses]
            found = [*_begun(tuple(found), facts)] if all(plain) else found
        found.append(chain)
    return tuple(found)


def _made_so(clause: Clause) -> bool:
    asked = (clause.verb, clause.lemma, clause.mode) == ("build", "make", "command") and not clause.negated
    return asked and _turns(clause)


def _turns(clause: Clause) -> bool:
    """Whether nothing is said but that something is the other way round."""
    manners = [x.kind for x in clause.adjuncts if isinstance(x, Manner)]
    whole = isinstance(clause.theme, Pronoun) and clause.theme.word in ("it", "they", "them", "that", "everything")
    ends = clause.mode in ("goal", "command") and not clause.negated
    return (
        whole
        and ends
        and len(manners) == len(clause.adjuncts)
        and "backwards" in manners
        and {*manners} <= {"backwards", "finally"}
    )


def _starts(adjunct: Meaning) -> bool:
    return isinstance(adjunct, Manner) and adjunct.kind == "start"


def _placed(fact: Meaning, begun: bool) -> Meaning | None:
    """The place of a single thing. `begun`: it is said of one of the two that it is so at the start."""
    if not isinstance(fact, Clause) or fact.negated or not isinstance(fact.theme, Noun):
        return None
    places = [x for x in fact.adjuncts if not _starts(x)]
    told = begun or fact.mode in ("start", "given") or (fact.lemma, fact.mode) == ("fact", "goal")
    place = places[0] if told and len(places) == 1 else None
    return place if isinstance(place, At) or (isinstance(place, In | Loc) and not place.negated) else None


def _alike(one: Meaning | None, other: Meaning | None) -> bool:
    """Whether two things may change these places: halves or corners of the table, sides, patches."""
    if isinstance(one, In) and isinstance(other, In):
        return one.region != other.region
    if isinstance(one, At) and isinstance(other, At):
        return one.whole is None and {one.side, other.side} in _ACROSS
    if not isinstance(one, Loc) or not isinstance(other, Loc) or (one.rel, other.rel) != ("on", "on"):
        return False
    marks = [x for x in (one.landmark, other.landmark) if isinstance(x, Noun) and x.head == "patch"]
    return len(marks) == 2 and marks[0].traits != marks[1].traits


_ACROSS = ({"left", "right"}, {"front", "back"}, {"top", "bottom"})


def _ends_at(turned: Clause, fact: Meaning, place: Meaning | None) -> Clause:
    assert isinstance(fact, Clause) and isinstance(place, In | Loc | At)
    if isinstance(place, Loc) and isinstance(place.landmark, Noun):
        place = replace(place, landmark=_known(place.landmark))
    theme = _known(fact.theme) if isinstance(fact.theme, Noun) else fact.theme
    last = tuple(x for x in turned.adjuncts if isinstance(x, Manner) and x.kind == "finally")
    place = replace(place, span=turned.adjuncts[0].span)
    return replace(turned, verb="be", mode="goal", theme=theme, adjuncts=(place, *last))


def _known(noun: Noun) -> Noun:
    return replace(noun, det="the", amount=None) if noun.det == "a" else noun


def _begun(chains: tuple[Chain, ...], facts: list[tuple[int, int]]) -> tuple[Chain, ...]:
    """The sentences with these facts told of the start."""
    for n, k in facts:
        fact = chains[n].clauses[k]
        if isinstance(fact, Clause) and fact.mode == "goal":
            begun = replace(fact, mode="start", adjuncts=tuple(x for x in fact.adjuncts if not _starts(x)))
            clauses = tuple(begun if c is fact else c for c in chains[n].clauses)
            chains = (*chains[:n], replace(chains[n], clauses=clauses), *chains[n + 1 :])
    return chains
