""" "A near B or near C, and D near both": the two that "both" and "neither" stand for are told as one place."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Coord, Loc, Meaning, Noun, Pronoun, parts_of, replace

_OF_TWO = ("both", "both of them", "neither of them")


def marks_joined(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, with "near B or near C" as "near B or C" where both of these are spoken of."""
    if not any(_of_two(part) for chain in chains for part in parts_of(chain)):
        return chains
    return tuple(_joined(chain) for chain in chains)


def _of_two(part: Meaning) -> bool:
    if isinstance(part, Noun):
        return part.det in ("both", "no") and isinstance(part.part_of, Pronoun)
    return isinstance(part, Pronoun) and part.word in _OF_TWO


def _joined(chain: Chain) -> Chain:
    told: list[tuple[str, Meaning]] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        one = _in_one(told[-1][1], clause) if told and link == "or" else None
        told = [*told, (link, clause)] if one is None else [*told[:-1], (told[-1][0], one)]
    return replace(chain, clauses=tuple(c for _, c in told), links=tuple(link for link, _ in told))


def _in_one(before: Meaning, after: Meaning) -> Clause | None:
    """Both of two places of the same block, where they differ in nothing but the landmark; else None."""
    if not isinstance(before, Clause) or not isinstance(after, Clause) or before.negated or after.negated:
        return None
    same = isinstance(after.theme, Pronoun) and after.theme.word == "same"
    if not same or (before.verb, len(before.adjuncts), len(after.adjuncts)) != (after.verb, 1, 1):
        return None
    one, other = before.adjuncts[0], after.adjuncts[0]
    if not isinstance(one, Loc) or not isinstance(other, Loc) or one.negated or other.negated:
        return None
    marks = one.landmark, other.landmark
    if not isinstance(marks[0], Noun) or not isinstance(marks[1], Noun):
        return None
    if replace(one, landmark=None, span=(0, 0), cost=0) != replace(other, landmark=None, span=(0, 0), cost=0):
        return None
    either = Coord(op="or", items=(marks[0], marks[1]), span=(marks[0].span[0], marks[1].span[1]))
    return replace(before, adjuncts=(replace(one, landmark=either),), span=(before.span[0], after.span[1]))
