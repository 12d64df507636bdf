"""What is to stay where it was told to be: "blue is on the mat and must never leave it" tells of the start."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from rpg.language.meaning import Amount, Chain, Clause, Coord, In, Loc, Manner, Meaning, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.clauses.begun_facts import wanted
from rpg.passes.schema.resolve.clauses.joined_facts import orders_something, same_one


def kept_there(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences, with "there" and "it" as the places that were told just before, which are so from the start."""
    lots = [c for chain in chains for c in chain.clauses if _several_there(c)]
    told = [[_left(_from_the_start(c, text), lots) for c in chain.clauses] for chain in chains]
    at = [(n, k) for n, clauses in enumerate(told) for k in range(len(clauses))]
    for (n, k), (m, j) in itertools.pairwise(at):
        fact, kept = told[n][k], told[m][j]
        if not _tells(fact) or not isinstance(fact, Clause) or not _lasts(kept) or not isinstance(kept, Clause):
            continue
        if chains[m].links[j] != "and" or not same_one(fact, kept):
            continue
        elsewhere = any(orders_something(chain) for chain in (*chains[:n], *chains[m + 1 :]))
        if (stays := _as_told(fact, kept, text)) is not None:
            told[m][j] = replace(kept, adjuncts=stays)
        elif not ((kept.negated or _unmoved(kept)) and elsewhere):
            continue
        told[n][k] = fact if fact.mode == "given" else replace(fact, mode="start")
    return tuple(
        chain if list(chain.clauses) == clauses else replace(chain, clauses=tuple(clauses))
        for chain, clauses in zip(chains, told, strict=True)
    )


def _tells(fact: Meaning) -> bool:
    """Whether a clause says of a single thing where it is, or is at the start."""
    if not isinstance(fact, Clause) or fact.negated or not isinstance(fact.theme, Noun):
        return False
    begun = fact.verb == "be" and (fact.mode == "start" or (fact.lemma, fact.mode) == ("fact", "goal"))
    begun = begun or (fact.verb, fact.lemma, fact.mode) == ("exist", "", "given")
    return begun and len(_places(fact.adjuncts)) == 1


def _from_the_start(clause: Meaning, text: str) -> Meaning:
    """ "must be on the mat from the start": not only then."""
    if not isinstance(clause, Clause) or not wanted(clause):
        return clause
    told = (
        replace(x, kind="always") if isinstance(x, Manner) and text[slice(*x.span)].lower()[:4] == "from" else x
        for x in clause.adjuncts
    )
    return replace(clause, adjuncts=tuple(told))


def _lasts(kept: Meaning) -> bool:
    said = isinstance(kept, Clause) and (kept.verb, kept.mode) == ("be", "goal")
    return _unmoved(kept) or (said and isinstance(kept, Clause) and any(map(_always, kept.adjuncts)))


def _unmoved(kept: Meaning) -> bool:
    """ "must not be moved", "must not be touched", "must stay where it is"."""
    if not isinstance(kept, Clause) or kept.mode not in ("goal", "command"):
        return False
    stays = not kept.negated and any(isinstance(x, Manner) and x.kind == "stay" for x in kept.adjuncts)
    still = kept.negated and kept.verb in ("place", "touch", "pick") and not any(map(_somewhere, kept.adjuncts))
    return stays or still


def _somewhere(part: Meaning) -> bool:
    return isinstance(part, Loc | In)


def _always(part: Meaning) -> bool:
    return isinstance(part, Manner) and part.kind == "always"


def _places(adjuncts: Sequence[Meaning]) -> list[Meaning]:
    return [x for x in adjuncts if isinstance(x, Loc | In)]


def _as_told(fact: Clause, kept: Clause, text: str) -> tuple[Meaning, ...] | None:
    """What is said of what stays, with the place that it stays at; None where that is another one."""
    place = _places(fact.adjuncts)[0]
    there = [x for x in kept.adjuncts if _there(x, place, text)]
    others = [x for x in kept.adjuncts if x not in there and not _always(x)]
    if len(there) != 1 or others or kept.negated:
        return None
    if isinstance(place, Loc) and isinstance(mark := place.landmark, Noun) and mark.det == "a":
        place = replace(place, landmark=replace(mark, det="the", amount=None))
    return tuple(replace(place, span=x.span) if x is there[0] else x for x in kept.adjuncts)


def _there(part: Meaning, place: Meaning, text: str) -> bool:
    """ "there", "on it", "in that half", behind a place."""
    if isinstance(part, Manner):
        told = text[slice(*part.span)].lower().split()
        return part.kind == "idle" and (told[-1] == "there" or told[-2:-1] in (["that"], ["this"]))
    if not isinstance(part, Loc) or part.negated:
        return False
    mark, known = part.landmark, place.landmark if isinstance(place, Loc) else None
    if isinstance(mark, Pronoun):
        return mark.word == "there" or (mark.word == "it" and isinstance(place, Loc) and part.rel == place.rel)
    same = (
        isinstance(mark, Noun) and isinstance(known, Noun) and mark.head == known.head and mark.det in ("the", "bare")
    )
    named = same and isinstance(mark, Noun) and isinstance(known, Noun) and mark.traits in (known.traits, Traits())
    return named and isinstance(place, Loc) and part.rel == place.rel


def _several_there(fact: Meaning) -> bool:
    """ "All three red blocks start on the mat"."""
    said = isinstance(fact, Clause) and fact.mode in ("start", "given") and bool(_places(fact.adjuncts))
    return said and isinstance(fact, Clause) and isinstance(fact.theme, Noun) and fact.theme.plural


def _left(clause: Meaning, lots: Sequence[Meaning]) -> Meaning:
    """ "(All three start on the mat;) at the end only one may still be on it": one of them."""
    if len(lots) != 1 or not isinstance(clause, Clause) or clause.mode != "goal" or clause.negated:
        return clause
    theme = clause.theme
    one = theme.items[0] if isinstance(theme, Coord) and theme.op == "only" and len(theme.items) == 1 else theme
    bare = isinstance(one, Noun) and (one.head, one.traits, one.det) == ("any", Traits(), "bare") and not one.plural
    alone = bare and isinstance(one, Noun) and one.amount in (None, Amount(1, 1, True)) and one is not theme
    alone = alone or (bare and isinstance(one, Noun) and one.amount == Amount(1, 1, True))
    if not alone or clause.verb not in ("be", "exist") or not _places(clause.adjuncts) or theme is None:
        return clause
    them = Pronoun(word="them", span=theme.span)
    some = Noun(head="any", det="some", amount=Amount(1, 1, True), plural=True, part_of=them, span=theme.span)
    kept = tuple(x for x in clause.adjuncts if not (isinstance(x, Manner) and x.kind == "allowed"))
    return replace(clause, verb="be", lemma="", theme=some, adjuncts=kept)
