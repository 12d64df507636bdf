"""Clauses: commands, states, descriptions, what there is; and chains of them."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.absent import nothing_at_all
from rpg.language.grammar.clauses.addressed import addressed
from rpg.language.grammar.clauses.adjuncts import adjunct, adjuncts
from rpg.language.grammar.clauses.ahead import (
    WAY,
    at_place,
    done_last,
    goes_with,
    in_each_hue,
    of_a_place,
    of_hues,
)
from rpg.language.grammar.clauses.amounts_told import amounts_told
from rpg.language.grammar.clauses.becoming import staying
from rpg.language.grammar.clauses.by_someone import by_someone
from rpg.language.grammar.clauses.compared import measuring
from rpg.language.grammar.clauses.covered import covered
from rpg.language.grammar.clauses.dealt import one_for_each
from rpg.language.grammar.clauses.denied_of_all import denied_of_all
from rpg.language.grammar.clauses.each_kind import each_kind
from rpg.language.grammar.clauses.given_own import given_own
from rpg.language.grammar.clauses.having import finally_there, having, structure_is
from rpg.language.grammar.clauses.heights_bounded import stacks_more
from rpg.language.grammar.clauses.identified import identified, what_is_there
from rpg.language.grammar.clauses.made import told_before
from rpg.language.grammar.clauses.none_empty import none_empty
from rpg.language.grammar.clauses.occupied import occupied
from rpg.language.grammar.clauses.participles import participle
from rpg.language.grammar.clauses.replaced import replaced
from rpg.language.grammar.clauses.reversed_end import reverse_of_it
from rpg.language.grammar.clauses.shared import shared
from rpg.language.grammar.clauses.sole import just_these
from rpg.language.grammar.clauses.states import state
from rpg.language.grammar.clauses.terse import about, said_of, terse
from rpg.language.grammar.clauses.there import exists, listed_there, on_what_is_named, stands_there
from rpg.language.grammar.clauses.topped import topped, topped_there
from rpg.language.grammar.clauses.verbs import ever, verb_phrase
from rpg.language.grammar.clauses.weighed import rows_forming, weighed
from rpg.language.grammar.clauses.wheres import is_where, trading_places
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.gaps import gap
from rpg.language.grammar.places.held import LEADS, held, of_its
from rpg.language.grammar.places.piled import piled
from rpg.language.grammar.places.relations import loc, of_one_kind
from rpg.language.grammar.places.widened import widened
from rpg.language.grammar.structures.details import part_clause
from rpg.language.grammar.structures.each_color import of_each_color
from rpg.language.grammar.talk.chatter import CHATTER
from rpg.language.grammar.talk.commands import COMMANDS, DONT, FIRST, HANDS_OFF
from rpg.language.grammar.talk.framing import FRAMES
from rpg.language.grammar.talk.let_go import ENDINGS
from rpg.language.grammar.talk.people import AGENTS, DOERS, WORKERS
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.talk.wishes import DENIALS, STARTS, STATES
from rpg.language.grammar.things.alike import all_alike
from rpg.language.grammar.things.inventory import inventory
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.grammar.things.spare import spare
from rpg.language.grammar.things.standby import leads
from rpg.language.grammar.things.stock import stock
from rpg.language.meaning import (
    At,
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
    Structure,
    TableTop,
    That,
    Toward,
    replace,
)


@rule
def clause(p: Parser, i: int) -> Results[Meaning]:
    """One clause with whatever frame stands before it."""
    for start, mode in _frames(p, i):
        if mode == "denied":
            yield from _unwanted(p, start)
            continue
        yield from ((weighed(one_for_each(p, piled(topped_there(found)))), j) for found, j in _plain(p, start, mode))
        yield from ((weighed(one_for_each(p, piled(topped_there(x)))), j) for x, j in _fronted(p, start, mode))


_EVERY = ("all", "each", "both", "no")


@rule
def _unwanted(p: Parser, i: int) -> Results[Meaning]:
    """ "I do not want the red block on the mat", "it must not be that A touches B": one statement, denied."""
    for found, j in [*state(p, i, "goal"), *_describe(p, i, "goal")]:
        if not isinstance(found, Clause) or found.verb != "be" or not found.adjuncts or found.negated:
            continue
        theme = found.theme
        listed_ = isinstance(theme, Noun) and len(theme.traits.colors) + len(theme.traits.labels) > 1
        if not listed_ and isinstance(theme, Noun | Pronoun) and getattr(theme, "det", "") not in _EVERY:
            yield replace(found, negated=True, lemma=""), j


@rule
def _plain(p: Parser, i: int, mode: str) -> Results[Meaning]:
    when = "start" if mode == "start" else "goal"
    if mode in ("command", "any", "end"):
        yield from (*_command(p, i), *covered(p, i), *addressed(p, i), *replaced(p, i), *shared(p, i))
        yield from (*given_own(p, i), *each_kind(p, i))
    yield from (*gap(p, i), *widened(p, i), *measuring(p, i, when))
    yield from (*trading_places(p, i), *by_someone(p, i))
    yield from state(p, i, when)
    for there, j in exists(p, i):
        there = finally_there(p, i, there, mode == "end")
        begun = mode == "start" and isinstance(there, Clause) and there.mode == "given"
        yield (replace(there, lemma="begun") if begun and isinstance(there, Clause) else there), j
    yield from _describe(p, i, when)
    yield from having(p, i, when)
    yield from occupied(p, i, when)
    yield from none_empty(p, i, when)
    yield from amounts_told(p, i) if mode != "start" else ()
    yield from on_what_is_named(p, i, when)
    yield from told_before(p, i, when)
    if mode != "start":
        yield from part_clause(p, i)
        yield from structure_is(p, i)
    yield from _for_each(p, i)
    yield from (*what_is_there(p, i, when), *identified(p, i, when))
    yield from inventory(p, i)
    yield from stock(p, i)
    yield from spare(p, i)
    yield from of_each_color(p, i)
    yield from all_alike(p, i)
    yield from reverse_of_it(p, i)
    yield from terse(p, i, when)
    for (theme, start), _ in about(p, i):
        for found, j in _command(p, start):
            if (said := said_of(theme, found)) is not None:
                yield said, j


@rule
def _for_each(p: Parser, i: int) -> Results[Meaning]:
    """ "for each patch, put a red block on it": said of each of them."""
    for hues, k in in_each_hue(p, i):
        for found, end in _plain(p, k, "any"):
            if (each_hue := of_hues(found, hues)) is not None:
                yield replace(each_hue, span=p.span(i, end)), end
    j = p.one(i, "for")
    for each, k in simple(p, j) if j and p.words[j] in ("each", "every") else ():
        if not isinstance(each, Noun) or each.head != "patch":
            continue
        for found, end in _command(p, p.opt(k, ",", ":")):
            if not isinstance(found, Clause) or len(found.adjuncts) != 1 or found.verb != "place":
                continue
            spot = found.adjuncts[0]
            mark = spot.landmark if isinstance(spot, Loc) else None
            if isinstance(spot, Loc) and isinstance(mark, Pronoun) and mark.word == "it":
                yield replace(found, adjuncts=(replace(spot, landmark=each),), span=p.span(i, end)), end


@rule
def _fronted(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "from left to right put ...", "on the left of the blue block there is ...", "with six blocks build ..."."""
    for first, j in _leading(p, i):
        if not leads(p, j, first) or p.words[i] in _NO_PLACE:
            continue
        for second, k in adjunct(p, j) if isinstance(first, Loc) and p.stands(j, LEADS) else ():
            if (lying := held(p, j, first, second)) is not None:
                there = stands_there(p, i, p.opt(k, ","), first, mode)
                told = [*there, *((at_place(found, first), end) for found, end in _plain(p, p.opt(k, ","), mode))]
                yield from ((at_place(found, lying), end) for found, end in told)
        for found, k in _fronted(p, j + 1, mode) if p.stands(j, ("and",)) else ():
            if isinstance(first, Loc) and isinstance(found, Clause) and goes_with(first, found):
                yield at_place(found, first), k
        j = p.opt(j, "order") if isinstance(first, Toward) else j
        j = p.opt(j, ",", ":")
        if p.stands(j, ("then",)) and p.follows(j, (",",)):
            continue  # "(put it on the red mat,) then on the blue one, then put it ..."
        where = isinstance(first, Loc | In | At) or _both_places(first)
        if where:
            yield from is_where(p, i, j, first, "start" if mode == "start" else "goal")
        if where and p.words[i] != "separately":
            yield from stands_there(p, i, j, first, mode)
        placed = where or isinstance(first, Toward) or (isinstance(first, That) and first.kind in ("without", "while"))
        again = (placed and p.words[j - 1] == ",") or (isinstance(first, OrderBy | Into) and p.stands(j, WAY))
        further = ((of_its(x, first), k) for x, k in _fronted(p, j, mode)) if again else ()
        ended = p.words[i - 1 : i] == ["or"] and p.stands(j, ("and",))  # "(A on B) or on C, and put D on the mat"
        wished = [start for start, kind in _frames(p, j) if start > j and kind in _SEEN] if placed and not ended else ()
        yield from (x for start in wished if where for x in stands_there(p, i, start, first, mode))
        found_all = [x for start in wished for x in _plain(p, start, mode)]
        for found, end in [*_plain(p, j, mode), *further, *found_all, *done_last(p, j, mode)]:
            if isinstance(first, Into) and isinstance(found, Clause) and found.verb == "part":
                yield replace(found, verb="build", theme=first.structure, span=p.span(i, end)), end
            elif isinstance(first, Into) and (inside := of_a_place(first, found)) is not None:
                so = That(kind="so", clauses=inside, span=found.span)
                line = first.structure
                when = "start" if mode == "start" else "goal"
                yield Clause(verb="build", theme=line, adjuncts=(so,), mode=when, span=p.span(i, end), cost=1), end
            elif isinstance(found, Clause) and found.verb != "exist":
                yield replace(found, adjuncts=(*found.adjuncts, first), span=p.span(i, end), cost=found.cost + 1), end
        if isinstance(first, Toward | Into):
            yield from (found for start in (j, *wished) for found in listed_there(p, i, start, first, mode))


def _leading(p: Parser, i: int) -> Results[Meaning]:
    """What stands in front of its clause; "in a row on the table, put ..." says no more than "in a row"."""
    for first, j in adjunct(p, i):
        yield first, j
        for second, k in loc(p, j + 1) if isinstance(first, Loc) and p.stands(j, ("or",)) else ():
            if isinstance(second, Loc):
                yield Coord(op="or", items=(of_one_kind(first, second), second), span=p.span(i, k)), k
        on = adjunct(p, j) if isinstance(first, Into) and p.stands(j, ("on",)) else ()
        yield from ((first, k) for top, k in on if isinstance(top, Loc) and isinstance(top.landmark, TableTop))


_SEEN = frozenset({"state", "end", "command"})
"""Frames that may stand behind a place or a direction: "on the left, I'd like to see ..."."""


def _both_places(first: Meaning) -> bool:
    """ "behind and to the left of it", "to the front left of it"."""
    return isinstance(first, Coord) and all(isinstance(x, Loc | In | Coord) for x in first.items)


_NO_PLACE = frozenset({"there", "besides", "apart", "aside"})
"""What a place in front of its clause does not begin with: "apart from the red block there are two blue ones"."""


_IT_IS = Patterns(
    "it|this|that|here is|are|was", "it must|should|shall|has|have|needs|will|would to? be|stand|lie|exist|stay|become"
)
"""What a text may begin with before anything is there that "it" could be."""


_FRAMES = (
    (FRAMES, "end"),
    (COMMANDS, "command"),
    (STATES, "state"),
    (STARTS, "start"),
    (FIRST, ""),
    (DENIALS, "denied"),
    (CHATTER, ""),
)
"""Framing words, with what they leave open; nothing where that is as before."""
_FRAMING = frozenset[str]().union(*(table.firsts for table, _ in _FRAMES))


def _frames(p: Parser, i: int) -> list[tuple[int, str]]:
    """Positions after the polite and framing words at i, with what they leave open."""
    found = [(i, "any")]
    if i == 0 and p.stands(i, _IT_IS.firsts) and p.char(0, 0) == 0:
        found += [(j, "end") for j in _IT_IS.matches(p, 0)]
    seen = {j for j, _ in found}
    for start, mode in found:
        for table, told in _FRAMES if p.stands(start, _FRAMING) else ():
            kind = told or mode
            for j in table.matches(p, start):
                numbered = start > 0 and p.tokens[start].kind == "number" and p.words[start - 1] != ";"
                begun = (p.words[j - 1], p.words[j]) in (("next", "to"), ("addition", "to"), ("so", "that"))
                if numbered or begun or just_these(p, j):
                    continue
                if table is CHATTER and not (j := p.one(j, _SET_OFF)):
                    continue
                dashed = j < p.end and p.words[j] == "," and p.tokens[j].raw != ","
                j = p.opt(j, ",") if table in (FIRST, STARTS) or dashed else j
                if j not in seen and len(found) < 40:
                    seen.add(j)
                    kept = mode in ("start", "denied") or (mode == "end" and kind == "state")
                    found.append((j, mode if kept else kind))
    return found


_STAND = frozenset({"lie", "are", "stand", "stay", "sit", "remain", "rest"})


def _of_what_stands(p: Parser, i: int) -> bool:
    """ "should stand next to it but not touch it", "they lie there and touch no other": said of what stands there."""
    if p.words[i] == "not" and p.follows(i, ("but",)):
        return True
    told = p.follows(i, ("and",)) and p.peek(0, lexicon.VERB) is None and not _STAND.isdisjoint(p.words[1:i])
    return told and (p.words[i] == "touch" or p.words[i : i + 3] == ["do", "not", "touch"])


@rule
def _command(p: Parser, i: int) -> Results[Meaning]:
    """ "stack the red block on ...", "do not move ...", "never touch ..."."""
    j, negated = i, False
    k = p.any_of(i, DONT)
    if k and not (p.stands(i, ("it",)) and p.follows(i, ("but", "and", ",")) and p.stands(k, ("touch",))):
        j, negated = k, True  # "..., but it is not allowed to touch that": what was told of is
        j = p.opt(j, "ever")
    never = p.words[i : i + 1] == ["never"] or p.follows(j, ("ever",))
    for lead in ("let", "allow", "have", "make"):
        if negated and (k := p.one(j, lead)):
            for found, end in state(p, k, "goal"):
                if isinstance(found, Clause):
                    yield ever(nothing_at_all(replace(found, negated=True, span=p.span(i, end))), never), end
            for theme, end in noun_phrase(p, k):
                yield from staying(p, i, end, theme, "goal")
    if k := p.any_of(i, HANDS_OFF):
        for theme, end in noun_phrase(p, k):
            yield Clause(verb="touch", lemma="touch", theme=theme, negated=True, span=p.span(i, end)), end
    if p.follows(i, ("and", "then")) and p.rarely(WORKERS):
        for found, end in verb_phrase(p, i, ("s",)):
            if found.lemma not in ("get", "take", "use") and (found.adjuncts or found.verb != "place"):
                yield replace(found, cost=found.cost + 1), end
    if k := p.any_of(i, AGENTS):
        first = p.opt(k, "first")
        now = (Manner(kind="time", value=1.0, span=p.span(k, first)),) if first > k else ()
        for found, end in verb_phrase(p, first, ("base", "s")):
            had = found.lemma in ("get", "take", "use") and not p.stands(end, ("and", "then", ","))
            if not had and (found.adjuncts or found.verb != "place"):
                yield replace(found, adjuncts=(*found.adjuncts, *now), cost=found.cost + 1), end
    if k := p.any_of(i, _IT_SHOULD):
        for found, end in verb_phrase(p, k, ("base",)):
            if found.lemma in _DONE_TO and found.theme is not None and (found.adjuncts or found.verb != "place"):
                yield replace(found, cost=found.cost + 1), end
    if (k := p.any_of(i, DOERS)) and (k := p.one(k, ("has", "have"))):
        for found, end in verb_phrase(p, k, ("past",)):
            if found.adjuncts or found.verb != "place":
                yield replace(found, cost=found.cost + 1), end
    if p.follows(i, ("by", "about", "mind", "of", "having")):
        yield from verb_phrase(p, i, ("ing",))
    if k := p.one(i, "only"):
        for found, end in verb_phrase(p, k, ("base",)):
            if found.lemma == "move" and found.theme is not None:
                alone = Manner(kind="only", span=p.span(i, k))
                yield replace(found, adjuncts=(*found.adjuncts, alone), span=p.span(i, end)), end
    for found, k in verb_phrase(p, j, ("ing",) if p.words[i : i + 1] == ["avoid"] else ("base",)):
        if found.verb == "touch" and _of_what_stands(p, i):
            continue
        if j > i and stacks_more(p, j):
            continue
        if negated or found.negated or j > i:
            found = nothing_at_all(replace(found, negated=negated, span=p.span(i, k)))
        yield ever(denied_of_all(p, i, found), never), k


_IT_SHOULD = tuple(f"{who} {must}" for who in ("it", "he", "she", "they")
                   for must in ("should", "must", "shall", "has to", "have to", "needs to", "will"))  # fmt: skip
_DONE_TO = frozenset({"build", "put", "place", "stack", "sort", "arrange", "take", "pick", "construct", "assemble",
                      "rebuild", "set", "lay", "bring"})  # fmt: skip
"""What the robot does to blocks, and no block does: "it should build a tower of them" is said of the robot."""
_VAGUE = frozenset({"it", "them", "they", "that", "this", "one", "each", "all", "both"})
_WISHING = frozenset({"want", "like", "need", "see", "prefer", "have", "love"})
"""After these "it" and "them" are what is described: "I want them in a row"."""


_SET_OFF = frozenset({",", ":"})
_SORTED = frozenset({"alphabetical", "alphabetically", "reverse", "sorted", "ordered", "numerical", "row", "line"})


@rule
def _describe(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """ "a tower of three green blocks", "three red blocks stacked on ...": a picture of the end."""
    for theme, j in noun_phrase(p, i):
        wished = i > 0 and p.words[i - 1] in _WISHING and isinstance(theme, Pronoun) and theme.word in ("it", "them")
        if isinstance(theme, Pronoun) and theme.word in _VAGUE and not wished:
            continue
        shaped = isinstance(theme, Structure) or (
            isinstance(theme, Coord) and any(isinstance(t, Structure) for t in theme.items)
        )
        for found, k in [
            *adjuncts(p, p.opt(j, "each", "all", "both") if isinstance(theme, Noun | Coord) else j),
            *((f, e) for f, e in (adjuncts(p, j + 1) if p.stands(j, _SET_OFF) else ()) if f),
        ]:
            if found or shaped:
                found = topped(theme, found)
                cost = 2 if found and isinstance(found[0], At) else 1
                verb = "build" if shaped else "be"
                yield Clause(verb=verb, theme=theme, adjuncts=found, mode=mode, span=p.span(i, k), cost=cost), k
        colon = p.opt(p.opt(j, ",", ":"), "all")
        close = isinstance(theme, Noun) and len(theme.traits.labels) > 1 and p.stands(j, _SORTED)  # "A B C sorted row"
        for apposed, k in noun_phrase(p, colon) if colon > j or close else ():
            if (
                isinstance(apposed, Structure)
                and apposed.members is None
                and (not shaped or rows_forming(theme, apposed))
            ):
                into = Into(structure=apposed, span=apposed.span)
                said = Clause(verb="build" if shaped else "arrange", theme=theme, mode=mode, span=p.span(i, k), cost=1)
                for found, end in adjuncts(p, k):
                    yield replace(said, adjuncts=(into, *found), span=p.span(i, end)), end
        yield from participle(p, i, p.opt(j, "all", "both", "each", "being"), theme, mode)


def tail(p: Parser, i: int) -> int:
    """The position after closing words that carry nothing ("please", "thanks")."""
    while k := max((m for tags in ENDINGS for m in tags.matches(p, p.opt(i, ","))), default=0):
        i = k
    return i
