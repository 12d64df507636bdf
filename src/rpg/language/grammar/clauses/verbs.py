"""Verbs with their themes and adjuncts, in commands and after "without"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjuncts, throughout
from rpg.language.grammar.clauses.again import meant_again, said_too
from rpg.language.grammar.clauses.covered import named_last
from rpg.language.grammar.clauses.for_whom import behind_us
from rpg.language.grammar.clauses.kept_stacked import kept_stacked
from rpg.language.grammar.clauses.manners import degrees_of
from rpg.language.grammar.clauses.particles import WHITHER, across, added
from rpg.language.grammar.clauses.pointing import direction
from rpg.language.grammar.clauses.put_back import picked_out, put_back
from rpg.language.grammar.clauses.remade import of_what_is_there, put_down, read_otherwise, remade, reverse, taken_off
from rpg.language.grammar.clauses.separated import KEEPING, kept_separate, separated
from rpg.language.grammar.clauses.spelt import spelling, word_named
from rpg.language.grammar.clauses.them_listed import them_listed
from rpg.language.grammar.clauses.told_from import elsewhere, same_as, several
from rpg.language.grammar.clauses.verb_again import in_line_already
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.its_place import in_its_place
from rpg.language.grammar.places.relations import on_its_own
from rpg.language.grammar.structures.from_an_end import in_turn
from rpg.language.grammar.structures.orders import order
from rpg.language.grammar.structures.sizes import AS_HIGH
from rpg.language.grammar.things.adjectives import adjectives
from rpg.language.grammar.things.likes import like_with_like
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import (
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Quality,
    Structure,
    That,
    Traits,
    Using,
    replace,
)

_PARTICLES = {"place": ("up", "out", "down", "together", "over", "back"), "pick": ("up", "out", "off", "away"),
              "build": ("up", "out", "together"), "stack": ("up", "together"), "unstack": ("down", "apart"),
              "arrange": ("up", "out", "together", "apart"), "sort": ("up", "out", "together"),
              "use": ("up", "out", "down", "together", "over", "around", "back", "off", "away", "aside"),
              "swap": ("over", "around", "round"), "turn": ("over", "around", "up", "down"),
              "keep": ("up", "down", "together", "over", "around", "apart", "back")}  # fmt: skip
"""What may follow a verb without changing what it says."""
PARTICLES = ("up", "out", "down", "together", "over", "around", "apart", "back", "off", "away", "aside")


def ever(found: Clause, never: bool) -> Clause:
    """ "never": at no time, not only at the end."""
    if not never:
        return found
    return replace(found, adjuncts=(*found.adjuncts, Manner(kind="always", span=found.span)))


@rule
def gerund_single(p: Parser, i: int) -> Results[Clause]:
    """ "putting the red block on ..." after "before"."""
    yield from verb_phrase(p, i, ("ing",))


_UP_OR_OUT = ("up", "out", "down", "back")
_BEHIND = {**dict.fromkeys(("stack", "arrange", "place", "unstack"), _UP_OR_OUT), "pick": (*_UP_OR_OUT, "off")}
"""What may follow a verb behind its theme."""


def _no_particle(p: Parser, k: int) -> bool:
    """ "Out of the way", "(put it) back left": these tell where."""
    corner = p.stands(k, _UP_OR_OUT) and p.stands(k + 1, ("left", "right"))
    return bool(p.seq(k, "out of the way")) or (corner and p.words[k + 2] in ("", ",", ".", "and"))


@rule
def verb_phrase(p: Parser, i: int, forms: tuple[str, ...] = ("base",)) -> Results[Clause]:
    """A verb in one of `forms`, its particle, theme and adjuncts."""
    senses = p.lex(i, lexicon.VERB)
    if senses is None or p.tokens[i].kind != "word":
        return
    for sense, lemma, form in senses:
        if form in forms:
            after = _PARTICLES.get(sense, PARTICLES) if lemma != "drop" else (*_PARTICLES[sense], "off")
            for particle in dict.fromkeys((p.opt(i + 1, *after), i + 1)):
                yield from with_theme(p, i, behind_us(p, particle, sense), sense, lemma)


def _its_own_way(p: Parser, i: int, j: int, sense: str, lemma: str) -> Results[Clause]:
    """What follows some verbs and no others."""
    word = p.span(i, i + 1)
    if sense == "turn":
        yield from _turn(p, i, j, lemma)
    yield from spelling(p, i, j, sense, lemma)
    if sense == "reverse":
        yield from reverse(p, i, j)
    if sense == "unstack" and j >= p.end:
        yield Clause(verb=sense, lemma=lemma, theme=Pronoun(word="them", span=word), span=word, word=word), j
    yield from remade(p, i, j, sense, lemma)
    if sense == "sort" or lemma == "put":
        yield from like_with_like(p, i, j, lemma, word)


_PLACES_OF = tuple(
    f"{the}{places} of" for the in ("the ", "") for place in ("place", "position", "location")
    for places in (place, f"{place}s")
)  # fmt: skip


def with_theme(p: Parser, i: int, j: int, sense: str, lemma: str) -> Results[Clause]:
    word = p.span(i, i + 1)
    yield from _its_own_way(p, i, j, sense, lemma)
    if sense in ("spell", "reverse"):
        return
    if sense == "swap":
        j = p.any_of(j, _PLACES_OF) or j
    only = p.one(j, "only") if lemma == "move" else 0
    alone: tuple[Manner, ...] = (Manner(kind="only", span=p.span(j, only)),) if only else ()
    if sense in ("place", "stack") and p.words[j] == "first" and p.words[j + 1] in ("the", "a", "an", "both", "all"):
        alone = (Manner(kind="time", value=1.0, span=p.span(j, j + 1)),)
        j = p.reach(j + 1)
    for theme, k in [*noun_phrase(p, only or j), *them_listed(p, only or j)]:
        if isinstance(theme, Structure) and lemma in ("take", "pull") and p.words[k] in ("down", "apart"):
            continue
        k = across(p, k, sense, told=bool(i or p.char(0, 0)))
        if sense == "swap" and (end := p.one(k, "back")):
            back = Manner(kind="stay", span=p.span(k, end))
            span = p.span(i, end)
            yield Clause(verb="place", lemma="return", theme=theme, adjuncts=(back,), span=span, word=word), end
        yield from taken_off(p, i, k, theme, alone) if sense in ("pick", "use") or lemma in _TAKING else ()
        k = k if _no_particle(p, k) else p.opt(k, *_BEHIND.get(sense, ()))
        k = k + 1 if lemma == "drop" and p.stands(k, ("off",)) and p.stands(k + 1, WHITHER) else k
        k = max(AS_HIGH.matches(p, k), default=k) if sense == "stack" else k
        yield from put_back(p, i, k, theme, word) if sense == "place" else ()
        if sense == "place" and "down" in (p.words[k - 1], p.words[j - 1]):
            yield put_down(theme, lemma, p.span(i, k), word), k
        if sense == "place" and in_its_place(p, k, theme):
            continue
        if sense == "use":
            yield from _use(p, i, k, theme)
        if lemma == "separate":
            yield from separated(p, i, k, theme)
        if sense in KEEPING:
            yield from (*kept_separate(p, i, k, theme), *kept_stacked(p, i, k, theme, lemma))
        if sense in ("keep", "build") and lemma in ("keep", "leave", "make"):
            for marks, end in adjectives(p, k):
                if marks:
                    quality = Quality(traits=Traits(**marks), span=p.span(k, end))
                    yield from throughout(p, i, _is(theme, quality, p.span(i, end), word), end)
        after = [(f, e) for f, e in adjuncts(p, k + 1) if f] if p.words[k : k + 1] == [","] else []
        several = isinstance(theme, Coord) or getattr(theme, "plural", False)
        each = p.one(p.opt(k, ","), "each") if several else 0
        after += [x for x in adjuncts(p, each) if x[0] and on_its_own(x[0][0])] if each else []
        after += adjuncts(p, k - 1) if lemma in ("lift", "pick") and p.words[k - 1] == "off" else []
        for found, end in [*adjuncts(p, k), *after]:
            if found and read_otherwise(p, end, sense, lemma, theme, found):
                continue
            said = (*added(lemma, in_turn(p, j, k, theme, found) if sense == "stack" else found), *alone)
            bare = all(isinstance(x, Manner) and x.kind == "idle" for x in said)  # "take it off again"
            off = sense == "pick" and not {"off", "down", "away"}.isdisjoint((p.words[k - 1], p.words[j - 1]))
            done = Clause(verb=sense, lemma=lemma, theme=theme, adjuncts=said, span=p.span(i, end), word=word)
            yield replace(picked_out(p, j, k, done), cost=int(bare and (sense == "keep" or off))), end
    if sense == "sort" and p.words[j] in ("by", "according"):
        yield from _by_first(p, i, j, lemma)
    if sense in ("stack", "build", "arrange", "sort", "place"):
        for found, end in adjuncts(p, j):
            if found:
                yield Clause(verb=sense, lemma=lemma, adjuncts=found, span=p.span(i, end), word=word, cost=1), end
            yield from named_last(p, i, end, found, lemma) if sense == "build" else ()


def _is(theme: Meaning, quality: Quality, span: Span, word: Span) -> Clause:
    return Clause(verb="be", theme=theme, adjuncts=(quality,), span=span, word=word)


_TAKING = frozenset({"get", "bring", "move", "remove", "pull", "push"})


def _by_first(p: Parser, i: int, j: int, lemma: str) -> Results[Clause]:
    """ "group by colour the two black and three orange cubes"."""
    for by, k in order(p, j):
        for theme, end in noun_phrase(p, p.opt(k, ",", ":")) if isinstance(by, OrderBy) else ():
            for found, last in adjuncts(p, end):
                span, word = p.span(i, last), p.span(i, i + 1)
                yield Clause(verb="sort", lemma=lemma, theme=theme, adjuncts=(by, *found), span=span, word=word), last


def _use(p: Parser, i: int, k: int, theme: Meaning) -> Results[Clause]:
    """ "use eight blocks to form a circle"."""
    j = p.any_of(k, ("to", "and", "in order to", "for"))
    if not j:
        return
    for shape, end in noun_phrase(p, j) if p.words[j - 1] == "for" else ():
        if isinstance(shape, Structure) and shape.members is None:
            for found, last in adjuncts(p, end):
                into = Into(structure=shape, span=shape.span)
                yield Clause(verb="arrange", theme=theme, adjuncts=(into, *found), span=p.span(i, last), cost=1), last
    for inner, end in verb_phrase(p, j, ("base", "ing")):
        using = replace(inner, adjuncts=(Using(members=theme, span=theme.span), *inner.adjuncts))
        yield replace(of_what_is_there(theme, inner) or using, span=p.span(i, end)), end


def _turn(p: Parser, i: int, j: int, lemma: str) -> Results[Clause]:
    """ "turn the A block to face left"."""
    for theme, k in noun_phrase(p, j):
        for side, end in direction(p, k):
            if any(degrees_of(p, end)):  # "to the right by 90 degrees": clockwise
                continue
            faced = Manner(kind="facing", value=side, span=p.span(k, end))
            for found, last in adjuncts(p, end):
                told = Clause(verb="turn", lemma=lemma, theme=theme, adjuncts=(faced, *found), span=p.span(i, last))
                yield replace(told, word=p.span(i, i + 1)), last


@rule
def gerund_clause(p: Parser, i: int, forms: tuple[str, ...] = ("ing", "base")) -> Results[Chain]:
    """ "moving the red block", "touching anything else" after "without" and "while"; "put it there" after "having"."""
    for found, j in verb_phrase(p, i, forms):
        yield Chain(clauses=(found,), links=("and",), span=p.span(i, j)), j
        for joint in ("or", "and"):
            if k := p.one(j, joint):
                for more, end in verb_phrase(p, k, forms):
                    yield Chain(clauses=(found, more), links=("and", "and"), span=p.span(i, end)), end


def _bare_count(theme: Meaning) -> bool:
    """ "stack red and blue, six blocks ..." says how many there are of those, it speaks of no others."""
    many = isinstance(theme, Noun) and theme.amount is not None and theme.amount.low > 1
    return many and isinstance(theme, Noun) and theme.det == "bare" and theme.traits == Traits()


def _pairs(found: tuple[Meaning, ...]) -> bool:
    """ "respectively" alone: it belongs to a list of places."""
    return all(isinstance(a, Manner) and a.kind == "respectively" for a in found)


_VERBS = ("is", "are", "should", "must", "does", "do", "will", "shall")
_SO_IS = {
    False: (*(f"{so} {verb}" for so in ("so", "as") for verb in _VERBS), "likewise"),
    True: tuple(f"{nor} {verb}" for nor in ("neither", "nor") for verb in (*_VERBS, "may", "can")),
}
"""What says the same of another one, by whether that is denied."""


_NOT_TOUCH = ("not touch", "never touch", "not be touching", "must not touch", "should not touch", "shall not touch",
              "does not touch", "do not touch", "not be in contact with")  # fmt: skip


def _untouching(p: Parser, i: int, before: Clause) -> Results[Clause]:
    """ "The blue block should stand next to the red one but not touch it": no order of its own."""
    start = p.any_of(i, _NOT_TOUCH) if before.verb == "be" and before.mode == "goal" and before.theme else 0
    found = list(simple(p, start)) if start else []
    if start and several(before.theme) and (start >= p.end or p.stands(start, (",", ";"))):
        found.append((Pronoun(word="each other", span=p.span(i, start)), start))
    for mark, j in found:
        place = Loc(rel="touching", landmark=mark, span=p.span(i, j))
        told = replace(before, theme=same_as(before), adjuncts=(place,), negated=True, lemma="")
        yield replace(told, span=p.span(i, j), cost=0), j


def _told_elsewhere(found: tuple[Meaning, ...], before: Clause) -> bool:
    """ "red on the mat, blue elsewhere": not where the red one is, rather than away from where it was."""
    place = before.adjuncts[0] if before.adjuncts else None
    there = isinstance(place, Loc | In) and not (isinstance(place, Loc) and place.rel == "moved")
    return there and isinstance(found[0], Loc) and "else" in found[0].mods


def _next_one(p: Parser, i: int, before: Clause) -> Results[Clause]:
    """ "red is on the left, then green (next to it)", "red is at the bottom, green comes next": green comes next."""
    place = before.adjuncts[0] if before.verb == "be" and len(before.adjuncts) == 1 else None
    if not isinstance(place, At) or place.side == "middle" or before.negated:
        return
    for theme, j in noun_phrase(p, i):
        if isinstance(theme, Noun) and theme.head != "patch" and theme.amount in (None, Amount(1, 1)):
            follows = At(side="next", span=theme.span)
            told = p.any_of(j, _COMES_NEXT)
            if told or p.follows(i, ("then",)):
                yield replace(before, theme=theme, adjuncts=(follows,), span=p.span(i, told or j), cost=1), told or j


_COMES_NEXT = ("comes next", "is next", "goes next", "should come next", "must come next", "must be next",
               "should be next", "follows")  # fmt: skip


@rule
def gapped(p: Parser, i: int, before: Clause) -> Results[Meaning]:
    """ "... and the green one on the yellow one", "... then back to the mat": the verb of the clause before is meant
    again."""
    i = p.opt(i, "back") if p.follows(i, ("then",)) else i
    so = p.any_of(i, _SO_IS[before.negated]) if before.adjuncts and before.verb in ("be", "place") else 0
    for theme, j in noun_phrase(p, so) if so else ():
        if isinstance(theme, Noun | Coord):
            yield replace(before, theme=theme, span=p.span(i, j), cost=1), p.opt(j, "be")
    yield from (*elsewhere(p, i, before), *_next_one(p, i, before), *_untouching(p, i, before))
    for word, end in word_named(p, i) if before.verb == "spell" and isinstance(before.theme, Structure) else ():
        if word.letter == getattr(before.theme, "letter", ""):  # "SUN on the red mat and SUN on the blue one"
            word = replace(word, det="a")
        for found, k in adjuncts(p, end) if len(word.letter or "") > 1 else ():
            own = tuple(a for a in before.adjuncts if isinstance(a, Using) and Using not in map(type, found))
            yield replace(before, theme=word, adjuncts=(*own, *found), span=p.span(i, k)), k
    said = bool(before.adjuncts) and not (before.verb == "exist" and before.theme is None)
    forms = before.lemma == "form" and len(before.adjuncts) == 1 and isinstance(before.adjuncts[0], Using)
    for theme, j in noun_phrase(p, i) if said else ():
        yield from said_too(p, i, j, theme, before)
        for shape, k in simple(p, j) if forms and p.stands(j, ("a", "an", "one")) else ():
            if isinstance(shape, Structure):  # "three reds form a row, three blues a column"
                own = (Using(members=theme, span=theme.span),)
                yield replace(before, theme=shape, adjuncts=own, span=p.span(i, k)), k
        for found, k in adjuncts(p, j):
            if found and not isinstance(found[0], That) and not _pairs(found) and not _told_elsewhere(found, before):
                gathers = before.verb == "sort" and all(isinstance(a, Loc | In) for a in found)
                again = gathers or isinstance(theme, Structure)
                cost = 2 if before.verb in ("build", "spell", "sort") and not again else 0
                timed = isinstance(found[0], Manner) and found[0].kind in ("time", "by", "by?")
                beside = before.verb in ("stack", "arrange") and (timed or isinstance(found[0], At))
                beside = beside or (timed and before.verb == "place") or in_line_already(theme, before)
                cost += (2 if _bare_count(theme) or beside else 0) + isinstance(before.adjuncts[-1], That)
                yield replace(before, theme=theme, adjuncts=found, span=p.span(i, k), cost=cost), k
    yield from meant_again(p, i, before)
    carried = before.verb == "pick" and before.adjuncts  # "take it to the red mat, then to the blue one"
    if before.theme is not None and (carried or before.verb in ("place", "stack", "be", "arrange", "build")):
        for found, k in adjuncts(p, i):
            mark = getattr(found[0], "landmark", None) if found else None
            if not before.adjuncts and getattr(mark, "word", "") == "it":
                continue  # "a tower and, left of it, ...": of what is named next
            if isinstance(mark, Structure) and p.words[max(0, i - 2) : i] == ["and", ","] and "," in p.words[i : k + 1]:
                continue  # "red on blue and, left of this stack, green on yellow": the same
            if found and (isinstance(found[0], Loc | In) or (isinstance(found[0], Manner) and found[0].kind == "stay")):
                verb = "be" if before.verb in ("build", "arrange", "stack") else before.verb
                yield replace(before, verb=verb, theme=same_as(before), adjuncts=found, span=p.span(i, k), cost=1), k
            if found and isinstance(found[0], Into) and p.words[i - 1] == "or":  # "stacked, or in a row"
                verb = "arrange" if before.verb in ("stack", "be") else before.verb
                yield replace(before, verb=verb, theme=same_as(before), adjuncts=found, span=p.span(i, k)), k
