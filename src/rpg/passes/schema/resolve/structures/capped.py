""" "Make a 2x2 square of red blocks and put a blue one on top in the center": a pyramid of four and one."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Chain,
    Clause,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Size,
    Structure,
    Traits,
    Using,
    replace,
)

_BUILT = frozenset({"build", "arrange"})
_FOUR = Amount(4, 4)


def capped(chain: Chain) -> Chain:
    """The sentence with such a pyramid for a square of four that carries a block in its middle."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, said in zip(chain.links, chain.clauses, strict=True):
        before = clauses[-1] if clauses else None
        whole = _with_cap(before, said) if isinstance(before, Clause) and isinstance(said, Clause) else None
        if whole is not None and link in ("and", "then"):
            clauses[-1] = whole
        else:
            clauses.append(_in_one(said) if isinstance(said, Clause) else said)
            links.append(link)
    return replace(chain, clauses=tuple(clauses), links=tuple(links))


def _with_cap(base: Clause, cap: Clause) -> Clause | None:
    """Both clauses in one, where the second puts one block on the middle of the square of the first."""
    sides = {getattr(x, "side", getattr(x, "region", "")) for x in cap.adjuncts}
    placed = all(isinstance(x, At | In) for x in cap.adjuncts) and len(cap.adjuncts) == 2
    over = len(cap.adjuncts) == 1 and _across(cap.adjuncts[0])
    if cap.verb not in ("place", "be", "stack") or cap.negated or not (over or (placed and sides == {"top", "middle"})):
        return None
    base = _built_of(base)
    return _pyramid(base, cap.theme) if not base.negated and base.verb in _BUILT else None


def _built_of(base: Clause) -> Clause:
    """ "Arrange four red blocks in a square": a square of these."""
    into = base.adjuncts[0] if len(base.adjuncts) == 1 else None
    shape = into.structure if isinstance(into, Into) else None
    if base.verb not in ("arrange", "place") or not isinstance(shape, Structure) or not isinstance(base.theme, Noun):
        return base
    counted = base.theme.det == "bare" and base.theme.amount is not None and shape.members is None
    return replace(base, verb="build", theme=replace(shape, members=base.theme), adjuncts=()) if counted else base


def _in_one(said: Clause) -> Clause:
    """ "A 2x2 square of red blocks with a blue block on top in the middle"."""
    shape = said.theme
    parts = [x for x in shape.details if isinstance(x, Absolute)] if isinstance(shape, Structure) else []
    middle = [x for x in said.adjuncts if isinstance(x, At) and x.side == "middle"]
    over = len(parts) == 1 and not middle and len(parts[0].adjuncts) == 1 and _across(parts[0].adjuncts[0])
    if not isinstance(shape, Structure) or len(parts) != 1 or not (over or (len(middle) == 1 and _on_top(parts[0]))):
        return said
    rest = tuple(x for x in said.adjuncts if x not in middle)
    details = tuple(x for x in shape.details if x is not parts[0])
    whole = _pyramid(replace(said, theme=replace(shape, details=details), adjuncts=rest), parts[0].theme)
    return whole or said


def _across(place: Meaning) -> bool:
    """ "(Put a blue one) on all four of them", "centred on top of them"."""
    return isinstance(place, Loc) and "across" in place.mods and isinstance(place.landmark, Pronoun)


def _on_top(part: Absolute) -> bool:
    place = part.adjuncts[0] if len(part.adjuncts) == 1 else None
    return isinstance(place, At) and place.side == "top"


def _pyramid(base: Clause, cap: Meaning | None) -> Clause | None:
    """The clause that builds a pyramid of the square and what lies on it; None where it is no square of four."""
    shape = base.theme
    usings = [x for x in base.adjuncts if isinstance(x, Using)]
    if not isinstance(shape, Structure) or shape.kind not in ("square", "grid") or shape.plural or len(usings) > 1:
        return None
    blocks = shape.members or (usings[0].members if usings else None)
    four = shape.dims == (2, 2) or (isinstance(blocks, Noun) and blocks.amount == _FOUR) or shape.size == _FOUR
    if not four or shape.details or not (blocks is None or isinstance(blocks, Noun)):
        return None
    size = Size(what="base", dims=(2, 2), span=shape.span)
    plain = blocks is None or blocks.traits == Traits()
    whole = replace(shape, kind="pyramid", dims=(), sizes=(size,), members=None if plain else blocks)
    if isinstance(cap, Noun) and cap.traits.colors and cap.amount in (None, Amount(1, 1)) and not cap.plural:
        top = Absolute(theme=cap, adjuncts=(At(side="top", span=cap.span),), span=cap.span)
        whole = replace(whole, details=(top,))
    elif not plain or not _one_more(cap):
        return None
    rest = tuple(x for x in base.adjuncts if x not in usings)
    return replace(base, theme=whole, adjuncts=rest)


def _one_more(cap: Meaning | None) -> bool:
    """ "The fifth one", "one", "another block": the block besides the four."""
    if isinstance(cap, Pronoun):
        return cap.word in ("one", "another")
    single = isinstance(cap, Noun) and cap.amount in (None, Amount(1, 1)) and not cap.plural
    return single and isinstance(cap, Noun) and cap.traits in (Traits(), Traits(rank="5"), Traits(rank="last"))
