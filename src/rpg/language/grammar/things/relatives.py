"""Relative clauses and participles after a noun: "that shows letters", "which is on the patch", "stacked on ..."."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.things.adjectives import adjectives, color, of_quality
from rpg.language.grammar.things.blank import blank
from rpg.language.grammar.things.had_relatives import UPHOLD, had_there
from rpg.language.grammar.things.labels import label_list
from rpg.language.grammar.things.out_of_region import out_of_region
from rpg.language.grammar.things.standby import NO_ROLE
from rpg.language.grammar.things.told_relatives import told_relative
from rpg.language.later import later
from rpg.language.meaning import Loc, Manner, Meaning, Noun, That, Traits, replace

if TYPE_CHECKING:
    from rpg.language.grammar.clauses.manners import manner
    from rpg.language.grammar.places.relations import loc
    from rpg.language.grammar.things.nouns import simple
else:
    (manner,) = later(__name__, "rpg.language.grammar.clauses.manners", "manner")
    (loc,) = later(__name__, "rpg.language.grammar.places.relations", "loc")
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_THAT = frozenset({"that", "which", "who", "what"})
_SHOW = frozenset(
    {
        "show",
        "shows",
        "showing",
        "display",
        "displays",
        "bear",
        "bears",
        "carry",
        "carries",
        "have",
        "has",
        "read",
        "reads",
        "say",
        "says",
    }
)
_THINGS = {"letters": "letter", "numbers": "digit", "digits": "digit", "symbols": "symbol", "letter": "letter",
           "number": "digit"}  # fmt: skip


_WHOSE_COLOR = ("whose color is", "which color is", "that color is", "where the color is", "of which the color is",
                "with the color", "that has color", "that has the color", "which has the color", "having color",
                "having the color", "who is", "of the color")  # fmt: skip


@rule
def relative(p: Parser, i: int, head: str, plural: bool) -> Results[Any]:
    """Traits, or a tuple of conditions: places, or `That` of kind "whole" where a verb in the singular behind several
    blocks is of the structure that they form."""
    if head == "block":
        yield from blank(p, i)
    comma = p.opt(i, ",")
    if j := p.any_of(comma, _WHOSE_COLOR):
        for named, k in color(p, j):
            yield Traits(colors=(named,)), k
    that = p.one(comma, _THAT)
    that = p.any_of(that, ("in turn", "itself")) or that if that else 0
    if that:
        if j := max(NO_ROLE.matches(p, that), default=0):
            yield Traits(extra=True), j
        j = p.one(that, _SHOW)
        if j and not (plural and p.words[that] in _ONE_HAS):  # "a tower of blocks, which has F on it": the tower
            yield from ((shown, k) for shown, k in _shown(p, j) if not _beside_it(p, k))
        namely = comma > i and p.words[i + 1 : i + 3] == ["that", "is"]
        if j := p.one(that, ("is", "are")) if not namely else 0:
            j = p.opt(j, "all", "both", "each") if j else j
            for marks, k in adjectives(p, j):
                if marks and head in ("block", "any", "patch"):
                    yield from list(_and_more(p, k, marks)) or [(Traits(**marks), k)]
            for marks, k in of_quality(p, j, head):
                yield Traits(**marks), k
            j = p.one(j, _AT_FIRST) or j
        yield from _carrying(p, that, comma > i)
        yield from had_there(p, that, comma > i) if not plural and head != "patch" else ()
        yield from told_relative(p, i, that, head, plural)
        start = that
        while start < p.end and (p.words[start] in lexicon.POSTURE or p.words[start] in _BESIDE):
            start = p.reach(start + 1)
        whole = plural and p.words[that] in _SINGULAR
        asserted = comma > i and _AT_FIRST.isdisjoint(p.words[that:start])
        staying = not _STAYING.isdisjoint(p.words[that:start])
        for places, k in _conditions(p, start, loc, asserted) if start > that or p.words[that] == "touches" else ():
            if staying and not whole:
                places = (*places, Manner(kind="staying", span=p.span(that, k)))
            yield (tuple(That(kind="whole", clauses=x, span=x.span) for x in places) if whole else places), k
    else:
        yield from told_relative(p, i, 0, head, plural)
        if head == "block":
            yield from out_of_region(p, i)


def _and_more(p: Parser, i: int, marks: dict[str, Any]) -> Results[Traits]:
    """ "(that is red) and small", "(that is 15 cm wide) and blue": a size or a shape behind a colour, or a colour
    behind these; no noun of its own follows."""
    if not (j := p.one(i, "and")):
        return
    for more, k in adjectives(p, j):
        told = [key for told in (marks, more) for key in told]
        apart = len(told) == 2 and "colors" in told and not _FORM.isdisjoint(told)
        other = "size" not in told and p.stands(k, _ON)  # "(a mat that is round) and blue on green"
        if apart and not other and not any(p.stands(k, table) for table in (lexicon.BLOCK, lexicon.PATCH, _ONES)):
            yield Traits(**marks, **more), k


_FORM = frozenset({"size", "edge", "shape"})
_ON = frozenset({"on", "onto", "under"})
_ONES = frozenset({"one", "ones"})
_AT_FIRST = frozenset({"currently", "already", "initially", "originally", "now", "presently"})
_BESIDE = _AT_FIRST | {"itself"}
_STAYING = frozenset({"stay", "stays", "remain", "remains"})
_SINGULAR = frozenset({"is", "stands", "lies", "sits", "rests", "touches"})


_MUST = ("should", "must", "shall", "has to", "is to", "needs to")
_CARRY = (
    "carries", "carry", "holds up", "hold up", "is carrying", "is holding", "is supporting", "holds", "hold",
    "supports", "support", "bears", "bear",
    *(f"{must} {verb}" for must in _MUST for verb in ("carry", "hold", "support")),
)  # fmt: skip


@choice
def _carrying(p: Parser, i: int, asserted: bool) -> Results[tuple[Meaning, ...]]:
    """ "(the red block) that carries the pink one": what lies on it."""
    j = p.any_of(i, _CARRY)
    for theme, k in simple(p, j) if j else ():
        shown = isinstance(theme, Noun) and theme.traits.labels and UPHOLD.isdisjoint(p.words[i:j])
        if isinstance(theme, Noun) and theme.head != "patch" and not theme.plural and not shown:
            wanted = asserted or p.words[i] in _MUST or p.words[i + 1] == "to"
            mods = ("directly", "asserted") if wanted else ("directly",)
            yield (Loc(rel="under", landmark=theme, mods=mods, span=p.span(i, k)),), k


def _conditions(p: Parser, i: int, loc: Any, asserted: bool) -> Results[tuple[Meaning, ...]]:
    """Places; after a comma ("..., which is on the patch") they are said of the goal as well, unless the block is moved
    from there, or "at the start" follows."""
    for first, j in loc(p, i):
        begun = max((end for told, end in manner(p, j) if getattr(told, "kind", "") == "start"), default=0)
        if asserted and not begun and isinstance(first, Loc):
            first = replace(first, mods=(*first.mods, "asserted", "aside"))
        yield (first,), begun or j


def _shown(p: Parser, i: int) -> Results[Traits]:
    j = p.opt(i, "the", "a", "an") if p.tokens[i : i + 1] and not p.tokens[i].raw.isupper() else i
    if j < p.end and p.words[j] in _THINGS:
        kind = _THINGS[p.words[j]]
        end = p.reach(j + 1)
        yield Traits(kind=kind), p.any_of(end, ("on them", "on it")) or end
        for (labels, more), k in label_list(p, end, True):
            yield Traits(labels=labels, open_ended=more), k
    for (labels, more), k in label_list(p, j, True):
        yield Traits(labels=labels, open_ended=more), k


def _beside_it(p: Parser, k: int) -> bool:
    """ "(which has the C) in front of it": that is another block, and not what it shows."""
    on = p.stands(k, ("on",)) and not {"left", "right", "of"}.isdisjoint(p.words[k : k + 4])
    return (on or p.stands(k, _BEGINS_A_PLACE)) and not {"it", "its"}.isdisjoint(p.words[k : k + _NEAR])


_ONE_HAS = frozenset({"has", "carries", "bears"})
_BEGINS_A_PLACE = frozenset({"behind", "in", "next", "beside", "to", "left", "right", "under", "near", "adjacent"})
_NEAR = len(("on", "the", "left", "side", "of", "it"))


def which_also(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """ "the block that is pink, which must be behind the blue one": where it is, behind what it looks like."""
    for condition, end in relative(p, j, noun.head, noun.plural) if p.stands(j, (",",)) else ():
        if not isinstance(condition, Traits):
            told = replace(noun, conditions=(*noun.conditions, *condition), span=p.span(i, end))
            yield from ((told, last) for last in {end: None, p.opt(end, ","): None})
