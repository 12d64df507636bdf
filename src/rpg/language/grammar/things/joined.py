"""Lists of noun phrases and what is set beside one: "and", "or", "but", exceptions, appositions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.adjectives import adjectives, color
from rpg.language.grammar.things.brackets import counted_aside
from rpg.language.grammar.things.excepted import and_no_other, exceptions
from rpg.language.grammar.things.labels import TOO, label_list
from rpg.language.grammar.things.not_so import not_so
from rpg.language.grammar.things.of_both import of_both
from rpg.language.grammar.things.retold import (
    all_colored,
    bare_color,
    extra_alike,
    looks_listed,
    mere_size,
    named_by,
    named_together,
    only_colored,
    part_after,
    restates,
    retelling,
    retold,
    shares_head,
    sized_alike,
    so_many_of_it,
    tally,
    the_other,
    told_anew,
    uncolored,
    what_is_left,
)
from rpg.language.later import later
from rpg.language.meaning import Amount, Coord, Meaning, Noun, Pronoun, Structure, Traits, replace

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import noun_phrase, simple
else:
    noun_phrase, simple = later(__name__, "rpg.language.grammar.things.nouns", "noun_phrase", "simple")

_JOIN = frozenset({"and", "or", "plus", "&", "nor"})


def all_but(p: Parser, i: int, whole: Meaning, j: int) -> Results[Meaning]:
    """ "all the blocks that are not red"."""
    yield from _but_so_many(p, i, whole, j)
    yield from and_no_other(p, i, whole, j)
    if isinstance(whole, Pronoun) and whole.word in ("everything", "all"):
        whole = Noun(head="block", det="all", plural=True, span=whole.span)
    if isinstance(whole, Noun) and whole.det in ("all", "each", "the", "no") and whole.head != "patch":
        yield from not_so(p, i, whole, j)


def _but_so_many(p: Parser, i: int, whole: Meaning, j: int) -> Results[Noun]:
    """ "all yellow blocks but one", "all five of the red blocks except two"."""
    k = p.any_of(j, ("but", "except", "except for", "apart from", "save")) if isinstance(whole, Noun) else 0
    if not k or not isinstance(whole, Noun) or whole.det != "all" or not whole.plural:
        return
    them = whole.part_of or replace(whole, det="the")
    for many, end in amounts.count(p, k):
        end = p.any_of(end, ("of them", "of these", "block", "blocks", "cube", "cubes")) or end
        if not amounts.makes_number(p, end) and p.words[end] != "of":
            some, span = Amount(many, many), p.span(i, end)
            yield Noun(head=whole.head, det="all but", amount=some, plural=True, part_of=them, span=span), end


_OF_EACH = ("each of", "each in", "each :", "of each of", "of each of the colors", "of each of these :", "of each :")


def of_each(p: Parser, i: int, whole: Meaning, j: int) -> Results[Coord]:
    """ "one cube each of red, orange and yellow", "two each of A and B": so many of each that is listed."""
    k = p.any_of(j, _OF_EACH)
    if not k or not isinstance(whole, Noun) or whole.amount is None or whole.traits != Traits() or whole.part_of:
        return
    if whole.det not in ("bare", "a", "some") or whole.amount.low != whole.amount.high or whole.head == "patch":
        return
    for listed, end in noun_phrase(p, k):
        looks = looks_listed(listed)
        if len(looks) > 1 and len(set(looks)) == len(looks):
            each = replace(whole, head="block", cost=0, det="bare")
            items = tuple(replace(each, traits=look, span=p.span(i, end)) for look in looks)
            yield Coord(op="and", items=items, span=p.span(i, end)), end


ARE = ("are", "is", "should be", "must be", "have to be", "has to be", "shall be", "will be", "being")
"""What a colour may follow that tells what some of the blocks look like."""
_OF_WHICH = ("of which", "of them", "of these", "of whom")
_NAMELY = ("that is", "namely", "that is to say", "meaning", "which are", "these are", "i . e .", "ie")


def _of_which(p: Parser, i: int, j: int, count: int) -> Results[Coord]:
    """ "six blocks, of which four are brown and two are white", "..., four of them brown and two white"."""
    items: list[Meaning] = []
    at = start = p.any_of(j, _OF_WHICH) or j
    led = start > j
    while True:
        told = next(iter(amounts.count(p, at)), None)
        if told is None:
            return
        many, k = told
        of = p.any_of(k, _OF_WHICH)
        if not (led or of):
            return
        led = True
        named = next(iter(color(p, p.any_of(of or k, ARE) or of or k)), None)
        if named is None:
            return
        look, at = named
        marks = Traits(colors=(look,))
        items.append(Noun(head="any", amount=Amount(many, many), plural=many > 1, traits=marks, span=p.span(k, at)))
        if len(items) > 1 and tally(tuple(items)) == count:
            yield Coord(op="and", items=tuple(items), span=p.span(i, at)), at
        at = p.opt(p.opt(at, ",", ";", "/"), "and", "&")


def _list_of(p: Parser, i: int, j: int, count: int) -> Results[Meaning]:
    """ "four blocks, red, blue, red, blue", "four blocks, numbers 1 to 4": a list of just as many."""
    yield from _of_which(p, i, j, count)
    start = p.opt(j, "namely")
    for first, k in simple(p, start):
        named = first.traits.labels if isinstance(first, Noun) and first.det == "bare" and first.plural else ()
        if len(named) == count:
            yield first, k
        for found, end in more(p, i, (first,), k, None):
            if isinstance(found, Coord) and found.op in ("and", "then") and tally(found.items) == count:
                yield replace(found, cost=0), end


def _of_kind(item: Meaning, whole: Noun) -> Meaning:
    """ "red" of "two mats, red and blue": a mat; of "two big blocks, one red and one blue": a big block."""
    if not isinstance(item, Noun) or item.head != "any":
        return item
    own = whole.traits
    marks = replace(item.traits, size=own.size, edge=own.edge, kind=own.kind) if own != Traits() else item.traits
    return replace(item, head=whole.head, traits=marks)


def _namely(p: Parser, i: int, whole: Noun, j: int) -> Results[Meaning]:
    """ "all odd digits, that is 1, 5 and 9, ...", "the odd ones, 1, 5 and 9, ...": just which they are."""
    told = p.words[j - 1] == ":" and whole.amount is not None and whole.amount.low > 1
    ones = whole.det == "the" and whole.traits == Traits(quality=whole.traits.quality) and p.stands(j - 2, ("ones",))
    if ones and whole.traits.quality in ("even", "odd"):
        whole = replace(whole, traits=replace(whole.traits, kind="digit"))
    k = p.any_of(j, _NAMELY) or (j if told or (ones and whole.traits.kind) else 0)
    for (labels, more), end in label_list(p, p.opt(k, ",", ":", "the")) if k else ():
        kind, quality = whole.traits.kind, whole.traits.quality
        if not more and named_by(whole, labels) and kind is not None:
            marks = Traits(labels=labels, kind=kind, quality=quality)
            named = replace(whole, det="the", amount=None, plural=len(labels) > 1, traits=marks, span=p.span(i, end))
            yield from ((named, last) for last in {end: None, p.opt(end, ","): None})


def _left(p: Parser, j: int) -> Results[Meaning]:
    """ "The remaining blocks, green and white, go on the mat": green and white."""
    for first, k in simple(p, p.opt(j, "namely")):
        for listed, end in [(first, k), *more(p, j, (first,), k, None)]:
            items = listed.items if isinstance(listed, Coord) and listed.op == "and" else (listed,)
            plain = all(isinstance(x, Noun) and x.traits.colors + x.traits.labels and not x.part_of for x in items)
            if plain and p.one(end, ","):
                yield replace(listed, cost=0), end + 1


def apposed(p: Parser, i: int, whole: Meaning, j: int) -> Results[Meaning]:
    """ "three red blocks, none of them ...", "five cubes, two on ...": part of what was just named."""
    if isinstance(whole, Noun) and whole.plural and p.one(j, (",", ":", "(")):
        yield from _namely(p, i, whole, j + 1)
    if what_is_left(whole) and p.one(j, ","):
        yield from _left(p, j + 1)
    if not (isinstance(whole, Noun) and (whole.plural or whole.amount)) or not p.one(j, (",", ":")):
        return
    for found, k in amounts.quantity(p, j + 1):
        counts = whole.amount is None and whole.det in ("bare", "some") and found.det == "some"
        if found.partitive and not counts and (end := p.any_of(k, ("them", "these", "those", "which"))):
            more_ = _PART_COSTS.get(found.det, 3)
            part = Noun(head=whole.head, det=found.det, amount=found.amount, plural=True, part_of=whole,
                        span=p.span(i, end), cost=more_)  # fmt: skip
            yield part, end
    plain = isinstance(whole, Noun) and (whole.traits in _PLAIN or uncolored(whole))
    if isinstance(whole, Noun) and whole.amount is not None and whole.amount.low > 1 and plain:
        for listed, k in _list_of(p, i, j + 1, whole.amount.low):
            if whole.traits not in _PLAIN and not only_colored(listed):
                continue
            named = listed
            if isinstance(listed, Coord):
                named = replace(listed, items=tuple(_of_kind(item, whole) for item in listed.items))
            yield named, k
            if p.one(k, ","):
                yield named, k + 1
    if isinstance(whole, Noun) and whole.amount is None:
        yield from counted_aside(p, i, j, whole)
        for some, k in amounts.amount(p, j + 1):
            told = p.any_of(k, ("of them ,", "of them", "in all", "in total ,", "in total", "of those")) or k
            if told == k and whole.traits.labels and p.tokens[j + 1].kind == "number":
                continue
            k = told
            det = "bare" if whole.det == "some" else whole.det
            yield replace(whole, amount=some, plural=some.high != 1, det=det, span=p.span(i, k)), k
    k = p.any_of(j + 1, ("none", "all", "each", "both"))
    k = 0 if p.stands(k, ("but", "except", "save", "bar")) else k  # "..., all but one of them"
    if k and (whole.plural or whole.amount != Amount(1, 1)):
        det = {"none": "no"}.get(p.words[k - 1], p.words[k - 1])
        yield Noun(head=whole.head, det=det, plural=True, part_of=whole, span=p.span(i, k), cost=1), k


_PART_COSTS = {"all": 1, "each": 0, "both": 0, "no": 0}
"""What it costs that only a part is meant: "(line up) five blocks, two of them on the mat" lines up all of them."""
_PLAIN = (Traits(), Traits(kind="plain"))


def _joint(p: Parser, comma: int, op: str | None, before: Meaning) -> tuple[int, str]:
    """What joins the next thing of a list: the position after it, and the word for it."""
    summed = p.one(comma, "+") if isinstance(before, Noun) and before.traits.colors else 0
    if 0 < summed < p.end:  # "2 red + 1 blue": of things that have a colour, none shows the sign
        return summed, "and"
    if op == "comma" and (k := p.any_of(comma, _AT_LAST)):
        return k, "then"
    joined = p.any_of(comma, _AS_WELL) or p.one(comma, _JOIN)
    return joined, p.words[comma] if joined else ""


def _only_first_counted(first: Meaning, item: Meaning) -> bool:
    """ "3 red/blue": no three red ones and a blue one."""
    if not isinstance(first, Noun) or first.amount is None:
        return False
    return isinstance(item, Noun) and item.amount is None and item.det == "bare" and bool(item.traits.colors)


_AS_WELL = ("and then", "as well as", "along with", "together with", "and also")


def more(p: Parser, i: int, items: tuple[Meaning, ...], at: int, op: str | None) -> Results[Coord | Noun | Structure]:
    """Lists that go on from `items`; with commas only ("red, blue, green") they cost a little."""
    comma = p.opt(at, ",", ";", "/")
    joined, word = _joint(p, comma, op, items[-1])
    summed = word == "and" and p.words[comma] == "+"
    yield from exceptions(p, i, items, comma, op)
    if not joined and (k := p.any_of(comma, ("followed by", "then"))):
        joined, word = k, "then"
    now = {"or": "or", "nor": "or"}.get(word, "and") if joined else op
    if comma == at and not joined:
        return
    if (joined and p.words[joined - 1] == "then") or word == "then":
        now = "then"
    if op is not None and now != op and op != "comma":
        return
    if word == "nor" and isinstance(items[0], Noun) and items[0].det == "no":
        return
    if word == "plus" and isinstance(items[-1], Noun) and _mere_number(items[-1]):
        return
    for item, j in [*simple(p, joined or comma), *_another_like(p, joined or comma, items[-1])]:
        if not joined and (isinstance(item, Pronoun) or (isinstance(item, Noun) and isinstance(item.part_of, Pronoun))):
            continue
        looks = item.traits if isinstance(item, Noun) else Traits()
        if not (looks.colors if summed else looks.labels or p.words[at] != "/" or p.tokens[at - 1].kind != "number"):
            continue  # "2/4 red blocks": no 2 and four red ones
        like = _like(items[-1], item) if p.words[j - 1] in ("one", "ones") else item
        item = _weighed(items, like, op == "and" and p.words[at] in (",", ";"))
        if _no_item(p, items[-1], item, bool(joined), at) or so_many_of_it(p, items[-1], item, at):
            continue
        if not joined and len(items) == 1 and (again := the_other(items[0], item)) is not None:
            yield from ((replace(again, span=p.span(i, j)), end) for end in {j: None, p.opt(j, ","): None})
            continue
        whole = all_colored(p, extra_alike(sized_alike(p, (*items, item))), j)
        if isinstance(item, Noun) and item.traits.extra and not any(_is_extra(x) for x in whole[:-1]):
            whole = (*whole[:-1], replace(item, cost=item.cost + 3))
        if joined and now == "and" and (named := named_together(whole)) is not None:
            yield replace(named, span=p.span(i, j)), j
            continue
        if joined and now == "or" and (k := p.any_of(j, ("but not both", ", but not both", "not both"))):
            yield from ((Coord(op="xor", items=whole, span=p.span(i, k)), e) for e in {k: None, p.opt(k, ","): None})
        if joined:
            stopped = len(items) == 1 and p.words[at : at + 1] == [","] and now == "and"
            shared = shares_head(items[-1], item, p.words[j - 1] == "ones") or any(map(shares_head, items, items[1:]))
            if stopped and p.any_of(j, TOO):
                continue  # "A left of B, and C too": so is C
            cost = 6 if retold(whole) else 5 if stopped else 2 if now == "then" or shared else 0
            yield Coord(op=str(now), items=whole, span=p.span(i, j), cost=cost), j
            yield from more(p, i, whole, j, now)
        else:
            if (same := retelling(items, item)) is not None:
                for end in {j: None, p.opt(j, ","): None} if same else ():
                    yield from ((replace(found, span=p.span(i, j)), end) for found in same)
                continue
            if len(items) == 1 and p.any_of(j, TOO):
                continue  # "A left of B, C too": so is C
            anew = len(items) == 1 and told_anew(items[0], item, p.words[j])
            if op != "or" and not restates(items[-1], item) and not anew:
                yield Coord(op="and", items=whole, span=p.span(i, j), cost=6 if retold(whole) else 1), j
            yield from more(p, i, whole, j, op or "comma")


def only_these(p: Parser, i: int, k: int, first: Meaning, j: int) -> Results[Coord]:
    """ "only the red block and the blue block": no others than these."""
    for some, end in more(p, k, (first,), j, None):
        if isinstance(some, Coord) and some.op == "and" and all(map(_definite, some.items)):
            yield Coord(op="only", items=(replace(some, cost=0),), span=p.span(i, end)), end


def _definite(item: Meaning) -> bool:
    """One block by its look."""
    looks = isinstance(item, Noun) and item.traits.colors + item.traits.labels
    return bool(looks) and isinstance(item, Noun) and item.amount is None and item.det in ("the", "bare")


_AT_LAST = ("and finally", "and lastly", "and last", "and at last", "and last of all")
"""Before the last thing of a list with commas: "red, green, blue and finally yellow"."""


def _like(before: Meaning, one: Meaning) -> Meaning:
    """ "a blue block, a red one and a white patch": "one" stands for what was named before it, not for the patch. "A
    big red cube and a small one": that is red as well."""
    if not isinstance(before, Noun) or not isinstance(one, Noun):
        return one
    told = before.head != "any" and bool(before.traits.colors or before.traits.labels)
    further = one.head == "any" and one.det in ("a", "bare", "another") and one.part_of is None
    if not told or not further:
        return one
    look = before.traits.colors if before.traits.size and one.traits == Traits(size=one.traits.size) else ()
    return replace(one, head=before.head, traits=replace(one.traits, colors=look or one.traits.colors))


def _no_item(p: Parser, before: Meaning, item: Meaning, joined: bool, at: int) -> bool:
    """Whether something is no further item of a list: a colour or a size of what came before it, or some of that."""
    if joined:
        both = isinstance(before, Structure) and isinstance(item, Structure)
        known = isinstance(before, Noun) and before.det == "the" and not before.plural
        mere = isinstance(item, Noun) and item.det == "bare" and item.traits == Traits() and not item.plural
        mere = mere or (isinstance(item, Pronoun) and item.word == "one")
        if known and mere and p.words[at + 1] == "one":  # "left of the red one and one behind it"
            return True
        return (both and _amid_colors(p, at)) or of_both(before, item)
    if getattr(item, "det", "") == "each" and isinstance(item, Noun) and (item.head, item.traits) == ("any", Traits()):
        return True  # "four red blocks, each one touching ..."
    if p.words[at] == "/" and _only_first_counted(before, item):
        return True
    told = isinstance(item, Noun) and bare_color(item) and (isinstance(before, Structure) or _of_sizes(before))
    return told or (isinstance(item, Noun) and (mere_size(item) or _of_them(before, item)))


def _weighed(items: tuple[Meaning, ...], item: Meaning, closed: bool) -> Meaning:
    """An item at what it costs to be one. `closed`: "and" came before the last one, and a comma before this one."""
    if isinstance(item, Noun) and isinstance(item.part_of, Noun) and item.part_of.det == "bare" and not item.cost:
        item = replace(item, cost=2)
    if closed and _starts_anew(items, item):
        item = replace(item, cost=item.cost + 1)
    return replace(item, cost=item.cost + 3) if part_after(items[-1], item) else item


def _starts_anew(items: tuple[Meaning, ...], item: Meaning) -> bool:
    """ "(a tower of) red and blue, a green block and ...": a list of bare colours that is closed does not go on."""
    bare = all(isinstance(x, Noun) and x.det == "bare" and x.head == "any" and x.amount is None for x in items)
    return bare and isinstance(item, Noun) and item.det == "a" and item.head == "block"


def _amid_colors(p: Parser, at: int) -> bool:
    """ "a staircase of red, blue and green steps": the list of colours goes on here."""
    comma = p.words[at - 2 : at - 1] == [","]
    return comma and p.words[at - 1] in lexicon.COLOR and p.words[at - 3] in lexicon.COLOR


def _of_them(before: Meaning, item: Noun) -> bool:
    """ "two blocks of 3 cm, both purple": said of these, they are no further ones."""
    counted = isinstance(before, Noun) and before.plural and not before.traits.colors and not before.traits.labels
    alone = item.head == "any" and item.det in ("both", "all") and item.traits == Traits(colors=item.traits.colors)
    return counted and alone


def _of_sizes(before: Meaning) -> bool:
    """ "cubes with edges of 5, 4 and 3 cm": a colour behind them is that of all."""
    items = before.items if isinstance(before, Coord) else ()
    return bool(items) and all(isinstance(x, Noun) and x.traits == Traits(edge=x.traits.edge) for x in items)


def _is_extra(item: Meaning) -> bool:
    return isinstance(item, Noun) and item.traits.extra


def _mere_number(item: Noun) -> bool:
    """ "two" of "two plus signs"."""
    return item.head == "any" and item.det == "bare" and item.amount is not None and item.traits == Traits()


def _another_like(p: Parser, i: int, before: Meaning) -> Results[Meaning]:
    """ "a group of reds and one of blues": a structure like the one before it in the list."""
    if isinstance(before, Noun) and before.traits.rank and before.head == "any" and before.det == "the":
        for marks, j in adjectives(p, i):
            if set(marks) == {"rank"}:
                yield replace(before, traits=Traits(**marks), span=p.span(i, j)), j
    of = p.any_of(i, ("one of", "another of", "another one of", "a second of", "a third of", "the other of"))
    if not (of and isinstance(before, Structure) and before.members is not None and not before.plural):
        return
    for members, j in simple(p, of):
        if isinstance(members, Noun):
            yield replace(before, members=members, sizes=(), dims=(), details=(), span=p.span(i, j)), j
