"""Requests about places in a figure: "the top layer should be red", "the block in the centre", "a red one in each
corner"."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.language.grammar.structures.parts import part, part_statement
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import Parser, lexicon, longest, m, noun_phrase

PLACE = m.At | m.Places


@dataclass(frozen=True, slots=True, kw_only=True)
class Part(r.Request):
    """Blocks of this look stand at a place of a figure, in the stead of those that do."""

    place: PLACE
    look: m.Noun


@dataclass(frozen=True, slots=True, kw_only=True)
class DropPart(r.Request):
    """The blocks at a place of a line leave it."""

    place: PLACE


_DROPS = "remove | delete | take away | take off | take out | drop | without | get rid of | leave out | cut off | lose"
_LEADS = (
    "make | have | with | let | paint | color | colour | recolor | recolour | repaint | "
    "turn | i want | put | use | change | now with | place"
)
_IS = (
    "should be | must be | should become | becomes | is to be | are to be | has to be | have to be | needs to be | "
    "could be | can be | might be | may be | would be | ought to be | "
    "to | be | should all be | should be made of | should now be | into | in | to be | is | are"
)


def parts(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Every way to say how a part of a figure should look."""
    drop = longest(p, i, _DROPS)
    for place, k in part(p, drop, "block") if drop else ():
        if isinstance(place, m.Places) and place.several is not None:
            yield DropPart(place=place, span=p.span(i, k), cost=1), k
    j = longest(p, i, _LEADS) or i
    for found, k in part_statement(p, j):
        place = found.adjuncts[0]
        rest = isinstance(place, m.Places) and place.side == "rest"
        one_end = getattr(place, "side", "") == "ends" and "end" in p.words[j:k] and _several(found.theme)
        rest = rest or (one_end and not {"each", "either", "both", "every"} & set(p.words[j:k]))
        if isinstance(found.theme, m.Noun) and isinstance(place, PLACE) and not rest and not _on(p, found.theme, j, k):
            yield Part(place=place, look=found.theme, span=p.span(i, k), cost=1), k
    for place, k in (*_block_at(p, j), *((at, k) for at, k in part(p, j) if isinstance(at, PLACE))):
        for look, end in noun_phrase(p, longest(p, k, _IS) or k):
            if isinstance(look, m.Noun) and (look.traits.colors or look.traits.labels) and look.det != "the":
                yield Part(place=place, look=look, span=p.span(i, end)), end


def _several(look: m.Meaning) -> bool:
    """Whether a phrase lists looks: "E and F at the end" go to one end."""
    return isinstance(look, m.Noun) and max(len(look.traits.labels), len(look.traits.colors)) > 1


def _on(p: Parser, look: m.Noun, i: int, j: int) -> bool:
    """Whether a block is to go on a part, which may well mean on top of it: "a red block on each corner"."""
    return look.head == "block" and "on" in p.words[i:j]


def _block_at(p: Parser, i: int) -> Iterator[tuple[PLACE, int]]:
    """Phrases such as "the block in the centre", "the ones at the corners"."""
    j = longest(p, i, "the | its")
    plural = p.lex(j, lexicon.BLOCK) if j and j < p.end else None
    if plural is None and j and p.words[j : j + 1] not in (["one"], ["ones"]):
        return
    n = longest(p, j + 1, "in | at | on | of") if j else 0
    for place, k in part(p, n, "block") if n else ():
        if isinstance(place, PLACE):
            yield place, k
