""" "There is a row of red and blue. Put a yellow block at its left end": the row is there at the start, and is to be
longer."""

from __future__ import annotations

import re

from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    PartOf,
    Places,
    Structure,
    Toward,
    Traits,
    parts_of,
    replace,
)

_LINES = ("row", "line", "column")
_END = re.compile(r"\bends?\b", re.IGNORECASE)


def then_longer(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences, with a line that is there told of the start, and with what is put at its ends told again."""
    for n, chain in enumerate(chains):
        within = [(n, k) for k in range(len(chain.clauses))]
        after = [(n + 1, k) for c in chains[n + 1 : n + 2] for k in range(len(c.clauses))]
        lines = [k for _, k in within if _line(chain.clauses[k]) is not None]
        at = [*within[lines[0] + 1 :], *after] if len(lines) == 1 else []
        here = [place for place in at if place[0] == n] or at
        clauses = [chains[m].clauses[k] for m, k in here]
        parts = [_at_an_end(c, text) for c in clauses]
        line = chain.clauses[lines[0]] if lines else None
        if not parts or not isinstance(line, Clause) or not _further(parts, (*chains[:n], line)):
            continue
        if _one_for_two_ends(line, parts):
            continue
        begun = line if line.mode in ("given", "start") else replace(line, mode="start")
        longer = replace(_longer(line, parts), span=clauses[0].span, word=getattr(clauses[0], "word", None))
        last = here[0][0]
        kept, links = chain.clauses[: lines[0]], chain.links[: lines[0] + 1]
        if last == n:
            told = replace(chain, clauses=(*kept, begun, longer), links=(*links, "and"))
            return (*chains[:n], told, *chains[n + 1 :])
        told = replace(chain, clauses=(*kept, begun), links=links)
        done = replace(chains[last], clauses=(longer,), links=chains[last].links[:1])
        return (*chains[:n], told, done, *chains[last + 1 :])
    return chains


def _line(line: Meaning) -> Structure | None:
    """The one line that is said to be there, with its blocks."""
    if not isinstance(line, Clause) or line.negated:
        return None
    there = (line.verb, line.mode) == ("exist", "given") or (line.verb, line.lemma) == ("be", "fact")
    into = next((x.structure for x in line.adjuncts if isinstance(x, Into)), None)
    shape = line.theme if isinstance(line.theme, Structure) else into
    if not there or not isinstance(shape, Structure) or shape.kind not in _LINES or shape.plural or shape.det != "a":
        return None
    told = all(isinstance(x, Toward | OrderBy | Into) for x in line.adjuncts)
    members = shape.members if shape is line.theme else line.theme
    return replace(shape, members=members) if told and (members or shape.details) and not shape.sizes else None


def _at_an_end(clause: Meaning, text: str) -> Absolute | None:
    """A block that is put at an end, or should be there."""
    if not isinstance(clause, Clause) or clause.negated or len(clause.adjuncts) != 1 or clause.lemma == "fact":
        return None
    place = clause.adjuncts[0]
    if clause.verb == "part" and clause.theme is None and isinstance(place, Absolute) and len(place.adjuncts) == 1:
        at = place.adjuncts[0]
        return place if isinstance(at, Places) and (at.side, at.unit) == ("ends", "block") else None
    if isinstance(place, Loc) and isinstance(place.landmark, PartOf) and place.rel in ("in", "on", "at"):
        place = At(side=place.landmark.part, span=place.span)
    asked = clause.mode == "command" or clause.mode == "goal"
    end = isinstance(place, At) and place.index is None and _END.search(text[slice(*clause.span)]) is not None
    if not asked or not end or clause.verb not in ("place", "be") or not isinstance(clause.theme, Noun):
        return None
    return Absolute(theme=clause.theme, adjuncts=(place,), span=clause.span)


def _further(parts: list[Absolute | None], before: tuple[Meaning, ...]) -> bool:
    """Whether what is put at the ends are single blocks that nobody spoke of before."""
    known = {look for told in before for x in parts_of(told) if isinstance(x, Noun) for look in _looks(x)}
    themes = [x.theme for x in parts if x is not None]
    single = [isinstance(x, Noun) and x.det in ("a", "the", "bare") and not x.plural and _looks(x) for x in themes]
    return len(themes) == len(parts) and all(single) and known.isdisjoint(y for x in themes for y in _looks(x))


def _one_for_two_ends(line: Clause, parts: list[Absolute | None]) -> bool:
    """ "A, B and C are in a row. Put a red block at either end": one block, beside single ones, for both of them."""
    shape = _line(line)
    both = any(x is not None and getattr(x.adjuncts[0], "side", "") == "ends" for x in parts)
    return both and shape is not None and bool(_listed(shape.members))


def _looks(noun: Meaning) -> tuple[str, ...]:
    return (*noun.traits.colors, *noun.traits.labels) if isinstance(noun, Noun) else ()


def _longer(line: Clause, parts: list[Absolute | None]) -> Clause:
    """The line with further blocks: at the ends of a list that tells an order, else told of the ends."""
    shape = _line(line)
    assert shape is not None
    orders = [x for x in line.adjuncts if isinstance(x, Toward | OrderBy)]
    more = [replace(x, theme=_new(x.theme)) for x in parts if x is not None]
    items = _listed(shape.members)
    listed = next((x for x in (*shape.details, *orders) if isinstance(x, OrderBy)), None)
    bare = Structure(kind=shape.kind, det="a", amount=shape.amount, span=shape.span)
    if listed is not None:
        first = listed.first or ("left" if shape.kind != "column" else "front")
        sides = [getattr(x.adjuncts[0], "side", "") for x in more]
        ahead = [x.theme for x, side in zip(more, sides, strict=True) if side in (first, "ends")]
        behind = [x.theme for x, side in zip(more, sides, strict=True) if side != first]
        order = replace(listed, items=(*ahead, *listed.items, *behind), first=first)
        return Clause(verb="build", theme=bare, adjuncts=(order,), mode="goal", span=shape.span)
    if items and not orders:  # in any order, but for the ends
        named = Coord(op="and", items=(*items, *(x.theme for x in more)), span=shape.span)
        built, told = replace(bare, members=named), tuple(replace(x, theme=_as_named(x.theme)) for x in more)
    else:
        of = Coord(op="and", items=items, span=shape.span) if items else _known(shape.members)
        built, told = replace(shape, members=of), tuple(more)
    return Clause(verb="build", theme=built, adjuncts=(*orders, *told), mode="goal", span=shape.span)


def _listed(members: Meaning | None) -> tuple[Meaning, ...]:
    """Single blocks, each by its look: "red, blue and green"; none where they are counted."""
    nouns = members.items if isinstance(members, Coord) else (members,) if members is not None else ()
    if not all(isinstance(x, Noun) and x.amount in (None, Amount(1, 1)) for x in nouns):
        return ()
    looks = [(x, look) for x in nouns for look in _looks(x)]
    return tuple(_one(x, look) for x, look in looks) if len(looks) > 1 else ()


def _one(noun: Meaning, look: str) -> Noun:
    traits = Traits(labels=(look,)) if look in getattr(noun, "traits", Traits()).labels else Traits(colors=(look,))
    return Noun(head="any", det="bare", traits=traits, span=noun.span)


def _known(members: Meaning | None) -> Meaning | None:
    """The blocks of the line, which were spoken of: "the three red blocks"."""
    return replace(members, det="the") if isinstance(members, Noun) and members.det == "bare" else members


def _as_named(theme: Meaning) -> Meaning:
    return replace(theme, det="the", amount=None) if isinstance(theme, Noun) and theme.det == "a" else theme


def _new(theme: Meaning) -> Meaning:
    return replace(theme, det="a", amount=Amount(1, 1)) if isinstance(theme, Noun) and theme.det == "the" else theme
