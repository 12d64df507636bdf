"""What lies on a block, or on each of several: "carrying a red one", "each with a red block on top"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.had_relatives import UPHOLD, things_had
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Absolute, Amount, Clause, Coord, Loc, Meaning, Noun, Pronoun

BEARING = ("carrying", "bearing", "supporting", "holding", "holding up")
_BEARS = ("carries", "bears", "supports", "holds", "holds up", "is topped by", "is topped with", "is carrying")
_BEAR = ("carry", "bear", "support", "hold", "hold up")
_EVERY = ("each", "each one", "each of them", "every one", "every one of them")
_EACH_BEARS = tuple(
    f"{each} {bears}"
    for every, verbs in (
        (_EVERY, (*BEARING, "topped by", "topped with", "crowned by", "crowned with")),
        (("each of which", "every one of which", "of which each"), _BEARS),
        (("that each", "which each", "both of which", "all of which", "that both", "which both"), _BEAR),
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
           "stacked on it", "stacked on top", "standing on it", "resting on it", "on its top", "on itself")  # fmt: skip


@choice
def borne(p: Parser, i: int) -> Results[Absolute]:
    """What lies on "it", or on "each of them"."""
    comma = p.opt(i, ",")
    bears_it, bears, has = p.any_of(comma, BEARING), p.any_of(comma, _EACH_BEARS), p.any_of(comma, _EACH_HAS)
    for theme, k in simple(p, bears_it or bears or has) if bears_it or bears or has else ():
        one = isinstance(theme, Noun) and theme.head != "patch" and not theme.plural and theme.part_of is None
        if not one or not isinstance(theme, Noun) or (not bears_it and theme.amount != Amount(1, 1)):
            continue
        if _symbols(p, theme, k):
            continue
        top = p.any_of(k, _ON_TOP)
        if top or not has:
            mark = Pronoun(word="it" if bears_it else "each of them", span=p.span(i, k))
            on = Loc(rel="on", landmark=mark, span=mark.span)
            yield Absolute(theme=theme, adjuncts=(on,), span=p.span(i, top or k)), top or k


def bearing(p: Parser, i: int, k: int, owner: Meaning) -> Results[Absolute]:
    """ "the middle one carrying a yellow block": a thing with that on it."""
    for on, theme, end in _carried(p, i, p.any_of(k, BEARING), owner):
        yield Absolute(theme=theme, adjuncts=(on,), span=p.span(i, end)), end


_AND_HAS = (
    "has",
    "have",
    "also have",
    "also has",
    "gets",
    *(f"{must} {have}" for have in ("have", "get") for must in ("must", "should", "shall", "has to", "is to")),
)
_AND_BEARS = (*_BEARS, *_BEAR, *(f"{must} {bear}" for must in ("must", "should", "has to", "is to") for bear in _BEAR))


def and_bears(p: Parser, i: int, before: Clause) -> Results[Clause]:
    """ "(the red block lies on the green one) and carries the blue one": said of the same block."""
    if (
        before.verb not in ("be", "place")
        or before.mode == "command"
        or not before.adjuncts
        or not isinstance(before.theme, Noun)
        or before.theme.plural
    ):
        return
    same = Pronoun(word="same", span=before.theme.span)
    for (theme, rel, mods), end in things_had(p, had) if (had := p.any_of(i, _AND_HAS)) else ():
        there = Loc(rel=rel, landmark=same, mods=("directly",) if rel == "on" else mods, span=p.span(had, end))
        yield Clause(verb="be", theme=theme, adjuncts=(there,), mode=before.mode, span=p.span(i, end)), end
    for on, theme, end in _carried(p, i, p.any_of(i, _AND_BEARS), same):
        yield Clause(verb="be", theme=theme, adjuncts=(on,), mode=before.mode, span=p.span(i, end), cost=1), end


def has_it_too(p: Parser, j: int, before: Clause, item: Meaning) -> bool:
    """ "(red must be behind blue) and have green on it", "and carry nothing", is no command: red has it."""
    nothing = isinstance(item, Clause) and isinstance(item.theme, Pronoun) and item.theme.word == "nothing"
    has = ("have", *_BEAR) if nothing else ("have",)
    had = p.stands(j, has) and p.follows(j, ("and",)) and before.verb in ("be", "place")
    had = had and before.mode == "goal"
    places = item.adjuncts if had and isinstance(item, Clause) else ()
    return had and not any(getattr(getattr(x, "landmark", None), "word", "") == "same" for x in places)


def _carried(p: Parser, i: int, k: int, owner: Meaning) -> list[tuple[Loc, Meaning, int]]:
    """What is carried, and where that puts it."""
    found: list[tuple[Loc, Meaning, int]] = []
    for theme, end in noun_phrase(p, k) if k and isinstance(owner, Noun | Pronoun) else ():
        blocks = theme.items if isinstance(theme, Coord) else (theme,)
        shown = UPHOLD.isdisjoint(p.words[i:k]) and _symbols(p, theme, end)
        nothing = isinstance(theme, Pronoun) and theme.word == "nothing" and isinstance(owner, Pronoun)
        if nothing or (all(isinstance(x, Noun) and x.head != "patch" for x in blocks) and not shown):
            mods = () if nothing else ("directly",)
            end = p.any_of(end, _ON_TOP) or end
            found.append((Loc(rel="on", landmark=owner, mods=mods, span=p.span(i, k)), theme, end))
    return found


def _symbols(p: Parser, theme: Meaning, end: int) -> bool:
    """ "a cube carrying the letter A": what it shows, not what lies on it."""
    items = theme.items if isinstance(theme, Coord) else (theme,)
    shown = all(isinstance(x, Noun) and x.traits.labels and not x.traits.colors for x in items)
    return shown and p.words[end - 2] not in lexicon.BLOCK and p.words[end - 1] not in lexicon.BLOCK
