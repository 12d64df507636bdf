"""Requests that add objects, put them somewhere, or remove them."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.steer import requests as r
from rpg.steer.language import Parser, longest, m, noun_phrase, phrases, simple
from rpg.steer.phrases import fresh, labelled, things
from rpg.steer.places import place, places

ADD = frozenset({"add", "include", "insert", "append", "introduce", "attach", "bring", "throw"})


PUT = frozenset(
    {"put", "place", "stack", "set", "lay", "position", "drop", "move", "bring", "shift", "transfer", "relocate"}
)


REMOVE = phrases(
    "remove | delete | drop | discard | eliminate | lose | omit | leave out | take out | take away | take "
    "off | get rid of | do without | throw away | throw out | ditch | cut | take | pull out | clear away "
    "| exclude"
)


def add(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "add a green block on top of the blue one", "with another red block"."""
    leads = ("there should also be", "there should be", "there must be", "with", "give it", "have")
    j = p.one(i, ADD) or longest(p, i, leads) or i
    j = longest(p, j, ("in", "back")) or j
    verb = p.words[i] in ADD
    for theme, k in things(p, j):
        if fresh(theme) or (verb and labelled(theme)):
            for spots, end in places(p, k):
                if spots or j > i:
                    yield r.Add(theme=theme, places=spots, span=p.span(i, end), cost=0 if verb else 2), end
    for spots, k in places(p, j) if verb else ():
        for theme, end in things(p, k) if spots else ():
            if fresh(theme):
                yield r.Add(theme=theme, places=spots, span=p.span(i, end), cost=1), end


def put(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "put a green block on top" adds; "put the green block on top" moves."""
    j = p.one(i, PUT)
    if not j:
        return
    for theme, k in noun_phrase(p, j):
        if fresh(theme):
            for spots, end in places(p, k):
                if spots:
                    yield r.Add(theme=theme, places=spots, span=p.span(i, end)), end
        else:
            for where, end in place(p, k):
                yield r.Move(theme=theme, place=where, span=p.span(i, end)), end
    for where, k in place(p, j):
        for theme, end in noun_phrase(p, k):
            if fresh(theme):
                yield r.Add(theme=theme, places=(where,), span=p.span(i, end), cost=1), end


def remove(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    for phrase in (*REMOVE, "without", "no more", "no"):
        if j := p.seq(i, phrase):
            for theme, k in things(p, j):
                end = longest(p, k, "away | out | off | again") or k
                if from_ := longest(p, end, ("from", "out of", "off")):
                    for whole, stop in simple(p, from_):
                        if isinstance(whole, m.Structure | m.Pronoun | m.TableTop):
                            yield r.Remove(theme=theme, span=p.span(i, stop)), stop
                if phrase != "take" or end > k:
                    yield r.Remove(theme=theme, span=p.span(i, end)), end
