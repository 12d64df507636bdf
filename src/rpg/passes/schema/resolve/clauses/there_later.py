"""What is told by "there is" behind a command: where something is at the end, if it is about what the command makes."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeGuard

from rpg.language.meaning import Chain, Clause, In, Loc, Meaning, Noun, Pronoun, Structure, parts_of


def there_on_it(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "Clear the mat. There are two red blocks on it": said behind what is cleared this is a fact, like "two red
    blocks are on it", and not what is told before everything else. "Build a row. There is a blue block behind the row"
    is about the end, where the row is."""
    asked, found = False, []
    kinds: set[str] = set()
    for chain in chains:
        clauses: list[Meaning] = []
        for c in chain.clauses:
            marks = [getattr(a, "landmark", None) for a in c.adjuncts] if there_is(c) and isinstance(c, Clause) else []
            there = asked and any(isinstance(mark, Pronoun) for mark in marks) and _lying_on_it(c)
            built = any(not kinds.isdisjoint(_called(mark)) for mark in marks)
            if (there or built) and isinstance(c, Clause):
                c = replace(c, verb="be", lemma="fact" if there else "", mode="goal")
            clauses.append(c)
            asked = asked or (isinstance(c, Clause) and c.verb == "remove")
            kinds |= _asked_for(c)
        found.append(replace(chain, clauses=tuple(clauses)))
    return tuple(found)


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
