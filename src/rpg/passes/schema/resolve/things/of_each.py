"""How many of each there are, said behind a list: "red and blue in a row, two of each", "..., three red, two blue"."""

from __future__ import annotations

from rpg.language.grammar.clauses.numbers_compared import COMPARED
from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Structure,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.counted import put


def each_later(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with such numbers where the colours or labels are listed."""
    found = list(chains)
    for n, chain in enumerate(chains):
        for at, clause in enumerate(chain.clauses):
            many = _of_each(clause)
            line, place = (n, at - 1) if at else (n - 1, -1)
            if many is None or line < 0:
                continue
            clauses = found[line].clauses
            if isinstance(many, dict):
                told = _counted(clauses[place], many) if {*many} == _listed(clauses[place]) else clauses[place]
                whole = tuple(told if x is clauses[place] else x for x in clauses)
                found[line] = replace(found[line], clauses=whole)
                continue
            alone = sum(len(x.clauses) for x in chains) == 2
            kinds = _some_of_each(chains, many) or (_quantified(clauses[place]) if alone else ())
            if kinds and isinstance(clause, Clause):
                items = tuple(_so_many(x, many) for x in kinds)
                there = replace(clause, theme=Coord(op="and", items=items, span=clause.span), adjuncts=())
                found[n] = replace(found[n], clauses=tuple(there if x is clause else x for x in found[n].clauses))
                continue
            told = _counted(clauses[place], many)
            whole = tuple(told if x is clauses[place] else x for x in clauses)
            found[line] = replace(found[line], clauses=whole)
    return tuple(found)


Many = int | dict[str, int]
"""How many there are of each, or of each colour."""


def _of_each(clause: Meaning) -> Many | None:
    """The number in "two of each", where no more is said; the numbers in "three red and two blue"."""
    if not isinstance(clause, Clause) or clause.lemma != "tally":
        return None
    if clause.theme is not None:
        items = clause.theme.items if isinstance(clause.theme, Coord) else (clause.theme,)
        told = [x for x in items if isinstance(x, Noun) and x.traits == Traits(colors=x.traits.colors[:1])]
        counts = {x.traits.colors[0]: x.amount.low for x in told if x.traits.colors and x.amount and x.det == "bare"}
        return counts if 1 < len(items) == len(counts) and not clause.adjuncts else None
    sizes = [z for z in clause.adjuncts if getattr(z, "what", "") == "each"]
    amount = getattr(sizes[0], "amount", None) if len(sizes) == len(clause.adjuncts) == 1 else None
    return int(amount.low) if amount is not None and amount.low == amount.high else None


def _listed(clause: Meaning) -> set[str]:
    """The colours that a clause lists as its theme."""
    theme = clause.theme if isinstance(clause, Clause) and clause.verb in ("arrange", "stack", "place") else None
    items = theme.items if isinstance(theme, Coord) else (theme,)
    return {color for x in items if isinstance(x, Noun) and x.amount is None for color in x.traits.colors}


def _quantified(clause: Meaning) -> tuple[Noun, ...]:
    """The kinds of "exactly one green block on a red block": what is said of so many of them tells no number."""
    place = clause.adjuncts[0] if isinstance(clause, Clause) and len(clause.adjuncts) == 1 else None
    theme = clause.theme if isinstance(clause, Clause) and clause.verb in ("be", "place") else None
    mark = place.landmark if isinstance(place, Loc) else None
    if not isinstance(theme, Noun) or not isinstance(mark, Noun) or mark.det != "a" or mark.head == "patch":
        return ()
    some = theme.det in ("each", "no", "any") or (theme.amount is not None and theme.amount.strict)
    some = some or (theme.amount is not None and theme.amount.low != theme.amount.high)
    kinds = tuple(replace(x, det="bare", amount=None, plural=False) for x in (theme, mark))
    alone = all(map(_single, kinds)) and theme.traits != mark.traits
    return kinds if some and alone else ()


def _some_of_each(chains: tuple[Chain, ...], many: int) -> tuple[Noun, ...]:
    """The kinds of "at least one red and one blue block on the mat": what is said of some of them tells no number."""
    told = [c for x in chains for c in x.clauses if isinstance(c, Clause) and c.verb in ("place", "be", COMPARED)]
    told = [c for c in told if c.mode in ("command", "goal") and c.theme is not None]
    nouns = [x for c in told for x in parts_of(c.theme) if isinstance(x, Noun) and x.head != "patch"]
    hued = [x for x in nouns if x.traits == Traits(colors=x.traits.colors[:1]) and x.traits.colors]
    some = any(x.amount is not None and x.amount.low < many for x in hued) or any(c.verb == COMPARED for c in told)
    places = [p for c in told for p in c.adjuncts if isinstance(p, Loc)]
    marks = [p.landmark for p in places if isinstance(p.landmark, Noun) and p.landmark.head == "block"]
    kinds = {x.traits: x for x in hued}
    if not some or len(hued) < len(nouns) or marks or len(kinds) < 2:
        return ()
    return tuple(Noun(head="block", traits=traits, span=x.span) for traits, x in kinds.items())


def _counted(clause: Meaning, many: Many) -> Meaning:
    """A clause with so many of each of the looks that it lists."""
    if not isinstance(clause, Clause) or clause.mode == "start" or (clause.mode == "given" and clause.verb != "exist"):
        return clause
    shape = clause.theme
    turns = [x for x in clause.adjuncts if isinstance(x, OrderBy) and x.by == "alternating"]
    if isinstance(shape, Structure) and shape.members is None and not shape.plural and not shape.sizes:
        turns += [x for x in shape.details if isinstance(x, OrderBy) and x.by == "alternating"]
        if (whole := _taking_turns(turns, many)) is not None and not shape.dims and not shape.traits.colors:
            return replace(clause, theme=replace(shape, members=whole))
    bare = isinstance(shape, Noun) and shape == Noun(head="block", det=shape.det, plural=True, span=shape.span)
    if bare and (whole := _taking_turns(turns, many)) is not None:
        return replace(clause, theme=whole)
    if clause.verb == "sort" and isinstance(shape, Noun) and (parted := _apart(clause, shape, many)) is not None:
        return parted
    listed = shape.members if isinstance(shape, Structure) and not shape.plural else shape
    if isinstance(listed, Noun) and len(listed.traits.labels) > 1 and listed.det == "bare" and listed.amount is None:
        one = replace(listed, plural=False)
        parts = tuple(replace(one, traits=replace(one.traits, labels=(x,))) for x in listed.traits.labels)
        if all(map(_single, parts)):
            items = tuple(_so_many(x, many) for x in parts)
            return replace(clause, theme=put(clause.theme, listed, Coord(op="and", items=items, span=listed.span)))
    if isinstance(listed, Noun) and _of_several_colors(listed):
        looks = [replace(listed.traits, colors=(color,)) for color in listed.traits.colors]
        items = tuple(_so_many(replace(listed, traits=look), many) for look in looks)
        return replace(clause, theme=put(clause.theme, listed, Coord(op="and", items=items, span=listed.span)))
    if isinstance(listed, Coord) and listed.op == "and" and all(map(_single, listed.items)):
        items = tuple(_so_many(x, many) for x in listed.items)
        return replace(clause, theme=put(clause.theme, listed, replace(listed, items=items)))
    return clause


def _apart(clause: Clause, theme: Noun, many: Many) -> Clause | None:
    """ "Separate red from blue", three of each."""
    other = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if not isinstance(other, Using) or other.lead != "from" or not _single(theme) or not _single(other.members):
        return None
    return replace(
        clause, theme=_so_many(theme, many), adjuncts=(replace(other, members=_so_many(other.members, many)),)
    )


def _taking_turns(turns: list[OrderBy], many: Many) -> Coord | None:
    """So many of each of the looks that alternate."""
    items = turns[0].items if len(turns) == 1 else ()
    if not items or not all(map(_single, items)):
        return None
    return Coord(op="and", items=tuple(_so_many(x, many) for x in items), span=turns[0].span)


def _of_several_colors(listed: Noun) -> bool:
    """ "red and blue blocks", of which nothing says how many they are."""
    plain = listed.det == "bare" and listed.amount is None and listed.part_of is None and not listed.conditions
    colors = listed.traits.colors
    return plain and listed.head != "patch" and len(set(colors)) == len(colors) > 1 and not listed.traits.either


def _single(item: Meaning) -> bool:
    """ "red", "A": one colour or label, and no number."""
    if not isinstance(item, Noun) or item.det != "bare" or item.amount is not None or item.head == "patch":
        return False
    marks, plain = item.traits, item.part_of is None and not item.conditions
    told = len(marks.colors) + len(marks.labels) == 1
    return plain and told and marks == Traits(colors=marks.colors, labels=marks.labels)


def _so_many(item: Meaning, many: Many) -> Meaning:
    if not isinstance(item, Noun):
        return item
    number = many if isinstance(many, int) else many[item.traits.colors[0]]
    return replace(item, head="block", amount=Amount(number, number), plural=number > 1)
