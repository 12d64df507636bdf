""" "Red is in the left half, blue in the right half. At the end it should be the other way round": each in the place
of the other one."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, In, Loc, Manner, Meaning, Noun, Pronoun, replace


def other_way_round(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, with what is told of two things before such a clause told of each other at the end."""
    said = [(n, k) for n, chain in enumerate(chains) for k in range(len(chain.clauses))]
    for at in range(2, len(said)):
        (n, k), facts = said[at], said[at - 2 : at]
        turned = chains[n].clauses[k]
        told = [chains[m].clauses[j] for m, j in facts]
        places = [_placed(fact) for fact in told]
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


def _turns(clause: Clause) -> bool:
    """Whether nothing is said but that something is the other way round."""
    manners = [x.kind for x in clause.adjuncts if isinstance(x, Manner)]
    whole = isinstance(clause.theme, Pronoun) and clause.theme.word in ("it", "they", "them", "that", "everything")
    bare = (clause.verb, clause.mode, clause.negated) == ("be", "goal", False) and len(manners) == len(clause.adjuncts)
    return whole and bare and "backwards" in manners and {*manners} <= {"backwards", "finally"}


def _placed(fact: Meaning) -> Meaning | None:
    """The place of a single thing."""
    if not isinstance(fact, Clause) or fact.negated or len(fact.adjuncts) != 1 or not isinstance(fact.theme, Noun):
        return None
    told = fact.mode in ("start", "given") or (fact.lemma, fact.mode) == ("fact", "goal")
    place = fact.adjuncts[0]
    return place if told and isinstance(place, In | Loc) and not place.negated else None


def _alike(one: Meaning | None, other: Meaning | None) -> bool:
    """Whether two things may change these places: halves or corners of the table, patches."""
    if isinstance(one, In) and isinstance(other, In):
        return one.region != other.region
    if not isinstance(one, Loc) or not isinstance(other, Loc) or (one.rel, other.rel) != ("on", "on"):
        return False
    marks = [x for x in (one.landmark, other.landmark) if isinstance(x, Noun) and x.head == "patch"]
    return len(marks) == 2 and marks[0].traits != marks[1].traits


def _ends_at(turned: Clause, fact: Meaning, place: Meaning | None) -> Clause:
    assert isinstance(fact, Clause) and isinstance(place, In | Loc)
    if isinstance(place, Loc) and isinstance(place.landmark, Noun):
        place = replace(place, landmark=_known(place.landmark))
    theme = _known(fact.theme) if isinstance(fact.theme, Noun) else fact.theme
    last = tuple(x for x in turned.adjuncts if isinstance(x, Manner) and x.kind == "finally")
    return replace(turned, theme=theme, adjuncts=(replace(place, span=turned.adjuncts[0].span), *last))


def _known(noun: Noun) -> Noun:
    return replace(noun, det="the", amount=None) if noun.det == "a" else noun


def _begun(chains: tuple[Chain, ...], facts: list[tuple[int, int]]) -> tuple[Chain, ...]:
    """The sentences with these facts told of the start."""
    for n, k in facts:
        fact = chains[n].clauses[k]
        if isinstance(fact, Clause) and fact.mode == "goal":
            clauses = tuple(replace(fact, mode="start") if c is fact else c for c in chains[n].clauses)
            chains = (*chains[:n], replace(chains[n], clauses=clauses), *chains[n + 1 :])
    return chains
