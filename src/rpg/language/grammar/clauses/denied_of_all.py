"""How much "not" denies: each of several things, or all of them together."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.grammar.core import Parser
from rpg.language.grammar.things.retold import denied_of
from rpg.language.meaning import Clause, Coord, In, Loc, Manner, Meaning, Noun, replace

_NOT = frozenset({"not", "never"})
_ALL = (["both"], ["all"])
REACH = 3
"""So many words on "not" is looked for: "are not", "must not", "do not"."""


def denied_of_all(p: Parser, j: int, found: Clause) -> Clause:
    """ "are not both ...", "must not all be ...", "do not put both ...": it may be so of some of them."""
    if not found.negated and found.theme is not None and denied_of(found.theme):
        return _of_none(p, j, found)
    denial = next((k for k in range(j, min(j + REACH, p.end)) if _denies(p, k)), None)
    if denial is None or not found.negated:
        return found
    ahead = found.verb == "be" and found.theme is not None and found.theme.span[1] <= p.char(denial, 0)
    if ahead and _so_many(found.theme):
        some = Manner(kind="not all", value="of them", span=found.span)
        return replace(found, adjuncts=(*found.adjuncts, some))
    skipped = p.words[denial + 1 : denial + 2] in (["be"], *([word] for word in _verbs(found)))
    at = denial + 1 + skipped
    if p.words[at : at + 1] not in _ALL and not _of_both(p, at, found):
        return found
    return replace(found, adjuncts=(*found.adjuncts, Manner(kind="not all", span=found.span)))


def _denies(p: Parser, k: int) -> bool:
    return p.words[k] in _NOT or p.words[k : k + 2] == ["no", "longer"]


def _of_none(p: Parser, j: int, found: Clause) -> Clause:
    """ "(None of them) may be both near red and on the mat", "... and in the left half at once": not in both places."""
    places = [a for a in found.adjuncts if isinstance(a, Loc | In | Coord)]
    first = min((a.span[0] for a in places), default=0)
    ahead = {t.word for t in p.tokens[j:] if t.span[1] <= first} | _behind_first(p, places)
    hurried = [a for a in found.adjuncts if isinstance(a, Manner) and a.value == "pace at once"]
    if "both" not in ahead and not (hurried and len(places) > 1):
        return found
    rest = tuple(a for a in found.adjuncts if a not in hurried or len(places) < 2)
    return replace(found, adjuncts=(*rest, Manner(kind="not all", span=found.span)))


def _behind_first(p: Parser, places: Sequence[Meaning]) -> set[str]:
    """The words of the only place: "near both A and B"."""
    begin, end = places[0].span if len(places) == 1 else (0, 0)
    return {t.word for t in p.tokens if begin <= t.span[0] and t.span[1] <= end}


def _so_many(theme: Meaning | None) -> bool:
    """ "at least one of the red blocks (is not)", "exactly two red blocks (are not)": so many are not, and no more is
    said of the others."""
    if not isinstance(theme, Noun) or theme.amount is None or theme.det in ("no", "any", "all", "both", "the"):
        return False
    many = theme.amount
    return (many.low > 0 or bool(many.high)) and (many.strict or theme.part_of is not None)


def _of_both(p: Parser, at: int, found: Clause) -> bool:
    """ "is not left of both red and blue", "is not on both patches"."""
    end = next((k for k in range(at, p.end) if p.tokens[k].span[0] >= found.span[1]), p.end)
    return "both" in p.words[at:end] and any(isinstance(a, Loc) and a.landmark is not None for a in found.adjuncts)


def _verbs(clause: Clause) -> tuple[str, ...]:
    return tuple(clause.lemma.split()[:1])
