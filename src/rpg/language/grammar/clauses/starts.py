""" "It starts as red on blue", "the tower starts with A on B on C": a structure of the start by what it is made of."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.clauses.told_piled import begun_piled
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.piled import piled
from rpg.language.grammar.things.labels import literal
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Amount, Clause, Loc, Manner, Meaning, Noun, Pronoun, Structure, Traits, replace

STARTS = ("starts off", "starts out", "starts", "start", "begins", "begin", "started", "starting", "start off",
          "start out", "starts the episode",
          *(f"initially {is_}" for is_ in ("is", "sits", "stands", "lies", "rests", "are", "sit", "stand", "lie",
                                           "rest")))  # fmt: skip


def starts_as(p: Parser, i: int, at: int, theme: Meaning) -> Results[Meaning]:
    """What follows "starts" at `at` where it is the structure itself that is told."""
    j = p.any_of(at, ("as", "out as", "with", "off as")) or at
    it = isinstance(theme, Pronoun) and theme.word == "it"
    the = isinstance(theme, Structure) and theme.det == "the" and theme.members is None
    yield from _as_a_word(p, i, j, theme)
    yield from begun_piled(p, i, at, theme)
    for first, k in simple(p, j) if j and (it or the) else ():
        for found, end in adjuncts(p, k):
            if isinstance(first, Structure) and first.members is not None:
                span = p.span(i, end)
                yield Clause(verb="exist", lemma="begun", theme=first, adjuncts=found, mode="given", span=span), end
            upright = all(isinstance(a, Loc) and a.rel in ("on", "above") for a in found)
            if isinstance(first, Noun) and found and upright:
                yield piled(Clause(verb="be", theme=first, adjuncts=found, mode="start", span=p.span(i, end))), end


_IN_A_ROW = ("in a row as", "in a line as", "lined up as", "side by side as", "in the order", "in a row :")
_SHOWN = frozenset({"row", "line", "stack", "word", "column"})


def _as_a_word(p: Parser, i: int, j: int, theme: Meaning) -> Results[Meaning]:
    """ "The row (of letters) starts as TAC", "the letters start as TAC": what can be read there."""
    j = p.any_of(j, _IN_A_ROW) or j
    text = literal(p, p.any_of(j, ("the word", "word", "spelling", "reading")) or j)
    line = isinstance(theme, Structure) and theme.kind in _SHOWN and theme.det == "the" and not theme.plural
    members = theme.members if line and isinstance(theme, Structure) else theme
    plain = Traits(kind="letter")
    letters = isinstance(members, Noun) and members.traits in (plain, Traits()) and members.head == "block"
    named = isinstance(members, Noun) and text is not None and sorted(members.traits.labels) == sorted(text)
    if text is None or len(text) < 2 or not (letters or named or (line and members is None)):
        return
    end = (p.any_of(j, ("the word", "word", "spelling", "reading")) or j) + 1
    word = Structure(kind="word", det="the", letter=text, span=p.span(j, end))
    down = isinstance(theme, Structure) and theme.kind == "stack"
    for more, last in adjuncts(p, end) if not down else ():
        yield Clause(verb="spell", theme=word, adjuncts=more, mode="start", span=p.span(i, last)), last


_ENDINGS = "end ends finally final goal finish finishes afterwards later then result should must"
_ENDING = frozenset(_ENDINGS.split())


def still_begun(p: Parser, j: int, k: int, before: Clause | None, item: Meaning) -> Meaning:
    """ "Initially red is on blue and green is on yellow": a further fact is of the start too, unless it says when."""
    if before is None or before.mode != "start" or not isinstance(item, Clause):
        return item
    fact = (item.lemma, item.mode) == ("fact", "goal") and _ENDING.isdisjoint(p.words[j:k])
    fact = fact and not any(isinstance(a, Manner) and a.kind == "time" for a in item.adjuncts)
    return replace(item, mode="start") if fact and not item.negated else item


def begun_of(before: Meaning | None, item: Meaning) -> Meaning:
    """ "Reverse the row: it starts as ...": "it" is the row, of which nothing else is known."""
    it = isinstance(item, Clause) and isinstance(item.theme, Pronoun) and item.theme.word == "it"
    shape = before.theme if isinstance(before, Clause) and before.verb == "reverse" else None
    if not isinstance(item, Clause) or not it or item.mode != "start" or not isinstance(shape, Structure):
        return item
    return replace(item, theme=shape)


_MOVING = frozenset({"go", "goes", "comes", "come"})


def first_of_all(p: Parser, j: int) -> bool:
    """ "The red block first goes to the mat, ...", "it must first be on the mat and then ...": before anything else."""
    if p.stands(j + 1, ("been",)) or p.follows(j, ("the", "a", "an")):  # "it has first been put there", "the first is"
        return False
    return p.stands(j, ("first",)) and (p.stands(j + 1, lexicon.POSTURE) or p.stands(j + 1, ("visits", "moves")))


def perhaps_first(p: Parser, k: int, item: Meaning, mode: str) -> Meaning:
    """ "At the start red goes on blue", with its verb at `k`: so it is then, or a command to do it first."""
    if p.follows(k, ("first",)) and first_of_all(p, k - 1) and isinstance(item, Clause):
        now = Manner(kind="time", value=1.0, span=p.span(k - 1, k))
        return replace(item, adjuncts=(now, *item.adjuncts))
    if p.words[k] not in _MOVING or not isinstance(item, Clause):
        return item
    said = any(isinstance(a, Manner) and a.kind == "start" for a in item.adjuncts)
    begun = (Manner(kind="start", span=p.span(k, k + 1)),) if mode == "start" and not said else ()
    return replace(item, mode="command", adjuncts=(*item.adjuncts, *begun)) if said or begun else item


_ALREADY = ("initially", "currently", "starting out", "starting", "beginning")


def begun_with(p: Parser, i: int) -> Results[Clause]:
    """ "With the red block on the green one at the start, ...": how it begins. "Already" may mean the end too."""
    yield from _begun_from(p, i)
    j = p.one(i, "with")
    for theme, k in noun_phrase(p, j) if j else ():
        told = p.any_of(k, _ALREADY)
        for found, end in adjuncts(p, told or k):
            when = [a for a in found if isinstance(a, Manner) and a.kind == "start"]
            places = tuple(a for a in found if a not in when)
            comma = p.opt(end, ",", ":")
            if p.words[k] == "already":
                continue
            if comma > end and places and all(isinstance(a, Loc) for a in places) and (told or when):
                yield Clause(verb="be", theme=theme, adjuncts=places, mode="start", span=p.span(i, end)), comma


def _begun_from(p: Parser, i: int) -> Results[Clause]:
    """ "From a(n initial) tower of three gray blocks, a row shall be made": how it begins."""
    j = p.any_of(i, ("from", "out of"))
    first = p.one(p.opt(j, "a", "an", "the"), ("initial", "existing", "given")) if j else 0
    for theme, k in simple(p, first or j) if j else ():
        line = isinstance(theme, Structure) and theme.kind in _LINES and theme.members is not None
        if line and isinstance(theme, Structure) and not theme.plural and p.stands(k, (",",)):
            told = replace(theme, det="a", amount=Amount(1, 1), span=p.span(i, k))
            yield Clause(verb="exist", lemma="begun", theme=told, mode="given", span=p.span(i, k)), p.reach(k + 1)


_LINES = frozenset({"stack", "row", "line", "column"})
