"""What a subject is, becomes or is made of: "a row is seen", "the blocks become a circle"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.made import made
from rpg.language.grammar.clauses.moves import moves
from rpg.language.grammar.clauses.ranked_anew import becomes_first
from rpg.language.grammar.clauses.told_piled import told_piled
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.structures.rising import they_rise
from rpg.language.grammar.things.lists import listed
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.grammar.things.retold import told_of
from rpg.language.meaning import (
    Clause,
    Coord,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    TableTop,
    Traits,
    replace,
)

_IS = ("is to be", "are to be", "is", "are", "be", "being", "gets", "get")
_THERE = frozenset({"seen", "shown", "visible", "present", "needed", "required", "wanted", "desired", "expected",
                    "observed", "displayed", "provided", "presented", "requested",
                    "prescribed", "legible", "readable", "read"})  # fmt: skip
_GIVEN = frozenset({"provided", "present"})
"""Of blocks these tell that there are such."""
_EXISTS = frozenset({"appear", "exist"})
_RISES = frozenset({"rise", "rises"})
"""What only towers do where they stand."""
_CONSISTS = (
    "consists of", "consist of", "is made of", "is made from", "is made up of", "is made out of", "is composed of",
    "comprises", "is built from", "is built of", "be made of", "be made from", "consist only of", "be built from",
    "be made up of", "is formed by", "is formed of", "are made of", "are made from",
)  # fmt: skip
_BECOMES = (
    "become",
    "becomes",
    "turn into",
    "turns into",
    "end up as",
    "ends up as",
    "end as",
    "change into",
    "look like",
    "looks like",
    "resemble",
    "resembles",
    "look as",
    "take the shape of",
    "takes the shape of",
    "have the shape of",
    "has the shape of",
    "have the form of",
    "has the form of",
    "take the form of",
    *(
        f"{be} {turned} into"
        for be in ("be", "is", "are", "gets", "get")
        for turned in ("turned", "made", "transformed", "changed", "converted", "rearranged", "remade", "reshaped")
    ),
)
_GATHERS = frozenset({"gather", "cluster", "assemble", "group", "line", "align", "queue", "bunch", "unite", "stack",
                      "merge", "combine"})  # fmt: skip


def becoming(p: Parser, i: int, k: int, theme: Meaning, mode: str) -> Iterator[tuple[Meaning, int]]:
    """Clauses from i on, with their subject before k and its auxiliaries behind it."""
    yield from (*_there(p, i, k, theme, mode), *moves(p, i, k, theme, mode, False))
    yield from told_piled(p, i, k, theme, mode)
    if isinstance(theme, Structure):
        yield from _consists(p, i, k, theme, mode)
        yield from _becomes(p, i, k, theme, mode)
        yield from _goes(p, i, k, theme, mode)
        for way, j in toward(p, comma) if (comma := p.one(k, ",")) else ():
            end = p.one(j, ",")
            for found, last in _goes(p, i, p.opt(end, "should", "must", "shall"), theme, mode) if end else ():
                if isinstance(found, Clause):
                    yield replace(found, adjuncts=(*found.adjuncts, way)), last
    elif isinstance(theme, Noun | Coord | Pronoun):
        yield from they_rise(p, i, k, theme, mode)
        yield from _visits(p, i, k, theme, mode) if p.rarely(_VISIT) else ()
        yield from _becomes(p, i, k, theme, mode)
        yield from becomes_first(p, i, k, theme)
        yield from _gathers(p, i, k, theme, mode)


def _there(p: Parser, i: int, k: int, theme: Meaning, mode: str) -> Iterator[tuple[Meaning, int]]:
    """ "a row of blocks is seen: cyan, white", "a yellow block should be visible in front of it"."""
    be = p.any_of(k, _IS)
    rises = p.one(k, _RISES) if isinstance(theme, Structure) and theme.kind == "stack" else 0
    j = p.one(be, _THERE) if be else p.one(k, _EXISTS) or rises
    if not j:
        return
    shaped = isinstance(theme, Structure)
    if isinstance(theme, Noun) and theme.det in ("a", "bare") and p.words[j - 1] in _GIVEN:
        yield Clause(verb="exist", theme=theme, mode="given", span=p.span(i, j), cost=1), j
    yield from made(p, i, j, theme, Clause(verb="build", mode=mode, span=p.span(i, j)))
    for found, end in adjuncts(p, j):
        if found or shaped:
            verb = "build" if shaped else "be"
            yield Clause(verb=verb, theme=theme, adjuncts=found, mode=mode, span=p.span(i, end)), end
    colon = p.opt(j, ":", ",")
    for items, end in listed(p, colon) if shaped and colon > j else ():
        yield _listing(p, i, end, theme, items, mode), end


def _listing(
    p: Parser, i: int, end: int, theme: Meaning, items: tuple[Meaning, ...], mode: str, by: str = "named"
) -> Clause:
    """A structure with its members in their order."""
    order = OrderBy(by=by, items=items, span=p.span(i, end))
    assert isinstance(theme, Structure)
    said = theme.members
    open_ = isinstance(said, Noun) and said.amount is None and said.traits == Traits()
    whole = replace(theme, members=None if open_ else said, details=(*theme.details, order), span=p.span(i, end))
    return Clause(verb="build", theme=whole, mode=mode, span=p.span(i, end))


def _goes(p: Parser, i: int, k: int, theme: Structure, mode: str) -> Iterator[tuple[Meaning, int]]:
    """ "the tower goes brown, white, pink"."""
    j = p.any_of(k, _LISTS_OR_IS) if theme.kind in _ORDERED else 0
    lists = p.words[j - 1] in _LISTS or p.words[j : j + 1] == [":"]
    for items, end in listed(p, p.opt(j, ":")) if j else ():
        if lists or len(items) > 2:
            by = "read" if p.words[j - 1] in ("reads", "read") else "named"
            for found, last in adjuncts(p, end):
                said = _listing(p, i, end, theme, items, mode, by)
                yield replace(said, adjuncts=found, span=p.span(i, last)), last


_LISTS = ("goes", "go", "runs", "run", "reads", "read", "shows", "show")
_LISTS_OR_IS = (*_LISTS, "be", "is", "has")
_ORDERED = ("stack", "row", "line", "column")


def _consists(p: Parser, i: int, k: int, theme: Structure, mode: str) -> Iterator[tuple[Meaning, int]]:
    j = p.any_of(k, _CONSISTS)
    if not j or theme.members is not None:
        return
    for members, end in noun_phrase(p, j):
        if isinstance(members, Noun | Coord):
            whole = replace(theme, members=members, span=p.span(i, end))
            for found, last in adjuncts(p, end):
                yield Clause(verb="build", theme=whole, adjuncts=found, mode=mode, span=p.span(i, last)), last


def _becomes(p: Parser, i: int, k: int, theme: Meaning, mode: str) -> Iterator[tuple[Meaning, int]]:
    """ "five blocks become a circle"; "the six blocks are a triangle"; "a heap of them has to become a row"."""
    turned = p.any_of(k, _BECOMES)
    shaped = isinstance(theme, Structure)
    j = turned or (0 if shaped else p.any_of(k, _IS))
    if not j or (isinstance(theme, Noun) and (theme.head == "patch" or not theme.plural)):
        return
    if isinstance(theme, Structure) and (theme.kind in ("word", "equation") or theme.plural or mode == "start"):
        return
    for target, end in simple(p, j):
        plain = isinstance(target, Structure) and target.members is None and target.kind not in ("word", "equation")
        if not plain or not isinstance(target, Structure) or not _new(target, bool(turned)):
            continue
        into = Into(structure=target, span=p.span(j, end))
        for found, last in adjuncts(p, end):
            lemma = "turn into" if shaped else ""
            adj, span = (into, *found), p.span(i, last)
            yield Clause(verb="arrange", lemma=lemma, theme=theme, adjuncts=adj, mode=mode, cost=1, span=span), last


def _new(target: Structure, turned: bool) -> bool:
    """ "a tower", "one tower", "two rows"; behind a verb of change no number need be said."""
    return target.det == "a" or (target.det == "bare" and (turned or target.amount is not None))


_VISIT = frozenset({"visit", "visits"})
_STEPS = frozenset({"first", "then", "before", "afterwards"})
"""Beside these something is visited on the way, and is where it is then for a while."""


def _visits(p: Parser, i: int, k: int, theme: Meaning, mode: str) -> Iterator[tuple[Meaning, int]]:
    """ "the red block visits the blue mat first (and then ends up on the green one)"."""
    j = p.one(k, _VISIT)
    for mark, at in simple(p, j) if j and not p.all.isdisjoint(_STEPS) else ():
        if not isinstance(mark, Noun) or mark.head != "patch":
            continue
        there = Loc(rel="on", landmark=mark, span=p.span(k, at))
        for found, end in adjuncts(p, at):
            if all(isinstance(a, Manner) for a in found):
                yield Clause(verb="be", theme=theme, adjuncts=(there, *found), mode=mode, span=p.span(i, end)), end


def _gathers(p: Parser, i: int, k: int, theme: Meaning, mode: str) -> Iterator[tuple[Meaning, int]]:
    """ "all the blocks gather in the left half", "the cubes line up"."""
    if isinstance(theme, Noun) and not theme.plural:
        return
    for sense, lemma, form in p.lex(k, lexicon.VERB) or ():
        if form not in ("base", "s") or lemma not in _GATHERS:
            continue
        for found, end in adjuncts(p, p.opt(k + 1, "up", "together")):
            said = Clause(verb=sense, lemma=lemma, theme=theme, adjuncts=found, mode=mode, span=p.span(i, end),
                          word=p.span(k, k + 1), cost=1)  # fmt: skip
            yield said, end


_PLACE = tuple(
    f"{its} {place}" for its in ("its", "their", "its current", "its original", "its starting", "their current")
    for place in ("place", "places", "position", "positions", "spot", "spots")
)  # fmt: skip


def staying(p: Parser, i: int, k: int, theme: Meaning, mode: str) -> Results[Clause]:
    """ "(the red block) must never leave the patch", "... the table": it is on it all the time."""
    j = p.one(k, ("leave", "leaves"))
    if end := p.any_of(j, _PLACE) if j else 0:
        stay = Manner(kind="stay", span=p.span(j, end))
        yield Clause(verb="be", theme=theme, adjuncts=(stay,), mode=mode, span=p.span(i, end)), end
    for mark, end in noun_phrase(p, j) if j else ():
        it = isinstance(mark, Pronoun) and mark.word == "it"
        if it or isinstance(mark, TableTop) or (isinstance(mark, Noun) and mark.det in ("the", "bare")):
            on = Loc(rel="on", landmark=mark, span=p.span(k, end))
            always = Manner(kind="always", span=on.span)
            for begun, last in adjuncts(p, end):
                if all(isinstance(a, Manner) and a.kind in ("begun", "always") for a in begun):
                    yield Clause(verb="be", theme=theme, adjuncts=(on, always), mode=mode, span=p.span(i, last)), last


_WHEN = frozenset({"always", "finally", "start", "time", "gone"})


def touches(p: Parser, i: int, k: int, theme: Meaning, mode: str, negated: bool) -> Results[Clause]:
    """ "the red block touches the blue one (at the start)", "the blocks touch"."""
    if j := p.one(k, ("touch", "touches")):
        for other, end in noun_phrase(p, j):
            touch = Loc(rel="touching", landmark=other, span=p.span(k, end))
            said = Clause(verb="be", theme=theme, adjuncts=(touch,), negated=negated, mode=mode, span=p.span(i, end))
            for when, last in adjuncts(p, end):
                if all(isinstance(a, Manner) for a in when):
                    yield replace(said, adjuncts=(touch, *when), span=p.span(i, last)), last
        touch = Loc(rel="touching", landmark=Pronoun(word="each other", span=p.span(k, j)), span=p.span(k, j))
        for when, last in adjuncts(p, j):
            if all(isinstance(a, Manner) and a.kind in _WHEN for a in when):
                yield Clause(verb="be", theme=theme, adjuncts=(touch, *when), negated=negated, mode=mode,
                             span=p.span(i, last)), last  # fmt: skip
        if (end := p.seq(j, "side by side")) and not negated:
            level = (replace(touch, rel="side_by_side"), touch)
            yield Clause(verb="be", theme=theme, adjuncts=level, mode=mode, span=p.span(i, end)), end


def and_touches(p: Parser, i: int, before: Clause) -> Results[Clause]:
    """ "(the two stand side by side) and touch each other": a further predicate of the same subject."""
    if before.verb == "be" and before.theme is not None and not before.negated and before.mode != "start":
        yield from touches(p, i, i, told_of(before), before.mode, False)
