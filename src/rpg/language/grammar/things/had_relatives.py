"""Relative clauses of what a block has beside it or on it: "which should have a white one to its left", "which is
topped by the green one". They speak of the noun that they follow, however a verb before it goes on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rpg.core.diagnostics import Span
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.retold import none_of
from rpg.language.later import later
from rpg.language.meaning import Absolute, At, Loc, Meaning, Noun, Pronoun, Traits, replace
from rpg.language.phrases import Classes

if TYPE_CHECKING:
    from rpg.language.grammar.clauses.adjuncts import adjunct
    from rpg.language.grammar.clauses.each_has import is_owner
    from rpg.language.grammar.things.nouns import simple
else:
    (adjunct,) = later(__name__, "rpg.language.grammar.clauses.adjuncts", "adjunct")
    (is_owner,) = later(__name__, "rpg.language.grammar.clauses.each_has", "is_owner")
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_WORDS = Classes({
    "must": ("should|must|shall|will|ought_to|has_to|needs_to|is_to|is_supposed_to also|itself|finally?",),
    "topped": ("topped|crowned|capped|covered",),
})  # fmt: skip
_HAS = Patterns("also|itself? has|gets|receives|wants|needs", "<must> have|get|receive|end_up_with", classes=_WORDS)
_TOPPED = Patterns("is|gets also|itself? <topped> by|with", "<must> be <topped> by|with", classes=_WORDS)
_LYING = ("lying", "standing", "sitting", "resting", "placed", "put", "positioned", "located", "stacked")
BACK = {"on": "under", "under": "on", "above": "below", "left": "right", "right": "left", "front": "behind",
        "behind": "front", "beside": "beside", "adjacent": "adjacent", "near": "near",
        "touching": "touching"}  # fmt: skip
"""How what a relative clause speaks of lies to the block that is said to be there."""
UPHOLD = frozenset({"support", "supports", "supporting"})
"""No symbol is shown by what does so: "the cube that supports the C"."""
_TOPS = {"top": "on", "left": "left", "right": "right"}


def wished_of_new(p: Parser, i: int, noun: Noun, conditions: tuple[Meaning, ...], span: Span) -> Noun | None:
    """A noun with what is said of it; what "a red block that has a white one on it" has, it is to have. Of "the red
    block that has a white one on it" it is not said whether it has that one, or is to have it."""
    if p.stands(i, _THAT) and p.stands(i + 1, _HAVE):
        if noun.det != "a":
            return None
        conditions = tuple(replace(x, mods=(*x.mods, "asserted")) if isinstance(x, Loc) else x for x in conditions)
    return replace(noun, conditions=(*noun.conditions, *conditions), span=span)


_THAT = frozenset({"that", "which"})
_HAVE = frozenset({"has", "gets"})


def of_the_nearest(p: Parser, comma: int, place: Meaning) -> bool:
    """ "(red in front of blue,) which has white on it": told of the noun in front of it, and so read there."""
    return p.stands(comma, _THAT) and isinstance(place, Loc) and isinstance(place.landmark, Pronoun)


def told_of_which(told: Absolute, which: Span) -> Absolute:
    """ "(red left of a row of three,) which has white behind it": behind what stands in front of "which"."""
    place = told.adjuncts[0]
    it = place.landmark if isinstance(place, Loc) else None
    if not isinstance(it, Pronoun) or it.word != "it":
        return told
    return replace(told, adjuncts=(replace(place, landmark=replace(it, word="which", span=which)), *told.adjuncts[1:]))


@choice
def had_there(p: Parser, i: int, asserted: bool) -> Results[tuple[Meaning, ...]]:
    """What the noun in front of "which" has, as the places that it has to them."""
    for j in _TOPPED.matches(p, i):
        for theme, k in simple(p, j):
            if _block(theme):
                yield (_place(p, i, k, "on", (), theme, asserted),), k
    for j in _HAS.matches(p, i):
        yield from _had(p, i, j, asserted or p.words[i] not in ("has", "gets"), ())


def _had(p: Parser, i: int, j: int, asserted: bool, before: tuple[Meaning, ...]) -> Results[tuple[Meaning, ...]]:
    """ "the white one on it (and the black one to its left)"."""
    for (theme, rel, mods), k in ((had, k) for had, k in things_had(p, j) if _block(had[0])):
        told = (*before, _place(p, i, k, rel, mods, theme, asserted))
        yield told, k
        if joint := p.one(k, "and"):
            yield from _had(p, i, joint, asserted, told)


def things_had(p: Parser, i: int) -> Results[tuple[Meaning, str, tuple[str, ...]]]:
    """A block or none, and how it lies to what has it: "the white one on it", "nothing to its left"."""
    for theme, start in simple(p, i):
        for place, k in adjunct(p, p.opt(start, *_LYING)) if _block(theme) or none_of(theme) else ():
            if _shown(p, theme, start, k):
                continue
            if isinstance(place, Loc) and is_owner(place.landmark) and place.rel in BACK and not place.negated:
                yield (theme, place.rel, place.mods), k
            elif isinstance(place, At) and place.side in _TOPS and place.index is None:
                yield (theme, _TOPS[place.side], ()), k


def _shown(p: Parser, theme: Meaning, j: int, k: int) -> bool:
    """ "(the block that has) the letter A on it": what it shows, and not what lies on it."""
    symbols = isinstance(theme, Noun) and theme.traits.labels and not theme.traits.colors
    return bool(symbols) and p.words[k - 2 : k] == ["on", "it"] and _BLOCKS.isdisjoint(p.words[j - 2 : j])


_BLOCKS = frozenset({"block", "cube", "brick", "box"})


def _place(p: Parser, i: int, k: int, rel: str, mods: tuple[str, ...], theme: Meaning, asserted: bool) -> Loc:
    close = ("directly",) if rel == "on" else mods
    return Loc(rel=BACK[rel], landmark=theme, mods=(*close, "asserted") if asserted else close, span=p.span(i, k))


def _block(theme: Meaning) -> bool:
    return isinstance(theme, Noun) and theme.head != "patch" and not theme.plural


def told_traits(traits: Traits) -> dict[str, Any]:
    """Those of its fields that say something."""
    return {n: v for n in Traits.__dataclass_fields__ if (v := getattr(traits, n)) != getattr(Traits(), n)}
