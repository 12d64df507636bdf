"""Whatever may follow a verb and its theme: places, orders, structures to form, what to use, conditions."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.manners import manner
from rpg.language.grammar.clauses.may_be_so import may_be_so
from rpg.language.grammar.clauses.not_so import not_so
from rpg.language.grammar.clauses.nowhere import not_there
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.absolutes import absolute
from rpg.language.grammar.places.held import BORNE, held, of_the_mark, of_the_second
from rpg.language.grammar.places.offsets import offset
from rpg.language.grammar.places.onto import piled_up
from rpg.language.grammar.places.relations import loc
from rpg.language.grammar.places.sides import at
from rpg.language.grammar.structures.apposed import apposed_blocks
from rpg.language.grammar.structures.arising import arising
from rpg.language.grammar.structures.at_corners import at_corners
from rpg.language.grammar.structures.each import each_led
from rpg.language.grammar.structures.each_line import each_line
from rpg.language.grammar.structures.limbs import LIMBED, LIMBS, limb
from rpg.language.grammar.structures.orders import READABLE, order
from rpg.language.grammar.structures.sizes import IN_TOTAL, size_phrase
from rpg.language.grammar.structures.steps import rising_steps
from rpg.language.grammar.structures.wholes import wholes
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.labels import initials, literal
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.grammar.things.standby import all_extra
from rpg.language.later import later
from rpg.language.meaning import (
    Absolute,
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
    Pronoun,
    Structure,
    That,
    Using,
    parts_of,
    replace,
)

(chain,) = later(__name__, "rpg.language.grammar.clauses.chains", "chain")
(without_it,) = later(__name__, "rpg.language.grammar.clauses.without_it", "without_it")
(gerund_clause,) = later(__name__, "rpg.language.grammar.clauses.verbs", "gerund_clause")

_INTO = ("into", "in", "as", "to form", "to make", "to create", "to build", "forming", "making", "creating", "like",
    "to be", "so as to form",
         "so they form", "so that they form", "such that they form", "so that it forms",
         "in such a way that they form", "to become", "in the form of",
         "in the shape of", "so it forms", "so as to make", "so that they make", "to construct", "and form",
         "to spell", "to get", "so you get",
         "so that you get", "arranged in", "lined up in", "placed in", "standing in", "arranged as", "arranged into",
         "that form", "which form", "that forms", "that make", "that make up", "set up as", "laid out in",
         "laid out as",
         "laid out like", "all in", "stacked in", "organized in", "down", "up in", "so as to create",
         "so that they create", "so it makes", "each in", "standing as", "stacked as", "stacked into", "set in",
         "shaped like", "in the pattern of", "arranged like", "along", "either in", "either as")  # fmt: skip


_USING = (
    "using", "with", "from", "among", "out of", "by using", "made of", "made from", "made out of", "consisting of",
    "composed of", "built from", "made up of", "use", "made with", "using only", "with only", "from only", "only from",
    "only with", "only using", "out of only", "made only of", "made only from", "consisting only of", "that only has",
    "which only has", "that has only", "which has only", "that only contains", "that contains only", "containing only",
    "that consists only of", "that only uses", "with nothing but", "using nothing but", "made of only",
    "with just", "using just", "exclusively from", "using exclusively", "made exclusively of",
    "built with", "built of", "built out of", "constructed from", "constructed of", "constructed with",
)  # fmt: skip


_SPELLING = Patterns(
    "that|which read|reads|spell|spells|say|says",
    "to spell|read|say|write",
    "spelling|reading|saying",
    "so|so_that|such_that they|it|you|i|one|we|the_viewer|the_camera|the_letters|the_cubes|the_blocks|everyone|anyone "
    "can? read|reads|spell|spells|say|says the_word?",
    "into|as the_word|the_name?",
    "for? to make|form|get|build the word|name",
    "which|that form|forms|make|makes the word",
)
"""What a word follows that blocks are to spell."""
_ONE = ("a", "an", "one", "another")
"""After "to" these begin something to be made, not a place to go to."""
LATER = 50.0
"""Times from here on come after all that is not said to be later."""


_ON_BODIES = Patterns(",? with? all|all_the|the|every|each? letters|letter|symbols|digits|digit on|in", ",? all on|in")
"""What the colour of the cubes follows that show the letters."""


_BOARDS = frozenset({"checkerboard", "chessboard"})


def _coloured(members: Noun) -> bool:
    """ "yellow blocks": of one colour, and no more is said of them."""
    return members.det == "bare" and members.amount is None and len(members.traits.colors) == 1


@rule
def adjunct(p: Parser, i: int) -> Results[Meaning]:
    """One adjunct."""
    if i >= p.end:
        return
    yield from loc(p, i)
    yield from order(p, i)
    yield from at(p, i)
    yield from _into(p, i)
    yield from _using(p, i)
    yield from absolute(p, i)
    yield from each_line(p, i)
    if p.words[i] in (",", ":"):
        yield from ((replace(found, cost=found.cost + 1), k) for found, k in wholes(p, i))
        yield from ((replace(piled, cost=1), k) for piled, k in piled_up(p, i + 1))
        for blocks, k in apposed_blocks(p, i):
            yield Using(members=blocks, lead=",", span=p.span(i, k), cost=1), k
    yield from without_it(p, i)
    yield from _that(p, i)
    yield from not_there(p, i)
    yield from ((how, k) for how, k in manner(p, i) if not _bare_distractors(p, i, how))
    if not p.follows(i, ("rectangle",)):  # the noun takes it
        yield from size_phrase(p, i)
    yield from rising_steps(p, i)
    for letter in LIMBED if p.anywhere(LIMBS) else ():
        yield from limb(p, i, letter)
    yield from each_led(p, i)
    yield from offset(p, i)
    yield from not_so(p, i)


_COPULAS = frozenset(
    {"is", "are", "be", "being", "only", "just", "all", "both", "also", "were", "was", "merely", "not"}
)


def _bare_distractors(p: Parser, i: int, how: Meaning) -> bool:
    """ "two yellow distractors": what these are, and no statement about "two yellow"; that takes "are"."""
    extra = isinstance(how, Manner) and how.kind == "extra"
    return extra and p.words[i] in ("distractors", "a", "just", "only", "irrelevant") and p.words[i - 1] not in _COPULAS


@rule
def adjuncts(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    """Any number of adjuncts, the longest run first; commas and "and" may stand between them."""
    for first, j in adjunct(p, i):
        for rest, k in adjuncts(p, j):
            if _later(first) and any(isinstance(a, Loc | In) for a in rest):
                continue
            if rest and of_the_second(p, j, first, rest[0]):
                continue
            if rest and (lying := held(p, j, first, rest[0])) is not None:
                rest = (lying, *rest[1:])
            elif rest and ((isinstance(first, Loc) and p.stands(j, BORNE)) or of_the_mark(p, j, first, rest[0])):
                continue  # "on the blue block carrying a white one": on which of the two?
            unlikely = rest and (isinstance(first, That) or _next_clause(first, rest[0]))
            yield ((replace(first, cost=first.cost + 1), *rest) if unlikely else (first, *rest)), k
        posed = p.one(p.opt(p.opt(j, ","), "both", "all"), _POSED) if isinstance(first, Into | Using) else 0
        for rest, k in adjuncts(p, posed) if posed else ():
            if rest and isinstance(rest[0], Loc) and isinstance(rest[0].landmark, Pronoun):
                yield (first, *rest), k
        yet = p.any_of(p.opt(j, ","), ("and yet", "but yet", "but also", "and also", "yet"))
        for joined in {p.opt(j, ","), p.opt(p.opt(j, ","), "and"), p.opt(j, "and", "but"), yet or j} - {j}:
            for rest, k in adjuncts(p, joined):
                framed = p.words[joined - 1] == "and" and p.words[k] == "," and _of_a_time(rest)
                if rest and not framed and (p.words[joined - 1] != "but" or _opposed(first, rest[0])):
                    yield (first, *rest), k
    yield (), i


_POSED = frozenset({"standing", "placed", "positioned", "lying", "sitting", "located", "set"})
"""What may stand before how what was formed stands: "as two towers, standing side by side"."""


def _of_a_time(rest: tuple[Meaning, ...]) -> bool:
    """ "... and throughout, green must not touch blue": when the next clause is so."""
    return len(rest) == 1 and isinstance(rest[0], Manner) and rest[0].kind in ("always", "finally", "start", "time")


def _later(first: Meaning) -> bool:
    """ "..., afterwards onto the green patch": a place of its own time, in a clause of its own."""
    return isinstance(first, Manner) and first.kind == "time" and float(first.value or 0) >= LATER


def _opposed(first: Meaning, second: Meaning) -> bool:
    """ "not on the red block but on the blue one": of two places one is denied where "but" joins them."""
    places = [x for x in (first, second) if isinstance(x, Loc | In)]
    return len(places) < 2 or places[0].negated != places[1].negated


def _side_after(first: Meaning, second: Meaning) -> bool:
    """A side right after "with ... beside it" belongs to that, not to the clause."""
    return isinstance(first, Absolute) and isinstance(second, At) and isinstance(first.adjuncts[0], Loc)


def _next_clause(first: Meaning, second: Meaning) -> bool:
    """ "G next to F and H to the left of them": the last of a list with a place right behind it begins a clause."""
    if _side_after(first, second) or _of_the_patch(first, second):
        return True
    if not (isinstance(first, Loc) and isinstance(second, Loc)):
        return False
    mark, other = first.landmark, second.landmark
    labels = mark.traits.labels if isinstance(mark, Noun) else ()
    if isinstance(other, Noun):  # "A to the right of B and C in front of B"
        again = set(other.traits.labels)
        return len(labels) > 1 and bool(again) and again.issubset(labels)
    return isinstance(other, Pronoun) and (isinstance(mark, Coord) or len(labels) > 1)


def _of_the_patch(first: Meaning, second: Meaning) -> bool:
    """ "on the mat on the left": the side tells which mat it is, if there are several."""
    mark = first.landmark if isinstance(first, Loc) else None
    plain = isinstance(mark, Noun) and mark.head == "patch" and not (mark.traits.colors or mark.traits.rank)
    return plain and isinstance(second, At) and second.side in ("left", "right", "front", "back")


_STACKED = ("stacked", "stacked up", "all stacked", "all stacked up", "piled up", "one stacked on the other")
_AFTER_STACKED = frozenset({",", ";", "and", "with", "from", "in", "by"})
"""What "stacked" is said of all of a clause before: ", stacked in rainbow order", but not ", stacked on the mat"."""


_IN_ANOTHER = (
    "in another", "in the other", "in a second", "into another", "into the other", "in another one", "in the other one",
)  # fmt: skip
_PARTS_OF_TABLE = frozenset({"corner", "edge", "half", "side"})
"""Of these there are others, too: "the white ones in one corner, the black ones in another"."""


@choice
def _into(p: Parser, i: int) -> Results[Meaning]:
    for target, k in simple(p, i + 1) if p.words[i : i + 1] == ["to"] and p.words[i + 1] in _ONE else ():
        if isinstance(target, Structure):
            yield Into(structure=target, span=p.span(i, k)), k
    j = p.any_of(i, _IN_ANOTHER)  # ", both in alphabetical order" is of the one told ahead, too
    if j and _PARTS_OF_TABLE.isdisjoint(p.words[:i]) and p.words[p.opt(j, ",")] not in {"both", "each"}:
        yield Into(structure=Structure(kind="again", span=p.span(i, j)), span=p.span(i, j)), j
    if j := p.any_of(i, ("so that the equation is right", "so that the equation is correct",
        "so that the equation is true", "so the equation is correct", "so that the equation holds",
                         "so the equation is true", "so that the math is right",
                         "so that the math is correct")):  # fmt: skip
        yield Into(structure=Structure(kind="equation", span=p.span(i, j)), span=p.span(i, j)), j
    if p.follows(i, (",",)) and (j := p.any_of(i, _STACKED)) and (j >= p.end or p.words[j] in _AFTER_STACKED):
        yield Into(structure=Structure(kind="stack", det="a", span=p.span(i, j)), span=p.span(i, j)), j
    yield from (*arising(p, i), *at_corners(p, i))
    for _, j in p.standing(i, _INTO):
        for target, k in simple(p, j):
            ordered = p.words[k] == "order" and getattr(target, "kind", "") == "gradient"  # "in rainbow order: ..."
            if isinstance(target, Structure) and not ordered:
                yield Into(structure=target, span=p.span(i, k)), k
        for target, k in noun_phrase(p, j):
            if isinstance(target, Coord) and all(isinstance(x, Structure) for x in target.items):
                yield Into(structure=target, span=p.span(i, k)), k


@choice
def _using(p: Parser, i: int) -> Results[Meaning]:
    for lead, j in p.standing(i, _USING):
        for members, k in noun_phrase(p, j):
            heap = isinstance(members, Structure) and members.kind == "pile" and members.members is not None
            if heap and isinstance(members, Structure) and lead in ("from", "out of") and not members.plural:
                yield Using(members=members, lead=lead, span=p.span(i, k), cost=1), k
            if isinstance(members, Coord) and members.op == "only":
                continue
            if not any(isinstance(part, Structure) for part in parts_of(members)):
                yield Using(members=members, lead=lead, span=p.span(i, k), cost=1), k
    shaped = p.follows(i, _FORMED) and p.stands(i, ("of",)) and p.words[i - 2] in ("be", "is", "are", "up")
    formed = p.one(i, "of") if shaped else 0
    for members, k in noun_phrase(p, formed) if formed else ():
        if not any(isinstance(part, Structure) for part in parts_of(members)):
            yield Using(members=members, lead="made of", span=p.span(i, k), cost=1), k
    of = p.one(i, "of") if p.follows(i, _SPOTS) else 0
    for members, k in noun_phrase(p, of) if of else ():
        many = all(isinstance(x, Noun) and x.head != "patch" and x.det == "bare" and (x.plural or x.amount)
                   and (x.head == "block" or x.traits.colors)
                   for x in getattr(members, "items", (members,)))  # fmt: skip
        if many and members != Noun(head="block", plural=True, span=members.span):
            yield Using(members=members, lead="of", span=p.span(i, k), cost=1), k
    if k := p.any_of(i, _PLUS):
        yield from ((Using(members=found, lead="with", span=p.span(i, e)), e) for found, e in noun_phrase(p, k)
                    if all_extra(found))  # fmt: skip
    if comma := p.one(i, ","):
        for members, k in noun_phrase(p, p.any_of(comma, IN_TOTAL) or comma) if p.rarely(_TOTAL) else ():
            end = p.any_of(k, IN_TOTAL) or (k if p.any_of(comma, IN_TOTAL) else 0)
            if end and isinstance(members, Noun) and members.head == "block" and members.amount is not None:
                yield Using(members=members, span=p.span(i, end), cost=1), end
        for members, k in noun_phrase(p, p.opt(comma, "all")):
            if k < p.end or not isinstance(members, Noun):
                continue
            board = p.anywhere(_BOARDS) and members.head != "patch" and len(members.traits.colors) == 2
            if board or (members.head == "block" and _coloured(members)):
                yield Using(members=members, span=p.span(i, k), cost=2), k
    if j := max(_ON_BODIES.matches(p, i), default=0):
        for members, k in noun_phrase(p, j):
            plain = isinstance(members, Noun) and members.head == "block" and members.det == "bare" and members.plural
            if plain and isinstance(members, Noun) and len(members.traits.colors) == 1 and members.amount is None:
                yield Using(members=members, span=p.span(i, k)), k
    if j := p.any_of(i, ("in", "by", "written in", "written with", "spelled with", "spelled in")):
        spelt = i > 0 and p.tokens[i - 1].kind in ("literal", "quote")  # "write CAT in blocks"
        for members, k in noun_phrase(p, j):
            said = isinstance(members, Noun) and (members.traits.kind or _coloured(members) or spelt)
            if isinstance(members, Noun) and members.head == "block" and members.plural and said:
                yield Using(members=members, span=p.span(i, k), cost=1), k


_FORMED = frozenset({"formed", "built", "assembled", "constructed", "created", "stacked", "laid", "erected"})
_SPOTS = frozenset({*lexicon.PATCH, *lexicon.TABLE, "edge", "corner", "half"})
"""Behind a place "of" tells the blocks of the structure in front of it: "a tower on the mat of three red blocks"."""
_PLUS = ("plus", ", plus", "and", ", and", "along with", "together with", ", along with", "besides", ", besides")
"""Before distractors that come with what is to be done."""
_TOTAL = frozenset({"total", "altogether", "all"})
_STARTS = ("starts", "start", "begins", "begin", "is at the start", "are at the start", "lies at the start",
           "is at the beginning", "starts out", "is now", "lies now", "is standing now")  # fmt: skip


def _beginning_there(p: Parser, i: int) -> Results[That]:
    """ "clear the patch, where the black block starts", "the patch on which it starts"."""
    j = p.any_of(p.opt(i, ","), ("where", "on which", "which is where", "the place where"))
    for theme, k in noun_phrase(p, j) if j else ():
        for end in {p.any_of(k, _STARTS)} - {0}:
            spot = Pronoun(word="there", span=p.span(i, j))
            on = Loc(rel="on", landmark=spot, span=spot.span)
            begun = Clause(verb="be", theme=theme, adjuncts=(on,), mode="start", span=p.span(j, end))
            yield (
                That(kind="so", clauses=Chain(clauses=(begun,), links=("and",), span=begun.span), span=begun.span),
                end,
            )


def _ever(clause: Meaning) -> Meaning:
    """ "without ever moving it": at no time."""
    always = Manner(kind="always", span=clause.span)
    return replace(clause, adjuncts=(*clause.adjuncts, always)) if isinstance(clause, Clause) else clause


@choice
def _that(p: Parser, i: int) -> Results[Meaning]:
    j = p.any_of(i, (", so that", "so that", "such that", "in such a way that", "so as", ", such that",
        "making sure that", "making sure", "ensuring that", "ensuring",
                     "where", ", where", "in a way that", "and make sure that", "and ensure that",
                     "in which", "on which", "so", ", making sure", ", ensuring that", ", ensuring",
                     "while making sure", "while making sure that", "while ensuring", "while ensuring that",
                     ", so long as", "so long as", ", as long as",
                     "as long as", ", provided that",
                     "provided that"))  # fmt: skip
    if j and not p.any_of(i, READABLE):
        for clauses, k in chain(p, p.opt(j, ",")):
            if may_be_so(clauses, compared=p.words[j - 1] == "as"):
                yield That(kind="so", clauses=clauses, span=p.span(i, k)), k
    yield from _beginning_there(p, i)
    if j := p.any_of(i, ("until", "till", "til")):
        for clauses, k in chain(p, j):
            yield That(kind="until", clauses=clauses, span=p.span(i, k)), k
    comma = p.opt(i, ",")
    for j in _SPELLING.matches(p, comma):
        text = literal(p, j)
        if text is not None and len(text) > 1 and not initials(p, j):
            word = Structure(kind="word", det="the", letter=text, span=p.span(j, j + 1))
            them = Pronoun(word="them", span=p.span(i, j))
            for found, k in adjuncts(p, j + 1):
                using = (Using(members=them, span=them.span), *found)
                said = Clause(verb="spell", theme=word, adjuncts=using, span=p.span(i, k), cost=1)
                yield That(kind="so", clauses=Chain(clauses=(said,), links=("and",), span=said.span), span=said.span), k
    if j := p.any_of(comma, _WITHOUT):
        for clauses, k in gerund_clause(p, j, ("ing",)) if p.words[j - 1] == "never" else gerund_clause(p, j):
            if p.words[j - 1] in ("ever", "never"):
                clauses = replace(clauses, clauses=tuple(map(_ever, clauses.clauses)))
            yield That(kind="without", clauses=clauses, span=p.span(i, k)), k
    bare = p.one(comma, "without") if p.rarely(_BEING) else 0
    for theme, k in noun_phrase(p, bare) if bare else ():
        done = p.one(k, _BEING)
        for sense, lemma, form in (p.lex(done, lexicon.VERB) or ()) if done else ():
            if form == "past":  # "without the red one being moved", "... being touched": it stays where it is
                sense, lemma = ("place", "move") if sense == "touch" else (sense, lemma)
                said = Clause(verb=sense, lemma=lemma, theme=theme, span=p.span(i, done + 1))
                yield That(kind="without", clauses=Chain(clauses=(said,), links=("and",), span=said.span),
                           span=said.span), done + 1  # fmt: skip
    if j := p.any_of(comma, ("while keeping", "while leaving", "keeping", "leaving", "but keep", "but leave")):
        for clauses, k in gerund_clause(p, j - 1):
            yield That(kind="while", clauses=clauses, span=p.span(i, k)), k


_BEING = frozenset({"being"})
_WITHOUT = ("without", "without ever", "while not", "while never", "but without", "and without", "never", "but never")


def throughout(p: Parser, i: int, said: Clause, end: int) -> Results[Clause]:
    """ "(keep the patch empty) at all times": the clause, with how long it is so where that is said."""
    yield said, end
    for found, k in adjuncts(p, end):
        if found and all(isinstance(a, Manner) and a.kind in ("always", "finally") for a in found):
            yield replace(said, adjuncts=(*said.adjuncts, *found), span=p.span(i, k)), k
