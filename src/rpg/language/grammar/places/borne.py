"""What lies on a block, or on each of several: "carrying a red one", "each with a red block on top"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Absolute, Amount, Loc, Noun, Pronoun

BEARING = ("carrying", "bearing", "supporting", "holding", "holding up")
_BEARS = ("carries", "bears", "supports", "holds", "holds up", "is topped by", "is topped with", "is carrying")
_BEAR = ("carry", "bear", "support", "hold", "hold up")
_EVERY = ("each", "each one", "each of them", "every one", "every one of them")
_EACH_BEARS = tuple(
    f"{each} {bears}"
    for every, verbs in (
        (_EVERY, (*BEARING, "topped by", "topped with", "crowned by", "crowned with")),
        (("each of which", "every one of which", "of which each"), _BEARS),
        (("that each", "which each"), _BEAR),
    )
    for each in every
    for bears in verbs
)
_EACH_HAS = (
    *(f"{each} {has}" for each in _EVERY for has in ("with", "having", "has")),
    "each of which has", "of which each has", "that each have", "which each have",
)  # fmt: skip
"""Behind these it is still to be said that it lies on them."""
_ON_TOP = ("on top of it", "on top of them", "on top", "on it", "on them", "sitting on it", "lying on it", "above it",
           "stacked on it", "stacked on top", "standing on it", "resting on it", "on its top")  # fmt: skip


@choice
def borne(p: Parser, i: int) -> Results[Absolute]:
    """What lies on "it", or on "each of them"."""
    comma = p.opt(i, ",")
    bearing, bears, has = p.any_of(comma, BEARING), p.any_of(comma, _EACH_BEARS), p.any_of(comma, _EACH_HAS)
    for theme, k in simple(p, bearing or bears or has) if bearing or bears or has else ():
        one = isinstance(theme, Noun) and theme.head != "patch" and not theme.plural and theme.part_of is None
        if not one or not isinstance(theme, Noun) or (not bearing and theme.amount != Amount(1, 1)):
            continue
        top = p.any_of(k, _ON_TOP)
        if top or not has:
            mark = Pronoun(word="it" if bearing else "each of them", span=p.span(i, k))
            on = Loc(rel="on", landmark=mark, span=mark.span)
            yield Absolute(theme=theme, adjuncts=(on,), span=p.span(i, top or k)), top or k
