"""What there is, and what stands at a place: "there are three red blocks", "on the left of the blue block stands a red
one"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.clauses.absent import never_there
from rpg.language.grammar.clauses.adjuncts import adjunct, adjuncts
from rpg.language.grammar.clauses.denials import leave
from rpg.language.grammar.clauses.done_there import likewise
from rpg.language.grammar.clauses.having import with_more
from rpg.language.grammar.clauses.topped import topped
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.framing import WHEN_DONE, past
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import count
from rpg.language.grammar.things.lists import listed
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.later import later
from rpg.language.meaning import (
    Absolute,
    Amount,
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
    Toward,
    Traits,
    parts_of,
    replace,
)
from rpg.language.phrases import Classes

if TYPE_CHECKING:
    from rpg.language.grammar.places.borne import borne
    from rpg.language.grammar.places.relations import loc
else:
    (borne,) = later(__name__, "rpg.language.grammar.places.borne", "borne")
    (loc,) = later(__name__, "rpg.language.grammar.places.relations", "loc")

_STANDS = (
    "there is", "there are", "there should be", "there must be", "is", "are", "should be", "comes", "goes", "sits",
    "stands", "lies", "belongs", "belong", "go", "you put", "place", "put", "comes then", "come", "i want", "we want",
    "i need", "we need",
    "i would like", "we would like", "there shall be", "there has to be", "there needs to be", "i want to see",
)  # fmt: skip
_VERBS = Classes(
    {
        "must": ("should|must|shall|will|has_to|have_to|needs_to|need_to|ought_to|is_to|are_to",),
        "be": (
            "be|stand|lie|sit|rest|appear|come|remain|exist|lay",
            "be placed|put|standing|lying|sitting|seen|found|located|shown|built",
        ),
        "is": (
            "stands|stand|lies|lie|sits|sit|rests|rest|appears|appear|exists|exist|remains|remain|follows|follow|lay",
            "is|are standing|lying|sitting|resting|placed|put|shown|found|located|seen|built",
            "has|have been placed|put|built|stacked|laid",
        ),
        "last": (
            "be|go|stand|lie|sit|rest|end_up|come_to_rest|come_to_lie|come_to_stand|belong",
            "be placed|put|positioned|set|laid|moved|stacked|located|found|seen|standing|lying|sitting|resting down?",
        ),
    }
)
_LAST = Patterns("<must> also|finally? <last>", "goes|go|belong|belongs", classes=_VERBS)
"""Verbs that may close what a place began: "on the mat the red block should be"."""
_STANDING = Patterns("there? also|then|only? <must> also? <be>", "there? also|then? <is>", classes=_VERBS)
_THERE_MUST = Patterns("there also|then? <must> also? <be>", classes=_VERBS)
_THERE_STANDS = Patterns("there also|then? <is>", classes=_VERBS)
_CLOSED = frozenset({"", ",", ";", "and"})
_ORDERED = ("put", "place")
_FACTS = frozenset({"is", "are", "sits", "stands", "lies", "rests", "lie", "stand", "sit", "rest"})
_SEEN = Patterns(
    "there should|must|shall|has_to? be|is|are|stand|stands|lie|lies|come|comes",
    "put|it_is|they_are",
    "<line>|it|they should|must|shall|has_to? be|is|are|go|goes|read|reads|show|shows|have|has|run|runs",
    "you|we|i|one can? see|sees|read|reads|find|finds",
    classes=Classes(
        {"line": ("the|this row|line|tower|stack|column|blocks|cubes|letters|digits|numbers|colors|order",)}
    ),
)
"""What stands between a direction and the list that goes along it."""


def stands_there(p: Parser, i: int, j: int, first: Meaning, mode: str) -> Results[Meaning]:
    """ "on the left of the blue block there is a red one"."""
    k = max(p.any_of(j, _STANDS), *_STANDING.matches(p, j), 0)
    lemma = "fact" if k and p.words[k - 1] in _FACTS else ""
    mark = first.landmark if isinstance(first, Loc) else None
    shape = isinstance(mark, Noun) and mark.traits.shape is not None and mark.det == "a"
    for theme, end in noun_phrase(p, k or j):
        bare = isinstance(theme, Noun) and not k and theme.det == "bare" and theme.amount is None
        if bare and isinstance(theme, Noun) and not (theme.traits.colors or theme.traits.labels):
            continue
        onward = not k and isinstance(theme, Noun) and theme.head == "patch" and getattr(mark, "head", "") == "patch"
        if onward:  # "then to the green patch and finally to the blue patch": no patch is on another
            continue
        behind = max(_LAST.matches(p, end), default=0) if not (k or shape) else 0  # "in a circle, ... shall be placed"
        for more, last in [((), behind)] if behind and p.words[behind] in _CLOSED else adjuncts(p, end):
            ordered = p.words[k - 1] if k and p.words[k - 1] in _ORDERED and mode != "start" else ""
            verb = "build" if isinstance(theme, Structure) else "place" if ordered else "be"
            when = "start" if mode == "start" else "command" if ordered else "goal"
            span = p.span(i, last)
            there = Clause(verb=verb, lemma=lemma, theme=theme, adjuncts=(first, *more), mode=when, span=span)
            yield replace(there, lemma=lemma or ordered, cost=1 if k else 2), last


def listed_there(p: Parser, i: int, j: int, first: Toward | Into, mode: str) -> Results[Meaning]:
    """ "from left to right there should be red, green, blue", "in a row (from left to right) stand a red, a green and
    a blue cube"."""
    when = "start" if mode == "start" else "goal"
    for second, k in adjunct(p, p.opt(j, ",")):
        way, shape = (first, second) if isinstance(first, Toward) else (second, first)
        there = _standing(p, p.opt(k, ","))
        if not there or not isinstance(way, Toward) or not isinstance(shape, Into):
            continue
        for items, end in listed(p, p.opt(there, ":")):
            given = OrderBy(by="given", items=_one_for_each(items), span=p.span(there, end))
            said = Clause(verb="arrange", adjuncts=(way, given, shape), mode=when, span=p.span(i, end))
            yield said, end
    if isinstance(first, Toward):
        yield from _along(p, i, j, first, when)
    else:
        there = _standing(p, p.opt(j, ","))
        for theme, end in noun_phrase(p, there) if there else ():
            several = isinstance(theme, Coord) or (isinstance(theme, Noun) and theme.plural)
            for more, last in adjuncts(p, end) if several else ():
                span = p.span(i, last)
                yield Clause(verb="arrange", theme=theme, adjuncts=(first, *more), mode=when, span=span), last


def _standing(p: Parser, i: int) -> int:
    """The position after "there are", "must stand"."""
    return max(p.any_of(i, _THERE_ARE), *_STANDING.matches(p, i), 0)


_THERE_ARE = ("there are", "there should be", "there must be", "there shall be", "there have to be", "come")


def _one_for_each(items: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """ "there are gray, white and pink blocks" along a line: one of each colour, in the order of the colours."""
    plain = [x for x in items if isinstance(x, Noun) and x.det == "bare" and x.amount is None and x.part_of is None]
    if len(plain) < len(items) or any(x.traits != Traits(colors=x.traits.colors) or x.traits.either for x in plain):
        return items
    if len({c for x in plain for c in x.traits.colors}) < sum(len(x.traits.colors) for x in plain):
        return items
    return tuple(replace(x, plural=False, traits=Traits(colors=(c,))) for x in plain for c in x.traits.colors)


def _along(p: Parser, i: int, j: int, first: Toward, when: str) -> Results[Meaning]:
    there = p.opt(max(_SEEN.matches(p, j), default=j), ":", ",")
    for theme, end in noun_phrase(p, there) if there > j else ():
        if isinstance(theme, Coord) and any(isinstance(x, Structure) for x in theme.items):
            yield Clause(verb="build", theme=theme, adjuncts=(first,), mode=when, span=p.span(i, end), cost=1), end
    for items, end in listed(p, there):
        given = OrderBy(by="given", items=_one_for_each(items), span=p.span(there, end))
        for more, last in adjuncts(p, end):
            span = p.span(i, last)
            yield Clause(verb="arrange", adjuncts=(first, given, *more), mode=when, span=span, cost=1), last


@rule
def exists(p: Parser, i: int) -> Results[Meaning]:
    """ "there are three red blocks", "there should be a tower ...", "there must never be anything on ..."."""
    yield from (*never_there(p, i), *_may_be_there(p, i))
    j = p.any_of(
        i,
        (
            "there should be",
            "there must be",
            "there has to be",
            "there will be",
            "there shall be",
            "there needs to be",
            "there should only be",
        ),
    )
    j = j or max(_THERE_MUST.matches(p, i), default=0)
    mode = "goal"
    if not j:
        j = p.any_of(i, ("there are already", "there is already", "there are", "there is", "you have", "we have",
            "i have", "you are given", "we are given", "you get",
                         "given are", "here are", "the scene has", "the scene contains", "the table has",
                         "the workspace contains", "the table holds", "there also are",
                         "you start with", "there were", "there was", "the table contains", "on the table there are",
                         "on the table are", "on the table there is"))  # fmt: skip
        j = j or max(_THERE_STANDS.matches(p, i), default=0)
        mode = "given"
    if not j:
        return
    j = p.opt(j, "also", "now", "currently", "initially")
    mode, j = ("goal", end) if (end := past(p, j)) > j else (mode, j)
    if p.words[j - 1] == "are" and (many := p.number(j)) and (j + 1 >= p.end or p.stands(j + 1, (",", ";"))):
        them = Pronoun(word="them", span=p.span(j, j + 1))
        some = Noun(head="any", det="some", amount=Amount(many, many), plural=True, part_of=them, span=them.span)
        yield Clause(verb="exist", theme=some, mode="given", span=p.span(i, j + 1)), j + 1
    for theme, k in noun_phrase(p, j):
        apart = adjuncts(p, k + 1) if p.words[k : k + 1] == [","] and isinstance(theme, Structure) else []
        nothing = isinstance(theme, Pronoun) or (isinstance(theme, Noun) and theme.det == "no")
        k = (p.any_of(k, _TOO) or k) if isinstance(theme, Noun) else k
        k = p.opt(k, *_LYING) if isinstance(theme, Noun) and not p.stands(k + 1, _ABOUT) else k
        for found, end in [*adjuncts(p, k), *(x for x in apart if x[0])]:
            if any(WHEN_DONE.matches(p, end)):
                continue
            ended = any(isinstance(a, Manner) and a.kind == "finally" for a in found)
            said, found = "goal" if nothing or ended else mode, topped(theme, found)
            verb = "be" if said == "goal" and with_more(theme, found) else "exist"
            there = Clause(verb=verb, theme=theme, adjuncts=found, mode=said, span=p.span(i, end))
            yield (_borne_there(there) if said == "given" else there), end


_MAY = ("there may be", "there can be", "there are allowed to be", "there may only be", "there can only be")


def _may_be_there(p: Parser, i: int) -> Results[Clause]:
    """ "There may be at most two blocks on the mat": no more than that."""
    j = p.any_of(i, _MAY)
    for theme, k in noun_phrase(p, j) if j else ():
        many = theme.amount if isinstance(theme, Noun) else None
        only = p.words[j - 2] == "only" and many is not None and isinstance(theme, Noun)
        if only and many is not None and isinstance(theme, Noun):
            theme = replace(theme, amount=Amount(many.low, many.high, True))
        elif many is None or not many.strict or (many.low and getattr(theme, "det", "") != "no"):
            continue
        for found, end in adjuncts(p, k):
            if any(isinstance(x, Loc | In) for x in found):
                said = Clause(verb="be", theme=theme, adjuncts=found, mode="goal", span=p.span(i, end))
                yield leave(said, only, p.span(i, j)), end


def _borne_there(there: Clause) -> Clause:
    """ "There is an orange mat with a white block on it": a white block on a mat is what there is."""
    theme, absolute = there.theme, there.adjuncts[0] if len(there.adjuncts) == 1 else None
    single = isinstance(theme, Noun) and theme.det in ("a", "the") and not theme.plural
    if not single or not isinstance(absolute, Absolute) or len(absolute.adjuncts) != 1:
        return there
    place = absolute.adjuncts[0]
    if isinstance(place, At) and place.side == "top" and place.index is None:
        place = Loc(rel="on", landmark=Pronoun(word="it", span=place.span), span=place.span)
    if not isinstance(place, Loc) or place.negated or place.second or getattr(place.landmark, "word", "") != "it":
        return there
    return replace(there, theme=absolute.theme, adjuncts=(replace(place, landmark=theme),))


_TOO = ("too", "as well", "also")
_ABOUT = frozenset({"around", "about", "there", "nearby"})
_LYING = ("lying", "standing", "sitting", "resting", "placed", "located", "positioned", "situated")


_IT = frozenset({"it", "that", "this", "them"})
_AND = (", and", "and", ",", ";", ", with", "; and", "-")


def on_what_is_named(p: Parser, i: int, mode: str) -> Results[Clause]:
    """What is on, or beside, things that are only named in front of it."""
    yield from _with_on_it(p, i, mode)
    yield from _each_with(p, i, mode)


def _with_on_it(p: Parser, i: int, mode: str) -> Results[Clause]:
    """ "A red block, and on it a blue one": what is named first is only there for what is told of it."""
    if i or not p.anywhere(_IT):
        return
    for first, j in simple(p, i):
        joint = p.any_of(j, _AND) if isinstance(first, Noun) and first.head == "block" and first.det != "the" else 0
        for place, k in loc(p, joint) if joint else ():
            mark = place.landmark if isinstance(place, Loc) else None
            if not isinstance(place, Loc) or not isinstance(mark, Pronoun) or mark.word not in _IT or place.negated:
                continue
            for theme, end in noun_phrase(p, p.any_of(k, _STANDS) or k):
                if isinstance(theme, Noun) and theme.head != "patch" and theme.det in ("a", "bare"):
                    when = "start" if mode == "start" else "goal"
                    there = replace(place, landmark=first)
                    yield Clause(verb="be", theme=theme, adjuncts=(there,), mode=when, span=p.span(i, end)), end


def _each_with(p: Parser, i: int, mode: str) -> Results[Clause]:
    """ "Two red blocks, each with a blue block on top": one on each of these."""
    if not p.anywhere(_EACH):
        return
    for first, j in simple(p, i):
        many = isinstance(first, Noun) and first.amount is not None and first.amount.low > 1 and first.part_of is None
        if not many or not isinstance(first, Noun) or first.det not in ("bare", "the") or not first.traits.colors:
            continue
        for told, end in borne(p, j):
            if isinstance(on := told.adjuncts[0], Loc) and getattr(on.landmark, "word", "") != "it":
                whole = replace(first, det="the")
                each = Noun(head=first.head, det="each", plural=True, part_of=whole, span=first.span)
                on = replace(on, landmark=each, mods=("directly",))
                when = "start" if mode == "start" else "goal"
                yield Clause(verb="be", theme=told.theme, adjuncts=(on,), mode=when, span=p.span(i, end)), end


_EACH = frozenset({"each", "every"})


def there_too(p: Parser, i: int, before: Clause) -> Results[Clause]:
    """ "there are red and blue blocks, two of each, and a white mat": a further thing there is."""
    yield from likewise(p, i, before)
    if before.verb != "exist" or before.mode != "given" or before.negated:
        return
    mats = [x for x in parts_of(before.theme) if isinstance(x, Noun) and x.head == "patch"]
    things = [x for x in parts_of(before.theme) if isinstance(x, Noun)]
    if mats and things[-1].head == "patch" and all(x.head == "any" and x.traits.colors for x in things[:-1]):
        mats = things  # "a red, a green and a blue mat"
    mats = mats if len(mats) == len(things) else []
    yield from _of_their_colors(p, i, before, mats)
    for theme, j in noun_phrase(p, i) if before.adjuncts or mats else ():
        told = isinstance(theme, Noun) and theme.det in ("a", "bare", "some") and theme.part_of is None
        if not told or not isinstance(theme, Noun) or (mats and theme.head != "block"):
            continue
        if theme.head == "patch" or theme.traits.colors or theme.traits.labels:
            yield replace(before, theme=theme, adjuncts=(), span=p.span(i, j), cost=1), j


_OF_EACH = Patterns(
    "of|in|for each|every of? these|those|the? color|colors", "per color", "of|in these|those colors", "of each"
)


def _of_their_colors(p: Parser, i: int, before: Clause, mats: list[Noun]) -> Results[Clause]:
    """ "(three mats: red, blue and green,) and one block of each of these colours"."""
    named = [color for mat in mats for color in mat.traits.colors]
    if len(named) < 2 or len(set(named)) < len(named):
        return
    for many, j in [*count(p, i), *([(1, i + 1)] if p.stands(i, ("a",)) else [])]:
        for k in _OF_EACH.matches(p, j + 1) if p.stands(j, lexicon.BLOCK) else ():
            span, amount = p.span(i, k), Amount(many, many)
            items = tuple(
                Noun(head="block", amount=amount, plural=many > 1, traits=Traits(colors=(color,)), span=span)
                for color in named
            )
            blocks = Coord(op="and", items=items, span=span)
            yield replace(before, theme=blocks, adjuncts=(), span=span, cost=1), k


def stands_behind(p: Parser, j: int, previous: Clause, item: Meaning) -> bool:
    """ "Red is behind blue, and left of blue, there is green": the place in front of the comma is that of the green
    one, which is not merely there as well."""
    alone = isinstance(item, Clause) and all(isinstance(x, Loc) and x.negated for x in item.adjuncts)
    there = alone and getattr(item, "verb", "") in ("exist", "be") and p.follows(j, (",",))
    place = previous.adjuncts[-1] if there and previous.adjuncts else None
    if previous.verb == "part" and there:
        return True
    if not isinstance(place, Loc) or place.landmark is None or previous.mode == "start":
        return False
    begin = next((n for n in range(j) if p.char(n, 0) >= place.span[0]), 0)
    return p.follows(begin, ("and",)) and (len(previous.adjuncts) > 1 or getattr(previous.theme, "word", "") == "same")
