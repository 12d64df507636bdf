"""What joins clauses: "and", "then", "or", "before", "once that is done"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.commands import AFTER_THAT, THEN, WHEN_OVER
from rpg.language.meaning import (
    Absolute,
    At,
    Clause,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Size,
    Structure,
    Toward,
    Traits,
    parts_of,
    replace,
)

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
        if p.stands(j, ("that",)) and "that" in p.words[:i] and p.rarely(_TELLING):
            yield "and", j + 1  # "make sure that A is there, that B is here"


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


def told_of_it(p: Parser, j: int, k: int, previous: Clause, item: Meaning) -> bool:
    """Whether what looks like a clause is an end of the line before it, or leaves open what it is beside."""
    return _sorts(p, j, previous, item) or _other_side(p, j, k, previous, item)


def _sorts(p: Parser, j: int, previous: Clause, item: Meaning) -> bool:
    """ "(In a row,) the largest on the left": without a verb that is how the row is ordered."""
    end = _extreme_there(item)
    if p.words[j - 1] != "," or end is None or not any(isinstance(a, Into) for a in previous.adjuncts):
        return False
    theme, place = end.theme, end.adjuncts[0]
    bare = isinstance(theme, Noun) and theme.head == "any" and theme.traits.kind is None
    return bare and place.span[0] - theme.span[1] <= 1


def _sorted_from(before: Clause, item: Meaning) -> Absolute | None:
    """What is at which end of the line that is sorted."""
    end = _extreme_there(item)
    ordered = any(isinstance(a, OrderBy) and a.by in _SORTED for a in before.adjuncts)
    directed = any(isinstance(a, Toward | Absolute) for a in before.adjuncts)
    return end if ordered and not directed else None


def _extreme_there(item: Meaning) -> Absolute | None:
    """ "The largest (is) on the left"."""
    if not isinstance(item, Clause) or item.verb not in ("be", "arrange", "place") or item.negated:
        return None
    theme, place = item.theme, item.adjuncts[0] if len(item.adjuncts) == 1 else None
    if not isinstance(theme, Noun) or not isinstance(place, At) or place.index is not None or place.side == "middle":
        return None
    look = theme.traits
    extreme = look.rank in ("smallest", "largest") and look == Traits(rank=look.rank, kind=look.kind)
    return Absolute(theme=theme, adjuncts=(place,), span=item.span) if extreme else None


_SORTED = ("attribute", "number", "size", "in_order")


def _other_side(p: Parser, j: int, k: int, previous: Clause, item: Meaning) -> bool:
    """ "Red is left of blue and green right", "blue left, green right of red", "red left, blue behind": is what has no
    landmark beside that of the other, or is it a side of the table?"""
    one, two = (_bare_side(p, end, clause) for end, clause in ((j - 1, previous), (k, item)))
    return (one and _beside_something(item)) or (two and _beside_something(previous))


def _bare_side(p: Parser, end: int, clause: Meaning) -> bool:
    """ "Green right": with no word before the side that would tell whose it is."""
    bare = isinstance(clause, Clause) and clause.cost == _ELLIPTIC and len(clause.adjuncts) == 1
    return bare and isinstance(getattr(clause, "adjuncts", ((),))[0], In) and p.words[end - 1] in _SIDES


def _beside_something(clause: Meaning) -> bool:
    """ "Left of blue"; and "behind" and "in front" by themselves, which are told of blocks."""
    told = [x for a in getattr(clause, "adjuncts", ()) for x in parts_of(a)]
    landmarks = any(isinstance(x, Loc) and x.rel in _SIDES and x.landmark is not None for x in told)
    return landmarks or any(isinstance(x, At) and x.side in ("front", "back") for x in told)


_ELLIPTIC = 3
"""What a side of the table costs that is told by its name alone."""
_SIDES = frozenset({"left", "right", "front", "behind", "back"})


def last_of_the_order(p: Parser, j: int, previous: Clause, item: Meaning) -> bool:
    """ "From left to right: A, B, C, with D on C": C is the last of the order, and not all of a clause."""
    ordered = any(isinstance(a, OrderBy) and a.items and a.span[1] == previous.span[1] for a in previous.adjuncts)
    told = getattr(item, "adjuncts", ()) if ordered and p.words[j - 1] == "," else ()
    return bool(told) and all(isinstance(a, Absolute) for a in told)


def told_again(before: Clause, item: Meaning) -> Clause | None:
    """ "1 + 8 = 9 made with cubes, equation in a row": a bare noun for what was built carries on about it; "(sorted by
    value,) and the largest is on the left": so it is sorted from there on."""
    if (end := _sorted_from(before, item)) is not None:
        return replace(before, adjuncts=(*before.adjuncts, end))
    theme, built = (item.theme if isinstance(item, Clause) else None), before.theme
    if not (isinstance(theme, Structure) and isinstance(built, Structure) and isinstance(item, Clause)):
        return None
    plain = Structure(kind=built.kind, det="bare", span=theme.span)
    same = replace(theme, cost=0) == plain and before.verb == item.verb
    return replace(before, adjuncts=(*before.adjuncts, *item.adjuncts)) if same else None


def now_again(p: Parser, start: int) -> int:
    """ "(Put red on the mat.) Now put it on blue.": the position behind a "now" that tells of the next step."""
    j = p.one(start, "now")
    verb = j and any(form == "base" for _, _, form in p.lex(j, lexicon.VERB) or ())
    return p.opt(j, ",") if verb and p.stands(j + 1, ("it", "them")) else 0
