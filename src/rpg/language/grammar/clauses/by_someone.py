"""What somebody has done is so now: "someone dumped five blocks in a heap", "my son has put red on blue"."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.verbs import verb_phrase
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.people import WHO
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Coord, In, Into, Loc, Meaning, Noun, OrderBy, Structure, replace
from rpg.language.phrases import Classes

_SOMEBODY = Patterns("<which> <folk>", "i|we|you|he|she|they|people|somebody|someone", classes=Classes(WHO))
_ADVERBS = ("already", "just", "accidentally", "carelessly")
_SEVERAL = frozenset({"i", "we", "you", "they", "people", "children", "class", "team", "folks", "family"})
"""Of whom "put" may be told now; of anybody else it is told in the past: today it would be "puts"."""
_SAME = frozenset({"put", "set", "spread", "split"})
"""Verbs whose past is as they are."""
_FLUNG = ("threw", "thrown", "tossed", "dumped", "left", "tipped", "poured", "scattered", "spilled", "emptied")
_DONE = frozenset({"place", "stack", "build", "arrange"})
_GONE = frozenset({"off", "moved"})


@choice
def by_someone(p: Parser, i: int) -> Results[Meaning]:
    """A fact of the start; what the robot has done is so at the end, and told elsewhere."""
    for k in _SOMEBODY.matches(p, i):
        had = p.any_of(k, ("has", "have", "had"))
        j = p.any_of(had or k, _ADVERBS) or had or k
        same = p.stands(j, _SAME)
        several = p.follows(k, _SEVERAL) or p.words[k - 1].endswith("s")
        if same and several and not had:
            continue
        for found, end in [*verb_phrase(p, j, ("past", "base") if same else ("past",)), *_flung(p, i, j)]:
            places = all(isinstance(x, Loc | In | Into | OrderBy) for x in found.adjuncts)
            gone = any(isinstance(x, Loc) and x.rel in _GONE for x in found.adjuncts)
            if found.verb in _DONE and places and not gone and _named(found):
                yield replace(found, mode="start", span=p.span(i, end)), end


def _flung(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "threw four blocks on the table", "left the red block on the mat": where they are since."""
    thrown = p.any_of(j, _FLUNG)
    for theme, k in noun_phrase(p, thrown) if thrown else ():
        for found, end in adjuncts(p, p.opt(k, "down")):
            if found:
                said = Clause(verb="be", lemma="fact", theme=theme, adjuncts=found, mode="start", span=p.span(i, end))
                yield replace(said, verb="place", lemma="put", word=p.span(j, thrown)), end


def _named(found: Clause) -> bool:
    """Whether it is said of which blocks, and how they are."""
    if isinstance(found.theme, Structure):
        return found.theme.members is not None or bool(found.adjuncts)
    return isinstance(found.theme, Noun | Coord) and (bool(found.adjuncts) or found.verb == "stack")
