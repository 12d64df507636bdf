""" "The blue block is on the red one. Uncover the red one.": what is taken off it is the block that was told to be on
it, and no other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rpg.language.meaning import Amount, Chain, Clause, Loc, Meaning, Noun, Traits, replace

_UPON = ("on", "above")


def uncovered(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, with the block that is known to be there for "a block" that is taken off something."""
    found: list[Chain] = []
    known: list[tuple[Noun, Noun]] = []
    for chain in chains:
        clauses: list[Meaning] = []
        for said in chain.clauses:
            clauses.append(_off_which(said, known) if known and isinstance(said, Clause) else said)
            known += _on_what(said)
        found.append(replace(chain, clauses=tuple(clauses)) if tuple(clauses) != chain.clauses else chain)
    return tuple(found)


def _on_what(said: Meaning) -> Iterator[tuple[Noun, Noun]]:
    """What is told to be on, or under, what."""
    if not isinstance(said, Clause) or said.verb != "be" or said.negated:
        return
    for place in said.adjuncts:
        if not isinstance(place, Loc) or place.negated or not (_one(said.theme) and _one(place.landmark)):
            continue
        assert isinstance(said.theme, Noun) and isinstance(place.landmark, Noun)
        if place.rel in _UPON:
            yield said.theme, place.landmark
        elif place.rel == "under":
            yield place.landmark, said.theme


def _off_which(said: Clause, known: Sequence[tuple[Noun, Noun]]) -> Clause:
    place = said.adjuncts[0] if len(said.adjuncts) == 1 else None
    some = isinstance(said.theme, Noun) and (said.theme.head, said.theme.det, said.theme.amount, said.theme.traits) == (
        "block", "a", Amount(1, 1), Traits())  # fmt: skip
    if said.verb != "use" or not some or not isinstance(place, Loc) or place.rel != "off" or said.negated:
        return said
    mark = place.landmark
    upon = [top for top, below in known if isinstance(mark, Noun) and below.traits == mark.traits]
    if len(upon) != 1 or said.theme is None:
        return said
    return replace(said, theme=replace(upon[0], det="the", amount=None, span=said.theme.span))


def _one(meaning: Meaning | None) -> bool:
    return isinstance(meaning, Noun) and meaning.head != "patch" and not meaning.plural and bool(meaning.traits.colors)
