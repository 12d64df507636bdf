"""What joins clauses: "and", "then", "or", "before", "once that is done"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.commands import AFTER_THAT, THEN, WHEN_OVER
from rpg.language.meaning import Absolute, Clause, In, Into, Loc, Meaning, OrderBy, Pronoun, Size

_EARLIER = (
    "but first", "but before that", "and before that", "but only after", "only after", "only once", "but only once",
    "but not before", "not before",
)  # fmt: skip


@rule
def linked(p: Parser, i: int) -> Results[str]:
    """How a clause goes on: the word for it in a chain's links."""
    j = p.opt(i, ",", ";")
    later = p.any_of(j, THEN)
    if k := _once_done(p, j):
        yield "then", emphasised(p, k)
    elif (k := p.any_of(j, _EARLIER) or (p.seq(j, "before that") if p.follows(j, (",",)) else 0)) and later <= k:
        yield "after", p.opt(k, ",")
    elif (k := later) and not (p.words[k - 1] == "next" and p.words[k] == "to"):
        yield "then", emphasised(p, k)
    elif k := p.any_of(j, ("before you", "before the robot", "before")):
        yield "before", k
    elif k := p.any_of(j, ("after",)):
        yield "after", k
    elif k := p.any_of(j, ("or else", "or")):
        yield "or", k
    elif k := p.any_of(j, _ALSO):
        both = p.opt(k, "also", "both")
        yield "and", both
        if p.words[k] == "that" and p.rarely(_TELLING):
            yield "and", k + 1
        if both > k and p.words[k] == "both":
            yield "and", k
        if p.words[k : k + 1] == [","]:
            yield "and", k + 1
    elif j > i or p.any_of(j, RATHER):
        yield "and", j


RATHER = ("rather than", "instead of", "as opposed to")
"""These stand for "and not" in front of what is denied."""
_AND_THEN = ("and then", "and", "then", "but")
_NO_STEP = frozenset({"make", "have", "leave", "keep", "let", "check", "see", "ensure", "get", "be"})
"""Verbs that may tell of the end alone."""


def _once_done(p: Parser, i: int) -> int:
    """ "(red on blue,) then, when that is done, (green on red)": the position behind it."""
    j = p.opt(p.any_of(i, _AND_THEN) or i, ",")
    if k := max(AFTER_THAT.matches(p, j), default=0):
        return k
    k = max(WHEN_OVER.matches(p, j), default=0)
    return k if next_step(p, k) else 0


_NOT_BEFORE = tuple(
    f", {lead}{only}"
    for lead in ("and ", "but ", "")
    for only in ("not before", "not before that", "only then", "not earlier", "only after that", "no sooner")
)


def emphasised(p: Parser, k: int) -> int:
    """ "After that, and not before, ...": the position behind what says it again."""
    return p.opt(p.any_of(k - (p.words[k - 1] == ","), _NOT_BEFORE) or k, ",")


def next_step(p: Parser, k: int) -> bool:
    """Whether what stands behind "when you are done" is one more thing to do."""
    forms = p.lex(k, lexicon.VERB) or () if k else ()
    return any(form == "base" and lemma not in _NO_STEP for _, lemma, form in forms)


_TELLING = frozenset({"see", "sees", "shows", "show", "want", "sure", "expect", "means", "such", "so", "when", "is"})
"""What has several clauses with "that" behind it."""
_ALSO = ("and also", "and make sure that", "and ensure that", "and", "while also", "while", "but also", "but",
    "as well as", "also", "whereas", "&",
         "yet", "and yet", "but yet", "although", "though", "except that", "only that",
         "with the exception that")  # fmt: skip


def all_in_one(item: Meaning) -> bool:
    """ "(put A, B and C in order,) all in one row": said of the same blocks, as it stands."""
    all_ = isinstance(item, Clause) and isinstance(item.theme, Pronoun) and item.theme.word == "all"
    return all_ and all(isinstance(a, Into | Size) for a in getattr(item, "adjuncts", ()))


def other_side(p: Parser, k: int, previous: Clause, item: Meaning) -> bool:
    """ "red is left of blue and green right": right of it, or on the right of the table?"""
    sides = [a for a in previous.adjuncts if isinstance(a, Loc) and a.rel in _SIDES and a.landmark is not None]
    bare = isinstance(item, Clause) and item.cost == 3 and len(item.adjuncts) == 1 and isinstance(item.adjuncts[0], In)
    return bool(sides) and bare and p.words[k - 1] in _SIDES


_SIDES = frozenset({"left", "right", "front", "behind", "back"})


def last_of_the_order(p: Parser, j: int, previous: Clause, item: Meaning) -> bool:
    """ "From left to right: A, B, C, with D on C": C is the last of the order, and not all of a clause."""
    ordered = any(isinstance(a, OrderBy) and a.items and a.span[1] == previous.span[1] for a in previous.adjuncts)
    told = getattr(item, "adjuncts", ()) if ordered and p.words[j - 1] == "," else ()
    return bool(told) and all(isinstance(a, Absolute) for a in told)
