""" "Any red block must be left of any blue block", "any two must be 12 cm apart": whichever one takes, it is so.

Where "any" may as well leave a choice, it is asked: "any red block must be on the mat".
"""

from __future__ import annotations

import re

from rpg.core.diagnostics import Span
from rpg.language.meaning import Chain, Clause, In, Loc, Meaning, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.things.world import refuse

_SIDES = frozenset({"left", "right", "front", "behind"})
_CLOSE = frozenset({"beside", "adjacent", "side_by_side", "touching"})
"""Of more than three blocks not every two can be so."""
_FAR = frozenset({"distance", "apart", "near"})
_EVERY = frozenset({"any", "each", "all"})


def whichever(chain: Chain, text: str) -> Chain:
    """The sentence with "any" as what it means of states that are wanted."""
    clauses = tuple(_told(c, text) if isinstance(c, Clause) else c for c in chain.clauses)
    return chain if clauses == chain.clauses else replace(chain, clauses=clauses)


def _told(clause: Clause, text: str) -> Clause:
    many = text[slice(*clause.theme.span)].lower() if isinstance(clause.theme, Noun) else ""
    if many.startswith("any number of") and any(isinstance(a, Loc | In) for a in clause.adjuncts):
        raise refuse("ambiguous", "any number may be none, or all", clause.theme.span if clause.theme else clause.span,
                     "say how many, such as 'at least one of ...'")  # fmt: skip
    if clause.verb not in ("be", "place") or clause.mode != "goal" or clause.negated or len(clause.adjuncts) != 1:
        return clause
    place = clause.adjuncts[0]
    if isinstance(place, Loc) and getattr(place.landmark, "word", "") == "each other":
        return _of_two(clause, place, text)
    mark = place.landmark if isinstance(place, Loc) else None
    if isinstance(place, Loc) and isinstance(mark, Noun) and _any(mark, text) and mark.head != "patch":
        return _of_any(clause, place, mark, text)
    theme = clause.theme
    on_block = isinstance(place, Loc) and place.rel in ("on", "above") and getattr(mark, "head", "") != "patch"
    if on_block or not isinstance(theme, Noun) or theme.part_of is not None or theme.head == "patch":
        return clause
    between = text[theme.span[1] : place.span[0]]
    if _any(theme, text) and _DEMANDED.search(between) is not None and " you " not in between:
        raise _unclear(theme.span)
    return clause


_DEMANDED = re.compile(r"\b(?:must|should|shall|has to|have to|needs? to|ought to|is|are)\b", re.IGNORECASE)
"""With these it may be said of every one; "any blue block goes on the mat" leaves a choice."""


def _any(noun: Noun, text: str) -> bool:
    """Whether this is "any" without a number: "either" and "one of" leave a choice, and so does "any you like"."""
    said = text[slice(*noun.span)].lower()
    return noun.det == "any" and noun.amount is None and said.startswith("any ") and " you " not in said


def _of_any(clause: Clause, place: Loc, mark: Noun, text: str) -> Clause:
    """What is said of whichever landmark: of each, if it is a side of it, or far from it."""
    theme = clause.theme
    far = place.rel == "apart" or (place.rel == "distance" and place.low is not None and place.high is None)
    if not isinstance(theme, Noun) or place.negated or place.rel not in _SIDES | _CLOSE | _FAR or theme.head == "patch":
        return clause
    if theme.det == "no":
        return clause
    several = theme.det in _EVERY and theme.amount is None
    if several and (far or (place.rel in _SIDES and clause.word is not None)):
        each = replace(place, landmark=replace(mark, det="each"))
        return replace(clause, theme=replace(theme, det="each"), adjuncts=(each,))
    if place.rel in _SIDES or (several and _any(theme, text)):
        raise _unclear(mark.span)
    return clause


def _of_two(clause: Clause, place: Loc, text: str) -> Clause:
    """What is said of any two to each other: of every two, if all of them can be so."""
    theme = clause.theme
    many = theme.amount if isinstance(theme, Noun) else None
    if not isinstance(theme, Noun) or many is None or many.low != many.high or many.low < 2:
        return clause
    if not text[slice(*theme.span)].lower().startswith("any ") or place.negated:
        return clause
    if place.rel in _CLOSE:
        raise refuse("ambiguous", "every two of them, or only two?", theme.span, "say 'every two of ...', 'all of "
                     "them', or 'exactly two of ...'")  # fmt: skip
    if place.rel not in _FAR:
        return clause
    mutual = replace(place, mods=tuple(dict.fromkeys((*place.mods, "mutual"))))
    return replace(clause, theme=_whole(theme), adjuncts=(mutual,))


def _whole(theme: Noun) -> Meaning:
    """All those of which any two are spoken of."""
    if theme.part_of is not None:
        return theme.part_of
    if theme.head == "any" and theme.traits == Traits():
        return Pronoun(word="them", span=theme.span)
    return replace(theme, det="all", amount=None)


def _unclear(span: Span) -> Exception:
    return refuse("ambiguous", "'any' could mean every one of them, or just one of them", span, "say 'every ...', or "
                  "'at least one of ...'")  # fmt: skip
