"""What is built like the structure told before it: "a row of A and B and the same row behind it", "there is a tower of
two red blocks; build the same tower from blue blocks"."""

from __future__ import annotations

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    In,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Structure,
    Traits,
    Using,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_THERE = ("start", "given")


def the_same_again(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with each such structure told in full."""
    if not any(_is_same(x) for chain in chains for c in chain.clauses for x in _themes(c)):
        return chains
    models: list[Clause] = []
    found: list[Chain] = []
    for chain in map(_apart, chains):
        clauses: list[Meaning] = []
        for said in chain.clauses:
            clauses.append(_told(said, models) if isinstance(said, Clause) else said)
            models += [replace(said, theme=x) for x in _themes(said) if isinstance(said, Clause) and _single(x)]
        found.append(replace(chain, clauses=tuple(clauses)))
    return tuple(found)


def _themes(said: Meaning) -> tuple[Meaning | None, ...]:
    theme = said.theme if isinstance(said, Clause) else None
    return theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)


def _is_same(theme: Meaning | None) -> bool:
    """ "The same tower", "the same tower of blue blocks"."""
    return isinstance(theme, Structure) and theme.det == "the" and theme.traits == Traits(scheme="same")


def _single(theme: Meaning | None) -> bool:
    """A structure of which it is told what it is, so that one can be like it."""
    return isinstance(theme, Structure) and theme.det in ("a", "another", "bare") and not theme.plural


def _apart(chain: Chain) -> Chain:
    """ "Build a row and the same row behind it": it is the second one that is behind the first."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, said in zip(chain.links, chain.clauses, strict=True):
        clauses.append(said)
        links.append(link)
        *first, last = _themes(said)
        if isinstance(said, Clause) and first and _is_same(last) and all(map(_single, first)):
            rest = replace(said.theme, items=tuple(first)) if isinstance(said.theme, Coord) and first[1:] else first[0]
            clauses[-1:] = [replace(said, theme=rest, adjuncts=()), replace(said, theme=last)]
            links.append("and")
    return replace(chain, clauses=tuple(clauses), links=tuple(links))


def _told(said: Clause, models: list[Clause]) -> Clause:
    """What a clause builds like the structure of one before it, told in full."""
    same = said.theme
    alike = [m for m in models if isinstance(same, Structure) and getattr(m.theme, "kind", "") == same.kind]
    if said.verb != "build" or said.negated or not isinstance(same, Structure) or not _is_same(same) or not alike:
        return said
    using = [a.members for a in said.adjuncts if isinstance(a, Using)]
    blocks = next(iter([x for x in (same.members, *using) if x is not None]), None)
    model, shape = alike[-1], alike[-1].theme
    if not isinstance(shape, Structure):
        return said
    if isinstance(blocks, Noun):
        return _of_other_blocks(said, [m.theme for m in alike if isinstance(m.theme, Structure)], blocks)
    there = model.verb == "exist" or model.mode in _THERE
    placed = any(isinstance(a, Loc | In) for a in said.adjuncts)
    if blocks is not None or there or not placed:
        return said
    if len({replace(m.theme, det="a", span=same.span) for m in alike if isinstance(m.theme, Structure)}) > 1:
        raise refuse("ambiguous", f"like which {shape.kind} before it?", same.span, "say what it is made of")
    own = tuple(a for a in model.adjuncts if not isinstance(a, Loc | In))
    again = replace(shape, det="another", amount=Amount(1, 1), span=same.span)
    return replace(said, theme=again, adjuncts=(*own, *said.adjuncts))


def _of_other_blocks(said: Clause, shapes: list[Structure], blocks: Noun) -> Clause:
    """ "The same tower from blue blocks": as many of these."""
    if blocks.amount is not None or blocks.det != "bare" or not blocks.plural:
        return said
    shape = shapes[-1]
    one_look = len(blocks.traits.colors) == 1 and not blocks.traits.labels and not blocks.conditions
    counted = isinstance(shape.members, Noun) and shape.members.amount is not None
    known = counted or (shape.members is None and bool(shape.sizes or shape.dims))
    listed = isinstance(shape.members, Coord) or any(isinstance(x, OrderBy) for x in shape.details)
    if not one_look or not known or listed or len({_numbers(x) for x in shapes}) > 1:
        raise refuse("ambiguous", "it is not clear which blocks this is built from", blocks.span,
                     "say how many of these there are, as in 'a tower of two blue blocks'")  # fmt: skip
    amount = shape.members.amount if isinstance(shape.members, Noun) else None
    again = replace(shape, det="another", members=replace(blocks, amount=amount), traits=Traits(), span=said.span)
    return replace(said, theme=again, adjuncts=tuple(a for a in said.adjuncts if not isinstance(a, Using)))


def _numbers(shape: Structure) -> tuple[object, ...]:
    """How many blocks are told to be in a structure, or how large it is."""
    own = shape.members.amount if isinstance(shape.members, Noun) else None
    return (own.low if own is not None else None, shape.dims, *(size.amount for size in shape.sizes))
