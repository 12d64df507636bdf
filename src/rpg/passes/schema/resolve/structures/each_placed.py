"""Where each of several towers stands, told one by one: "two towers, one on the green mat, one on the yellow one"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import (
    Absolute,
    Amount,
    Chain,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    Traits,
    parts_of,
    replace,
)

_ONES = frozenset({"one", "the other", "the other one", "another", "another one", "the second one", "one of them"})


def each_placed(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with "the first tower", "the second tower" for these."""
    if not any(isinstance(x, Structure) and x.plural for chain in chains for x in parts_of(chain)):
        return chains
    towers: Structure | None = None
    found: list[Chain] = []
    for chain in chains:
        clauses = list(chain.clauses)
        for n, said in enumerate(clauses):
            if not isinstance(said, Clause):
                continue
            clauses[n] = said = _one_on_each(said)
            if many := _several(said):
                towers = many
                clauses[n] = said = _with_places(said, many)
            count = towers.amount.low if towers is not None and towers.amount is not None else 0
            told = [x for x in clauses[n : n + count] if isinstance(x, Clause) and not x.negated]
            if towers is not None and len(told) == count and _each_told(told, count):
                clauses[n : n + count] = [
                    replace(x, theme=_nth(towers, k), adjuncts=(place,))
                    for k, (x, place) in enumerate(zip(told, _patches([x.adjuncts[0] for x in told]), strict=True))
                ]
        found.append(replace(chain, clauses=tuple(clauses)))
    return tuple(found)


def _one_on_each(said: Clause) -> Clause:
    """ "Build two towers of two, one on each patch": it is the towers that are on the patches."""
    items = said.theme.items if isinstance(said.theme, Coord) and said.theme.op == "and" else ()
    marks = [x.landmark for x in said.adjuncts if isinstance(x, Loc) and x.rel == "on" and not x.negated]
    each = any(isinstance(mark, Noun) and mark.head == "patch" and mark.det == "each" for mark in marks)
    if not each or len(items) != 2 or _word(items[1]) != "one":
        return said
    towers = items[0]
    if not isinstance(towers, Structure) or not towers.plural or towers.amount is None:
        return said
    return replace(said, theme=towers, adjuncts=tuple(_of_as_many(x, towers.amount) for x in said.adjuncts))


def _of_as_many(place: Meaning, amount: Amount) -> Meaning:
    """ "Each patch" where no more is said of the patches: there are as many as towers."""
    mark = place.landmark if isinstance(place, Loc) else None
    if not isinstance(place, Loc) or not isinstance(mark, Noun) or mark.part_of or mark.traits != Traits():
        return place
    those = Noun(head=mark.head, det="the", amount=amount, plural=True, span=mark.span)
    return replace(place, landmark=replace(mark, plural=True, part_of=those))


def _several(said: Clause) -> Structure | None:
    """The towers that a clause builds, where it tells of no others."""
    shapes = [x for x in parts_of(said) if isinstance(x, Structure)]
    one = shapes[0] if len(shapes) == 1 and not said.negated and said.mode not in ("start", "given") else None
    counted = one is not None and one.amount is not None and one.amount.low == one.amount.high
    return one if counted and one is not None and one.kind == "stack" and one.plural and one.det == "bare" else None


def _with_places(said: Clause, towers: Structure) -> Clause:
    """ "..., one on the green mat and one on the yellow one", told in the clause that builds them."""
    adjuncts: list[Meaning] = []
    for told in said.adjuncts:
        items = told.items if isinstance(told, Coord) and told.op == "absolutes" else ()
        count = towers.amount.low if towers.amount is not None else 0
        if len(items) == count and _each_told(items, count):
            parts = [x for x in items if isinstance(x, Absolute)]
            places = _patches([x.adjuncts[0] for x in parts])
            pairs = enumerate(zip(parts, places, strict=True))
            told = Coord(
                op="absolutes",
                items=tuple(replace(x, theme=_nth(towers, k), adjuncts=(place,)) for k, (x, place) in pairs),
                span=told.span,
            )
        adjuncts.append(told)
    return replace(said, adjuncts=tuple(adjuncts))


def _each_told(items: Sequence[Meaning], count: int) -> bool:
    """Whether of so many it is told one by one where they are."""
    told = [x for x in items if isinstance(x, Absolute | Clause)]
    words = [_word(x.theme) for x in told]
    placed = all(len(x.adjuncts) == 1 and isinstance(x.adjuncts[0], Loc) for x in told)
    return len(told) == count > 1 and placed and words[0] in ("one", "one of them") and _ONES.issuperset(words)


def _word(theme: Meaning | None) -> str:
    """ "one", which is a pronoun, or a noun of which no more is said."""
    if isinstance(theme, Pronoun):
        return theme.word
    bare = isinstance(theme, Noun) and not (theme.plural or theme.amount or theme.conditions or theme.part_of)
    plain = bare and isinstance(theme, Noun) and (theme.head, theme.det, theme.traits) == ("any", "bare", Traits())
    return "one" if plain else ""


def _patches(places: list[Meaning]) -> list[Meaning]:
    """ "One on the green and one on the yellow patch": the green patch, too."""
    marks = [x.landmark for x in places if isinstance(x, Loc) and x.rel == "on"]
    last = marks[-1] if len(marks) == len(places) else None
    if not isinstance(last, Noun) or last.head != "patch":
        return places
    found: list[Meaning] = []
    for place in places:
        mark = place.landmark if isinstance(place, Loc) else None
        bare = isinstance(mark, Noun) and mark.head == "any" and mark.det == "the" and bool(mark.traits.colors)
        patch = replace(mark, head="patch") if bare and isinstance(mark, Noun) else mark
        found.append(replace(place, landmark=patch) if isinstance(place, Loc) else place)
    return found


def _nth(towers: Structure, k: int) -> Structure:
    return Structure(kind="stack", det="the", traits=Traits(rank=str(k + 1)), span=towers.span)
