"""Clauses whose subject has something: "the red block should have the blue one on it"."""

from __future__ import annotations

from dataclasses import replace

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.nouns import noun_phrase
from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Loc,
    Meaning,
    Noun,
    PartOf,
    Places,
    Pronoun,
    Structure,
    TableTop,
    That,
)

_HAS = (
    "should have", "must have", "has to have", "needs to have", "shall have", "will have", "has", "have",
    "ends up with", "gets",
    "get", "should get", "needs", "should end up with", "must end up with", "should be left with",
)  # fmt: skip
_CARRIES = (
    "should carry", "must carry", "carries", "carry", "should hold", "must hold", "holds", "supports", "should support",
    "must support", "bears", "should bear", "must contain", "should contain", "contains",
)  # fmt: skip


@rule
def having(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "the red block should have the blue one on it", "the patch must contain two blocks", "A has B to its left"."""
    for owner, j in noun_phrase(p, i):
        if isinstance(owner, Pronoun | TableTop):
            continue
        if k := p.any_of(j, _HAS):
            for theme, start in noun_phrase(p, k):
                if (lying := _on_patch(owner, theme, p.span(i, start))) is not None:
                    yield _stated(p, i, start, *lying, mode), start
                for found, end in adjuncts(p, start):
                    if isinstance(owner, Structure) and owner.members is not None and _parts(found):
                        detail = Absolute(theme=theme, adjuncts=found, span=p.span(k, end))
                        built = Clause(verb="build", theme=owner, adjuncts=(detail,), mode=mode, span=p.span(i, end))
                        yield built, end
                        continue
                    places = _owned(found, owner)
                    if places is not None:
                        stated = _stated(p, i, end, theme, places, mode)
                        yield stated, end
                        yield from _another(p, i, end, owner, stated, mode)
        if k := p.any_of(j, _CARRIES):
            for theme, start in noun_phrase(p, k) if not _symbols(p, k) else ():
                for found, end in adjuncts(p, start):
                    if not found or _owned(found, owner) is not None:
                        place = Loc(rel="on", landmark=owner, span=p.span(i, j))
                        yield _stated(p, i, end, theme, (place,), mode), end


def _symbols(p: Parser, i: int) -> bool:
    """ "five cubes carry the letters A to E": what they show, not what lies on them."""
    word = p.words[p.opt(i, "the")]
    return any(word in table for table in (lexicon.LETTER, lexicon.DIGIT, lexicon.SYMBOL)) and word.endswith("s")


def _another(p: Parser, i: int, at: int, owner: Meaning, first: Clause, mode: str) -> Results[Meaning]:
    """ "... and the white block on its right": a second thing that the owner has."""
    joint = p.one(p.opt(at, ","), "and")
    for theme, j in noun_phrase(p, joint) if joint else ():
        for found, end in adjuncts(p, j):
            if (places := _owned(found, owner)) is not None:
                stated = replace(_stated(p, joint, end, theme, places, mode), cost=0)
                second = Chain(clauses=(stated,), links=("and",), span=theme.span)
                told = That(kind="so", clauses=second, span=second.span)
                yield replace(first, adjuncts=(*first.adjuncts, told), span=p.span(i, end)), end


def _on_patch(owner: Meaning, theme: Meaning, span: Span) -> tuple[Meaning, tuple[Meaning, ...]] | None:
    """ "each patch has one block", "each letter gets its own patch": what lies on what."""
    if not (isinstance(owner, Noun) and isinstance(theme, Noun)) or (owner.head == "patch") == (theme.head == "patch"):
        return None
    if theme.head == "patch" and theme.traits.scheme != "different":
        return None
    block, patch = (theme, owner) if owner.head == "patch" else (owner, theme)
    return block, (Loc(rel="on", landmark=patch, span=span),)


def _parts(found: tuple[Meaning, ...]) -> bool:
    return bool(found) and all(isinstance(part, At | Places) for part in found)


def _owned(found: tuple[Meaning, ...], owner: Meaning) -> tuple[Meaning, ...] | None:
    """The places with the owner where they say "it" or leave it unsaid; None where they speak of something else."""
    if not found:
        return None
    places: list[Meaning] = []
    for part in found:
        if isinstance(part, Loc) and _is_owner(part.landmark):
            places.append(replace(part, landmark=owner))
        elif isinstance(part, At) and part.side in ("top", "left", "right") and part.index is None:
            places.append(Loc(rel={"top": "on"}.get(part.side, part.side), landmark=owner, span=part.span))
        else:
            return None
    return tuple(places)


def _is_owner(landmark: Meaning | None) -> bool:
    if isinstance(landmark, PartOf) and landmark.part == "top":
        return _is_owner(landmark.whole)
    return landmark is None or (isinstance(landmark, Pronoun) and landmark.word in ("it", "them", "itself"))


def _stated(p: Parser, i: int, end: int, theme: Meaning, places: tuple[Meaning, ...], mode: str) -> Clause:
    verb = "build" if isinstance(theme, Structure) else "be"
    return Clause(verb=verb, theme=theme, adjuncts=places, mode=mode, span=p.span(i, end), cost=1)
