"""What each of several structures is made of: "two towers, each of a red and a blue block", "each row has ..."."""

from __future__ import annotations

from operator import itemgetter

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.structures.as_many_each import as_many_each
from rpg.language.grammar.structures.part_words import IS
from rpg.language.grammar.structures.parts import part
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Amount, Clause, Coord, Meaning, Noun, OrderBy, Places, Structure, Traits, replace

_LEADS = (
    *(f"{each} {made}"
      for each in ("each", "each one", "each of them", "every one of them", "both of them", "every one")
      for made in ("of", "made of", "consisting of", "built of", "made from", "built from", "with", "containing",
                   "having", "made up of", "composed of", "comprising")),
    "in each of which there is", "in each of which there are", "each being",
    "in each of which", "all of", "both with", "both of", "where each has", "where each one has", "and each has",
    "so that each has", "so that each one has", "such that each has", "of which each has",
    *(f"each of which {has}"
      for has in ("has", "should have", "must have", "is to have", "has to have", "contains", "consists of",
                  "is made of", "is built of", "is made up of")),
)  # fmt: skip
_SO = ("so that", "such that", "and", "where", "with", "in such a way that")
_SO_THAT = frozenset({"that", "where", "and", "with"})
_OF = ("of", "with", "made of", "built of")
_OF_OR_BEING = (*_OF, "being", "having")
_COLON = ("that is", "is")
_ALIKE = tuple(
    f"{lead}{same}{end}"
    for lead in ("that ", "which ", "both ", "they ", "")
    for same in (
        "look the same",
        "look alike",
        "are the same",
        "are alike",
        "are identical",
        "looking the same",
        "alike",
    )
    for end in (" :", " ,")
)
"""Behind several towers: what is told next is told of each."""
_EVERY = (
    *(f"{each}{one}" for each in ("both", "each") for one in ("", " one", " tower", " stack", " of them")),
    "both towers", "both stacks", "every one of them", "each one of them", "every one", "every tower", "every stack",
)  # fmt: skip
_NOUNS = ("tower", "stack", "row", "column", "line", "one", "group", "pile", "cluster", "heap", "bunch", "of them",
          "one of them", "of the towers", "of the stacks", "of the rows", "of these", "of the columns",
          "of the lines")  # fmt: skip
_HAS = (
    "has", "should have", "must have", "contains", "should contain", "must contain", "consists of",
    "should consist of", "must consist of", "is made of", "should be made of", "must be made of", "is built of",
    "is built from", "gets", "should get", "includes", "should include", "has to have", "is to have", "has to contain",
    "is made up of", "is composed of", "uses", "should use",
)  # fmt: skip
_HAVE = (*_HAS, "have", "should have", "must have", "consist of", "are made of", "are")
_EACH = ("each", "apiece", "in each", "in each of them", "in each one", "per tower", "per stack", "per row",
         "in every one")  # fmt: skip
_TIMES = ("both times", "each time", "every time", "in each", "in both", "in each of them", "in both of them",
          "in each tower", "in both towers", "in every tower", "in each stack", "in both stacks", "each")  # fmt: skip
_TIMES_WORDS = frozenset(phrase.split()[-1] for phrase in _TIMES)
_ON = {"on": True, "on top of": True, "above": True, "over": True, "atop": True, "under": False, "below": False,
       "beneath": False, "underneath": False, "carrying": False, "carries": False, "supporting": False,
       "supports": False, "is on": True, "is on top of": True, "is under": False, "lies on": True, "sits on": True,
       "stands on": True, "is above": True, "is below": False}  # fmt: skip
"""How two blocks lie, and whether the one named first is the upper one."""


@rule
def each_of(p: Parser, i: int) -> Results[Meaning]:
    """Behind several structures: ", each of a red and a blue block", "with a red and a blue block each"; "of the same
    height"."""
    yield from as_many_each(p, i)
    yield from each_led(p, i)
    comma = p.opt(i, ",", ":")
    j = p.any_of(comma, ("of", "with", "from", "made of"))
    for found, k in _lot(p, i, j or comma) if j or comma > i else ():
        if not found.first and p.words[k - 1] != "," and (end := p.any_of(k, _EACH)):
            yield replace(found, span=p.span(i, end)), end
        elif found.first and j and p.words[j - 1] == "of" and len(set(map(_look, found.items))) > 1:
            yield found, k  # "two towers of blue on green"


_STACKS = frozenset({"towers", "stacks", "piles", "columns", "tower", "stack"})


@rule
def each_led(p: Parser, i: int) -> Results[OrderBy]:
    """As an adjunct: ", each of a red and a blue block", ", green under yellow both times"."""
    comma = p.opt(i, ",", ":")
    if j := p.any_of(comma, _LEADS):
        yield from made_of(p, i, j)
    if j := p.any_of(comma, _EVERY):
        named = p.opt(p.any_of(j, _COLON) or j, ":")
        every = p.stands(named, lexicon.COLOR) and not p.anywhere(_STACKS)  # "each red on a blue": every red one
        yield from (x for x in made_of(p, i, named) if x[0].first and not every)
    each = p.one(p.any_of(comma, _SO) or comma, ("each", "every"))
    noun = p.any_of(each, _NOUNS) or each if each and (comma > i or p.follows(each - 1, _SO_THAT)) else 0
    for has in (p.any_of(noun, _HAS), p.any_of(noun, _OF_OR_BEING)) if noun else ():
        yield from made_of(p, i, has) if has else ()
    if j := p.any_of(comma, _ALIKE):
        yield from (x for x in made_of(p, i, j) if x[0].first)
    for found, j in _lot(p, i, comma) if comma > i and p.anywhere(_TIMES_WORDS) else ():
        if found.first and (k := p.any_of(j, _TIMES)):
            yield replace(found, span=p.span(i, k)), k


@rule
def each_clause(p: Parser, i: int) -> Results[Clause]:
    """ "each tower has one red and one blue block", "in each tower a green block carries a yellow one"."""
    inside = p.one(i, "in")
    yield from _of_so_many(p, i)
    each = p.one(inside or i, ("each", "every"))
    alone = not inside or p.stands(each, ("the", ",", "there"))
    j = (p.any_of(each, _NOUNS) or (each if alone else 0)) if each else 0
    if both := p.any_of(inside, ("both", "both of them", "both towers", "both stacks")) if inside else 0:
        j = both
    if not j:
        return
    start = p.any_of(p.opt(j, ","), ("there is", "there are", "there should be", "there must be")) or p.opt(j, ",")
    for found, k in made_of(p, i, start if inside else p.any_of(j, _HAS)) if inside or p.any_of(j, _HAS) else ():
        yield Clause(verb="part", adjuncts=(found,), mode="goal", span=p.span(i, k)), k


def made_of(p: Parser, i: int, j: int) -> Results[OrderBy]:
    """What each of several structures has: so many blocks, or one on another, or blocks at its places."""
    yield from _lot(p, i, j)
    yield from _layered(p, i, j)
    yield from _by_layers(p, i, j)
    yield from _some_and_some(p, i, j)
    yield from _end_and_rest(p, i, j)
    for below, k in simple(p, j):
        with_ = p.any_of(k, _TOPPED)
        for above, end in simple(p, with_) if with_ and _of_one_look(below) else ():
            last = p.any_of(end, _ABOVE) or (
                end if p.words[with_ - 2] in ("topped", "on") or p.words[with_ - 1] in ("it", "them") else 0
            )
            if last and _of_one_look(above):
                pair = (*items_of(below, below.span), *items_of(above, above.span))
                yield OrderBy(by="each", items=pair, first="bottom", span=p.span(i, last)), last


_TOPPED = ("with", "and on it", "and on them", "topped with", "topped by", ", with", "and", "and then", ", then",
           ", and then")  # fmt: skip
_ABOVE = ("on top", "on it", "on top of it", "above it", "above", "on them", "on top of them", "above them")


def _of_one_look(meaning: Meaning) -> bool:
    """ "a red block", "two red blocks"."""
    return len(set(map(_look, items_of(meaning, meaning.span)))) == 1


def _of_so_many(p: Parser, i: int) -> Results[Clause]:
    """ "each of the two towers has ...", "both towers have ...": as many towers, unless they were built before."""
    of = p.any_of(i, ("each of the", "each of", "every one of the", "all the", "all"))
    number = 2 if (both := p.one(i, "both")) else p.number(of) if of else None
    j = p.opt(both, "the") if both else of + 1
    if number is None or number < 2 or p.words[j] not in ("towers", "stacks"):
        return
    has = p.any_of(p.reach(j + 1), _HAVE)
    towers = Structure(kind="stack", det="bare", amount=Amount(number, number), plural=True, span=p.span(i, j + 1))
    for found, k in made_of(p, i, has) if has else ():
        yield Clause(verb="part", theme=towers, adjuncts=(found,), mode="goal", span=p.span(i, k)), k


def _lot(p: Parser, i: int, j: int) -> Results[OrderBy]:
    """A list of counted blocks, or one block on another."""
    for members, k in noun_phrase(p, j):
        items = items_of(members, p.span(j, k))
        if len({item.traits for item in items}) > 1:
            yield OrderBy(by="each", items=items, span=p.span(i, k)), k
    for first, k in simple(p, j):
        one = items_of(first, first.span)
        for phrase, at in p.standing(k, _ON) if len(one) == 1 else ():
            for second, end in simple(p, at):
                two = items_of(second, second.span)
                if len(two) == 1:
                    pair = (*two, *one) if _ON[phrase] else (*one, *two)
                    yield OrderBy(by="each", items=pair, first="bottom", span=p.span(i, end)), end


def _some_and_some(p: Parser, i: int, j: int) -> Results[OrderBy]:
    """ "(in each group) three are red and one is blue": so many of each look."""
    items: list[Noun] = []
    while (many := p.number(j)) is not None and (k := p.any_of(p.any_of(j + 1, _OF_THEM) or j + 1, _ARE)):
        look, end = next(iter(color(p, k)), ("", 0))
        if not end:
            return
        one = Noun(head="block", det="a", amount=Amount(1, 1), traits=Traits(colors=(look,)), span=p.span(j, end))
        items += [one] * many
        if len(set(map(_look, items))) > 1:
            yield OrderBy(by="each", items=tuple(items), span=p.span(i, end)), end
        j = p.any_of(end, (", and", ",", "and", ", while", "while"))


def _end_and_rest(p: Parser, i: int, j: int) -> Results[OrderBy]:
    """ "(in each of them) the top one is red and the two below it are white": one at an end, and so many others."""
    at = p.opt(j, "the", "its")
    level = p.lex(at, _LEVELS)
    k = p.opt(at + 1, "block", "cube", "one") if level in ("top", "bottom") else 0
    look, end = next(iter(color(p, p.any_of(k, _ARE) or k)), ("", 0)) if k else ("", 0)
    joint = p.any_of(end, (", and", ",", "and", ", while", "while")) if end else 0
    for place, after in part(p, joint) if joint else ():
        if not isinstance(place, Places) or place.side != "rest" or place.several is None:
            continue
        if place.beyond not in (None, "below" if level == "top" else "above"):
            continue
        other, last = next(iter(color(p, p.any_of(after, IS) or after)), ("", 0))
        if last and other != look:
            one = Noun(head="block", det="a", amount=Amount(1, 1), span=p.span(j, last))
            others = (replace(one, traits=Traits(colors=(other,))),) * place.several
            first = replace(one, traits=Traits(colors=(look,)))
            items = (*others, first) if level == "top" else (first, *others)
            yield OrderBy(by="each", items=items, first="bottom", span=p.span(i, last)), last


_OF_THEM = ("of them", "of the blocks", "of the cubes", "of its blocks", "blocks", "block", "cubes", "cube", "ones")
_ARE = ("are", "is", "should be", "must be", "shall be", "being", "has to be", "have to be")

_AT = {
    **dict.fromkeys(
        (
            "at the bottom",
            "below",
            "underneath",
            "at the base",
            "lowest",
            "at the very bottom",
            "as its base",
            "as the base",
            "as a base",
        ),
        "bottom",
    ),
    **dict.fromkeys(
        (
            "on top",
            "at the top",
            "above",
            "on the top",
            "highest",
            "at the very top",
            "above it",
            "on top of it",
            "on it",
            "above that",
            "on top of that",
            "on that",
            "above them",
            "on them",
            "on top of them",
        ),
        "top",
    ),
    **dict.fromkeys(("in the middle", "in between", "between them", "in the center"), "middle"),
}


def _layered(p: Parser, i: int, j: int) -> Results[OrderBy]:
    """ "(both with) red at the bottom and white on top"."""
    held: dict[str, tuple[Noun, ...]] = {}
    while len(held) < 3:
        for theme, k in simple(p, j):
            one = items_of(theme, theme.span)
            k = p.opt(k, "is", "are", "being", "lies", "sits", "goes", "comes")
            at, end = max(
                ((_AT[phrase], end) for phrase, end in p.standing(k, _AT)), key=itemgetter(1), default=("", 0)
            )
            if len(set(map(_look, one))) == 1 and end and at not in held:
                held[at] = one
                break
        else:
            return
        if {"bottom", "top"} <= held.keys():
            items = tuple(x for at in ("bottom", "middle", "top") for x in held.get(at, ()))
            yield OrderBy(by="each", items=items, first="bottom", span=p.span(i, end)), end
        j = p.any_of(end, (", and", ",", "and"))
        if not j:
            return


_LEVELS = {"lower": "bottom", "bottom": "bottom", "lowest": "bottom", "bottommost": "bottom", "upper": "top",
           "top": "top", "topmost": "top", "uppermost": "top", "highest": "top", "middle": "middle"}  # fmt: skip


def _by_layers(p: Parser, i: int, j: int) -> Results[OrderBy]:
    """ "(in each of them) the lower block is brown and the upper one white"."""
    held: dict[str, Noun] = {}
    while len(held) < 3:
        level = p.lex(p.opt(j, "the", "its", "a"), _LEVELS)
        k = p.opt(p.opt(j, "the", "its", "a") + 1, "block", "cube", "one") if level else 0
        k = p.any_of(k, ("is", "being", "must be", "should be")) or k
        look = (
            next(((items_of(x, x.span), end) for x, end in simple(p, k) if p.peek(k, lexicon.COLOR)), ((), 0))
            if k
            else ((), 0)
        )
        if level is None or level in held or len(look[0]) != 1:
            return
        held[level], end = look[0][0], look[1]
        if {"bottom", "top"} <= held.keys():
            items = tuple(held[at] for at in ("bottom", "middle", "top") if at in held)
            yield OrderBy(by="each", items=items, first="bottom", span=p.span(i, end)), end
        j = p.any_of(end, (", and", ",", "and"))
        if not j:
            return


def _look(item: Meaning) -> Meaning | object:
    return item.traits if isinstance(item, Noun) else item


def items_of(meaning: Meaning, span: Span) -> tuple[Noun, ...]:
    """The blocks of a list one by one; none where it is not such a list."""
    if isinstance(meaning, Coord):
        lots = [items_of(item, item.span) for item in meaning.items] if meaning.op == "and" else [()]
        return tuple(x for lot in lots for x in lot) if all(lots) else ()
    if not isinstance(meaning, Noun) or meaning.head == "patch" or meaning.conditions or meaning.part_of is not None:
        return ()
    marks, amount = meaning.traits, meaning.amount
    if meaning.det not in ("a", "bare", "some") or marks.either or marks.rank or marks.extra or marks.matching:
        return ()
    if amount is not None and (amount.low != amount.high or amount.low < 1):
        return ()
    if not (marks.colors or marks.labels or marks.kind or marks.size):
        return ()
    count = amount.low if amount is not None else 1
    looks = [replace(marks, colors=(c,)) for c in marks.colors] if len(marks.colors) > 1 else [marks]
    looks = [replace(look, labels=(x,)) for look in looks for x in look.labels] if len(marks.labels) > 1 else looks
    if (len(looks) > 1 and count not in (1, len(looks))) or (count == 1 and meaning.plural and len(looks) == 1):
        return ()
    count = count if len(looks) == 1 else 1
    one = Noun(head="block", det="a", amount=Amount(1, 1), span=span)
    return tuple(replace(one, traits=look) for look in looks for _ in range(count))
