"""What a place is told from: "red on green, not on blue", "..., not the blue one", "the others elsewhere"."""

from __future__ import annotations

from rpg.language.grammar.clauses.links import RATHER
from rpg.language.grammar.clauses.turned import REST, not_turned
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Coord, In, Loc, Meaning, Noun, Pronoun, replace

_ELSEWHERE = ("elsewhere", "somewhere else")
_MUST_BE = ("should be", "must be", "has to be", "have to be", "goes", "go", "stays", "stay", "belongs", "belong", "is",
            "are", "remains", "remain", "should stay", "must stay", "should go", "must go", "lie")  # fmt: skip


def elsewhere(p: Parser, i: int, before: Clause) -> Results[Meaning]:
    """ "..., not the blue block", "... and no blue one", "..., the others elsewhere": the place before, denied.

    Behind a place on, or beside, a block it is this block that another is told from: "red on green, not (on) blue".
    """
    place = before.adjuncts[0] if len(before.adjuncts) == 1 and before.verb in ("be", "place") else None
    yield from not_turned(p, i, before)
    if not isinstance(place, Loc | In) or place.negated or before.negated:
        return
    mark = place.landmark if isinstance(place, Loc) else None
    colored = isinstance(mark, Noun) and mark.head == "patch" and bool(mark.traits.colors)
    denied = p.one(i, "not") or p.any_of(i, RATHER)
    for theme, j in noun_phrase(p, denied or i):
        told = isinstance(theme, Noun | Coord) or (isinstance(theme, Pronoun) and theme.word in REST)
        ends = p.any_of(p.any_of(j, _MUST_BE) or j, _ELSEWHERE) if not denied else 0
        flat = isinstance(place, In) or (isinstance(mark, Noun) and mark.head == "patch")
        one = flat and isinstance(theme, Noun) and bool(theme.traits.colors)  # "on the mat, but not the white one"
        block = isinstance(theme, Noun) and (theme.head == "block" or ((theme.det == "bare" or one) and not colored))
        block = block or (one and several(before.theme))  # "(A, B and C on the white mat), but not the red one"
        block = block or (flat and isinstance(theme, Pronoun) and theme.word in REST)
        ended = j >= p.end or p.words[j] in (",", ";")
        none = getattr(theme, "det", "") == "no" or (getattr(theme, "op", "") == "nor" and not colored)
        if not denied and ended and flat and none and getattr(theme, "head", "") != "patch":
            yield replace(before, theme=theme, span=p.span(i, j), cost=0), j
        only = getattr(before.theme, "op", "") == "only" and isinstance(theme, Noun)
        block = block or only or (getattr(place, "rel", "") == "touching" and isinstance(theme, Noun))
        block = (
            block
            or getattr(theme, "word", "") == "each other"
            or (_the_one(theme) and (_beside(place) or _borne(before)))
        )
        if denied and block and ended and isinstance(place, Loc) and _blocks(mark) and not (only or _borne(before)):
            yield replace(before, theme=same_as(before), adjuncts=(replace(place, landmark=theme),), negated=True,
                          span=p.span(i, j), cost=0), j  # fmt: skip
            continue
        if denied and block and ended:
            ends = j
        if told and ends:
            yield replace(before, theme=theme, negated=True, span=p.span(i, ends), cost=0), ends


def several(theme: Meaning | None) -> bool:
    """Blocks that are named one by one."""
    return isinstance(theme, Coord) or (isinstance(theme, Noun) and len(theme.traits.colors) > 1)


def _blocks(mark: Meaning | None) -> bool:
    return isinstance(mark, Coord) or (isinstance(mark, Noun) and mark.head != "patch")


def _the_one(theme: Meaning) -> bool:
    """ "(next to the blue one,) not the green one": on it, this could be the other one that is not there."""
    return isinstance(theme, Noun) and (theme.head, theme.det) == ("any", "the") and bool(theme.traits.colors)


def _beside(place: Meaning) -> bool:
    return isinstance(place, Loc) and place.rel in ("beside", "adjacent", "near") and _blocks(place.landmark)


def _borne(before: Clause) -> bool:
    """ "Blue carries white, not red": what lies on something is told behind it, and so is what does not."""
    mark = getattr(before.adjuncts[0], "landmark", None)
    return before.theme is not None and mark is not None and bool(mark.span < before.theme.span)


def same_as(before: Clause) -> Meaning | None:
    """What the clause before speaks of, once more."""
    return Pronoun(word="same", span=before.theme.span) if before.theme is not None else None
