"""What is told of what there is behind a command: where it is at the end, if it is about what the command makes; which
blocks there are, if it is how they start."""

from __future__ import annotations

from typing import TypeGuard

from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    TableTop,
    Toward,
    Traits,
    parts_of,
    replace,
)


def there_on_it(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "Clear the mat. There are two red blocks on it": said behind what is cleared this is a fact, like "two red
    blocks are on it", and not what is told before everything else. "Build a row. There is a blue block behind the row"
    is about the end, where the row is."""
    asked, found = False, []
    kinds: set[str] = set()
    for chain in chains:
        clauses: list[Meaning] = []
        for c in chain.clauses:
            now = [a for a in c.adjuncts if getattr(a, "kind", "") == "start"] if isinstance(c, Clause) else []
            given = isinstance(c, Clause) and (c.verb, c.mode) == ("exist", "given")
            if now and isinstance(c, Clause) and asked and given:
                c = replace(c, adjuncts=tuple(a for a in c.adjuncts if a not in now))
            marks = [getattr(a, "landmark", None) for a in c.adjuncts] if there_is(c) and isinstance(c, Clause) else []
            there = asked and any(isinstance(mark, Pronoun) for mark in marks) and _lying_on_it(c)
            built = any(not kinds.isdisjoint(_called(mark)) for mark in marks)
            if (there or built) and isinstance(c, Clause):
                c = replace(c, verb="be", lemma="fact" if there else "", mode="start" if now else "goal")
            clauses.append(c)
            asked = asked or (isinstance(c, Clause) and c.verb == "remove")
            kinds |= _asked_for(c)
        found.append(replace(chain, clauses=tuple(clauses)))
    return tuple(found)


def standing_there(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "A tower of red on blue stands there; take it apart": as much as "there is a tower", before a command."""
    said = [c for chain in chains for c in chain.clauses]
    last = max((n for n, c in enumerate(said) if isinstance(c, Clause) and c.mode == "command"), default=0)
    told = [replace(c, verb="exist", lemma="", mode="given", adjuncts=()) if n < last and _bare_there(c) else c
            for n, c in enumerate(said)]  # fmt: skip
    if told == said:
        return chains
    rest = iter(told)
    return tuple(replace(chain, clauses=tuple(next(rest) for _ in chain.clauses)) for chain in chains)


def _bare_there(clause: Meaning) -> TypeGuard[Clause]:
    """ "A tower stands there", "... on the table", and no more of where it is."""
    if not isinstance(clause, Clause) or (clause.verb, clause.lemma, clause.mode) != ("be", "fact", "goal"):
        return False
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if clause.negated or not isinstance(place, Loc) or place.rel != "on" or place.negated:
        return False
    there = isinstance(place.landmark, TableTop) or getattr(place.landmark, "word", "") == "there"
    return there and isinstance(clause.theme, Structure) and clause.theme.det == "a"


def _lying_on_it(clause: Meaning) -> bool:
    """Whether it may be what is cleared away: what is beside the mat is no part of that."""
    return isinstance(clause, Clause) and all(getattr(a, "rel", "") in ("on", "in") for a in clause.adjuncts)


def _called(mark: Meaning | None) -> tuple[str, ...]:
    """What "the tower", "the L" may be built as."""
    if isinstance(mark, Structure) and mark.det == "the":
        return (mark.kind,)
    return mark.traits.labels if isinstance(mark, Noun) and mark.det == "the" else ()


def _asked_for(clause: Meaning) -> set[str]:
    """The kinds of structures that a command builds: what is said to be beside them is so at the end."""
    if not isinstance(clause, Clause) or clause.mode not in ("command", "goal") or clause.negated:
        return set()
    shapes = {x.kind for x in parts_of(clause) if isinstance(x, Structure) and x.det != "the"}
    return shapes | {"stack"} if clause.verb == "stack" else shapes


def there_is(clause: Meaning) -> TypeGuard[Clause]:
    """ "there is ...", with nothing but places."""
    said = isinstance(clause, Clause) and clause.verb == "exist" and clause.mode == "given" and not clause.lemma
    return said and isinstance(clause, Clause) and all(isinstance(a, Loc | In) for a in clause.adjuncts)


def there_so(clause: Meaning) -> bool:
    """ "there is a row of A, B and C from left to right", "there are three blocks in a row": how a structure stands."""
    said = isinstance(clause, Clause) and (clause.verb, clause.mode, clause.lemma) == ("exist", "given", "")
    if not said or not isinstance(clause, Clause) or clause.negated:
        return False
    return all(isinstance(a, Loc | In | Into | At | Toward | OrderBy | Absolute) for a in clause.adjuncts)


def they_begin_as(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "All blocks must be on the table. They start as a tower of four green ones.": this says which blocks there are,
    where no other sentence names any besides these."""
    for n, chain in enumerate(chains):
        shape = _begun_as(chain.clauses[0]) if len(chain.clauses) == 1 else None
        if shape is None:
            continue
        own = _looks(shape)
        others = [x for other in (*chains[:n], *chains[n + 1 :]) for x in parts_of(other) if isinstance(x, Noun)]
        counted = any(x.amount is not None and x.head != "patch" for x in others)
        if own and not counted and all(_looks(x) <= own for x in others if x.head != "patch"):
            there = Clause(verb="exist", lemma="begun", theme=shape, mode="given", span=chain.span)
            chains = (*chains[:n], replace(chain, clauses=(there,)), *chains[n + 1 :])
    return chains


def _begun_as(clause: Meaning) -> Structure | None:
    """What it is that the blocks start as, whichever these are."""
    if not isinstance(clause, Clause) or clause.mode != "start" or clause.verb != "be" or len(clause.adjuncts) != 1:
        return None
    theme, into = clause.theme, clause.adjuncts[0]
    all_ = isinstance(theme, Pronoun) and theme.word in ("they", "everything")
    if isinstance(theme, Noun):
        plain = (theme.head, theme.traits, theme.amount, theme.part_of) == ("block", Traits(), None, None)
        all_ = plain and theme.plural and theme.det in ("all", "the")
    shape = into.structure if isinstance(into, Into) and all_ else None
    return shape if isinstance(shape, Structure) and shape.members is not None else None


def _looks(meaning: Meaning) -> set[str]:
    """The colours and symbols that are named."""
    named = [x.traits for x in parts_of(meaning) if isinstance(x, Noun)]
    return {look for traits in named for look in (*traits.colors, *traits.labels)}
