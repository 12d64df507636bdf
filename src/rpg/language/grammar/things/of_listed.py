"""The things of which it is "each", named one by one: "each of the red cube and the blue cube", "each of A and B"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.joined import more
from rpg.language.later import later
from rpg.language.meaning import Coord, Meaning, Noun, Traits, replace

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import simple
else:
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")


_WHOLE = ("each", "both", "no", "any", "all")


def wholes(p: Parser, i: int, det: str) -> Results[Meaning]:
    """What "some of", "each of", "none of" may be said of."""
    for found, j in (*simple(p, i), *listed(p, i, det)):
        if not _open(p, i, j):
            yield found, j


def listed(p: Parser, i: int, det: str) -> Results[Noun | Coord]:
    """Several named blocks as the ones that they are together: "each" of them, both, none or so many are meant."""
    yield from _of_several_kinds(p, i, det)
    if det not in _WHOLE:
        return
    for first, j in simple(p, i):
        if isinstance(first, Noun) and _bare(first) and _several(first) and not _goes_on(p, j):
            yield replace(first, det="the", plural=True, cost=0), j
        for found, end in more(p, i, (first,), j, None) if _named(first) else ():
            whole = _together(found) if isinstance(found, Coord) and found.op == "and" else None
            if whole is not None and not _goes_on(p, end):
                yield whole, end


def _of_several_kinds(p: Parser, i: int, det: str) -> Results[Coord]:
    """ "(at most one of) A, B and the blue block": told by symbols and by colours, with a noun for each."""
    for first, j in simple(p, i):
        for found, end in more(p, i, (first,), j, None) if _among(first) or _definite(first) else ():
            if not isinstance(found, Coord) or found.op != "and" or (det in _WHOLE and _together(found) is not None):
                continue
            if all(map(_among, found.items)) or _of_all(p, end, found.items):
                yield replace(found, cost=0), end


def _among(item: Meaning) -> bool:
    """One named block, or symbols in a row: "A, B"."""
    if not isinstance(item, Noun) or item.conditions:
        return False
    lettered = item.traits.kind in ("letter", "digit") and bool(item.traits.labels)
    plain = replace(item, traits=replace(item.traits, kind=None)) if lettered else item
    return _named(plain) or (_bare(item) and bool(item.traits.labels))


_OF_ONE = frozenset({"is", "lies", "stands", "sits", "rests", "goes", "has", "ends", "belongs", "touches"})


def _of_all(p: Parser, end: int, items: tuple[Meaning, ...]) -> bool:
    """ "(one of) the red blocks and the blue one is": with a verb for one thing it is one of all of these."""
    return p.stands(end, _OF_ONE) and all(map(_definite, items))


def _definite(item: Meaning) -> bool:
    """ "the two red blocks", "the blue one": by their looks."""
    told = isinstance(item, Noun) and item.det == "the" and item.head != "patch" and not item.conditions
    return told and isinstance(item, Noun) and item.part_of is None and bool(item.traits.colors + item.traits.labels)


def one_of_more(p: Parser, j: int, theme: Meaning) -> bool:
    """ "At most one of the red blocks and the blue one is ...": the verb is that of one thing, so these are not two."""
    first, *others = theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)
    one = isinstance(first, Noun) and first.part_of is not None and first.amount is not None and first.amount.high == 1
    one = one or (isinstance(first, Noun) and first.part_of is not None and first.det == "no")
    return one and bool(others) and all(map(_definite, others)) and p.stands(j, _OF_ONE)


def _open(p: Parser, i: int, j: int) -> bool:
    """ "A, B" in front of "and the blue block": with commas alone a list is not closed yet."""
    at = p.opt(j, ",")
    return "," in p.words[i:j] and "and" not in p.words[i:j] and "or" not in p.words[i:j] and p.words[at] == "and"


def _goes_on(p: Parser, j: int) -> bool:
    """Whether more is listed: "each of the red, green and blue cubes" are not the first two of them."""
    at = p.opt(p.opt(j, ","), "and")
    return at > j and (p.words[at] in lexicon.COLOR or p.words[at] == "the" or len(p.words[at]) == 1)


def _bare(noun: Noun) -> bool:
    """ "A and B", "red and blue": by these alone."""
    return noun.det == "bare" and noun.amount is None and noun.head == "any" and noun.part_of is None


def _several(noun: Noun) -> bool:
    return len(noun.traits.labels + noun.traits.colors) > 1


def _named(item: Meaning) -> bool:
    """One block by its colour or by its label, and by nothing else."""
    if not isinstance(item, Noun) or item.plural or item.amount is not None or item.part_of or item.conditions:
        return False
    marks = item.traits
    told = replace(marks, colors=(), labels=()) == Traits() and len(marks.colors + marks.labels) == 1
    return told and item.det in ("the", "bare")


def _together(found: Coord) -> Noun | None:
    items = [item for item in found.items if isinstance(item, Noun) and _named(item)]
    heads = {item.head for item in items} - {"any"}
    colors = tuple(color for item in items for color in item.traits.colors)
    labels = tuple(label for item in items for label in item.traits.labels)
    if len(items) < len(found.items) or len(heads) > 1 or (colors and labels):
        return None
    if len({*colors, *labels}) < len(items):
        return None
    marks = Traits(colors=colors, labels=labels)
    return Noun(head=heads.pop() if heads else "any", det="the", plural=True, traits=marks, span=found.span)
