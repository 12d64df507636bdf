"""Changes that are asked for as a wish or a question: what something should be, could be, would rather be."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.steer.places import given_up, place
from rpg.steer.requests import requests as r
from rpg.steer.requests.changing import becomes
from rpg.steer.requests.language import Parser, adjectives, colors, label_list, longest, m, phrases
from rpg.steer.requests.phrases import old, subjects

_WANTS = phrases(
    "i would rather have | i would rather see | i would rather | i would like | i would prefer | i prefer | i want | "
    "i need | i would love | we want | we need | we would like | i would like to have | i would like to see | "
    "i want to see | i want to have | let me have | let me see | show me | what if | how about | what about"
)
_AUXILIARIES = frozenset({"can", "could", "may", "might", "should", "must", "shall", "will", "would"})
_GO = phrases("go | move | come | sit | stand | be | be put | be placed | be moved | rather be | go back")
_LINKS = phrases("to be | to become | be | become | turn | in | as | was | were | is | are")


def wish(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "could the top be pink", "I would rather have it in green", "give the base a cyan colour"."""
    yield from _question(p, i)
    yield from _wanted(p, i)
    yield from _given(p, i)


def _question(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    j = p.one(i, _AUXILIARIES)
    for theme, k in subjects(p, j) if j else ():
        n = longest(p, k, "be | become | turn | turn into | both be | all be | instead be | maybe be")
        if n and old(theme):
            yield from becomes(p, i, n, theme, cost=1)
        goes = longest(
            p, k, "go | move | come | sit | stand | be | be put | be placed | be moved | rather be | go back"
        )
        for where, end in place(p, goes) if goes and old(theme) else ():
            end = given_up(p, end)
            yield r.Move(theme=theme, place=where, span=p.span(i, end), cost=1), end


def _wanted(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    j = longest(p, i, _WANTS)
    for theme, k in subjects(p, j) if j else ():
        if old(theme):
            yield from becomes(p, i, longest(p, k, _LINKS) or k, theme, cost=1)


def _given(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "give the base a cyan colour", "give it the letter B"."""
    j = p.one(i, "give")
    for theme, k in subjects(p, j) if j else ():
        if not old(theme):
            continue
        n = longest(p, k, "a new | another | a | an | the color | the")
        for (listed, either), end in colors(p, n) if n else ():
            end = p.opt(end, "color", "shade", "look", "paint")
            yield (r.Restyle(theme=theme, traits=m.Traits(colors=listed, either=either), span=p.span(i, end)), end)
        if n := longest(p, k, "the letter | the label | the number | the symbol"):
            for (labels, _), end in label_list(p, n, True):
                yield (r.Restyle(theme=theme, traits=m.Traits(labels=labels), span=p.span(i, end)), end)
        for marks, end in adjectives(p, longest(p, k, "a size of | an edge of | edges of") or k):
            if set(marks) == {"edge"}:
                yield (r.Restyle(theme=theme, traits=m.Traits(**marks), span=p.span(i, end)), end)
