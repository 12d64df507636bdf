"""What blocks there are, said in a clause of its own: "two of each", "2 red, 2 blue", "take digits 1 to 6".

Such a clause names things and no relation; it completes what the other clauses left open.
"""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.structures.sizes import IN_TOTAL
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.grammar.things.ones import of_their_kind
from rpg.language.grammar.things.retold import all_colored, retelling, sized_alike
from rpg.language.meaning import Amount, Clause, Coord, Meaning, Noun, Pronoun, Size, Traits, replace

_LEADS = (
    "there are", "there is", "there have", "we have", "you have", "i have", "we have got", "you get", "you have got",
    "we take", "you take", "we use", "take", "use", "using", "given are", "given", "consider", "they are",
    "these are",
    "those are", "it is", "namely", "that is", "we are given", "you are given", "with", "here are", "get", "we got",
    "i have got", "i got", "got", "and there are", "use only", "take only", "available are", "available :", "letters :",
    "digits :", "numbers :", "the letters are",
    "the digits are", "the numbers are", "letters are", "digits are", "blocks :",
    "cubes :", "inventory :", "material :", "materials :", "have", "we work with", "from", "out of", "made of",
    "we start with", "you start with", "start with", "begin with", "starting with", "it starts with", "the blocks are",
    "the cubes are", "all blocks are",
    *(f"the {things} used {are}" for things in ("letters", "digits", "blocks", "cubes") for are in ("being", "are")),
)  # fmt: skip
_EACH = (
    "of each color", "of each kind", "of each type", "of each sort", "of each", "of every color", "of every kind",
    "per color", "each", "apiece", "in each color", "for each color", "of both", "of both colors", "of each one",
    "from each color", "of either color", "per kind", "in every color", "for every color", "of each of them",
    "of each of the colors", "of both kinds", "of each shade",
)  # fmt: skip
_OF_LISTED = (
    "each of",
    "of each of the colors",
    "of each of",
    "each in",
    "of each :",
    "each :",
    "of each of these colors :",
    "of each color :", "of each color ,", "of every color :", "of every color ,", "per color :", "of each color in",
    "of each of the following :", "of the colors", "for each of the colors", "in each of the colors", "for each of",
    "in each of the colors :", "for each of the colors :", "of every one of the colors", "from each of the colors",
    "of each of these :", "of each of the colors :",
)  # fmt: skip
_FOR_EACH = (
    "of each :",
    "for each :",
    *(
        f"{of}{each}{colors}"
        for of in ("for ", "of ", "in ", "from ")
        for each in ("each of ", "every one of ", "each one of ", "all of ")
        for colors in ("the colors", "these colors", "the colors :", "these colors :", "the following colors :")
    ),
)
_OPENERS = frozenset({",", ":", ";", "("})
_ARE = ("are", "is", "number", "are exactly", "should be", "must be", "will be", "count")
_BETWEEN = ("and also", "and", "plus", "&", "+", "as well as", "and then")


@rule
def inventory(p: Parser, i: int) -> Results[Clause]:
    """The things there are; `lemma` "tally" where nothing says so but the list itself."""
    lead = p.any_of(i, _LEADS)
    if lead:
        taken = p.words[i] in ("take", "use", "using", "start", "begin")
        joined = p.words[lead - 1] == ":" and p.follows(i, ("and", "or"))  # "group letters and digits: A, B, 1"
        for theme, told, j in contents(p, p.any_of(lead, _NO_MORE_THAN) or lead, taken):
            cost = 0 if taken and (told or _several(theme)) else 1
            cost += 2 * (theme is not None and _goes_on(p, j, theme)) + 2 * joined
            yield from ((given(p, i, k, theme, told, cost), k) for k in {j: None, p.any_of(j, _NO_OTHERS) or j: None})
    of = p.one(i, "of")
    for theme, j in simple(p, of) if of else ():
        if isinstance(theme, Noun) and _counted(theme, True) and theme.det == "the" and p.words[j : j + 1] == [","]:
            yield replace(given(p, i, j, theme, (), 2), lemma="stock"), j
    for items, j in _run(p, of, True) if of and i == 0 else ():
        if (len(items) > 1 or len(items[0].traits.labels) > 1) and p.words[j : j + 1] == [","]:
            yield replace(given(p, i, j, _whole(p, of, j, items), (), 2), lemma="stock"), j
    each = p.any_of(i, _EACH) if of else 0
    there = p.any_of(each, _THERE_ARE) if each else 0  # "of each there are two"
    for many, j in amounts.amount(p, there) if there else ():
        yield given(p, i, j, None, (Size(what="each", amount=many, span=p.span(i, j)),), 1), j
    if p.follows(i, _OPENERS):
        yield from _of_them(p, i)
    added = p.one(i, "add")
    for theme, j in simple(p, added) if added else ():
        if isinstance(theme, Noun) and theme.traits.extra:
            yield given(p, i, j, theme, (), 0), j
    if i == 0 or p.follows(i, _OPENERS):
        for theme, told, j in contents(p, i):
            if theme is None or not _goes_on(p, j, theme):
                yield given(p, i, j, theme, told, 0 if theme is None else 2), j
                if k := p.any_of(j, _NO_OTHERS):
                    yield given(p, i, k, theme, told, 2), k
    if i == 0 and (only := p.any_of(i, _NO_MORE_THAN)):
        yield from ((given(p, i, j, theme, told, 2), j) for theme, told, j in contents(p, only) if j >= p.end)
    yield from _besides(p, i)
    yield from _numbered(p, i)
    yield from _at_hand(p, i)


def _of_them(p: Parser, i: int) -> Results[Clause]:
    """ "All the green blocks go on the mat, four of them": how many they are, behind it all."""
    for many, j in amounts.amount(p, i):
        end = p.any_of(j, ("of them", "of these", "of those"))
        end = (p.any_of(end, IN_TOTAL) or end) if end else 0
        if end and (end >= p.end or p.stands(end, _OPENERS)):
            them = Pronoun(word="them", span=p.span(j, end))
            theme = Noun(head="any", det="some", amount=many, plural=True, part_of=them, span=p.span(i, end))
            yield replace(given(p, i, end, theme, (), 1), lemma=""), end


_NO_MORE_THAN = ("exactly", "just", "only", ":", "nothing but", "no more than", "nothing more than", "no blocks but")
_NO_OTHERS = (", no others", ", nothing else", ", and nothing else", ", and no others", "and nothing else",
              "and no others", ", no other blocks", "and no other blocks", ", and that is all",
              ", nothing more")  # fmt: skip
"""What says again that there is no more than what is listed."""
_BESIDES = ("besides", "apart from", "aside from", "in addition to", "along with", "together with")
_THERE_ARE = ("there is", "there are", "we have", "i have", "you have", "we also have", "there also is",
              "there also are", "you get")  # fmt: skip
_THERE_OR_TAKEN = (*_THERE_ARE, "there should be", "take", "use")


@choice
def _besides(p: Parser, i: int) -> Results[Clause]:
    """ "apart from two red blocks there is also a blue one": the blocks on either side."""
    for first, j in noun_phrase(p, k) if (k := p.any_of(i, _BESIDES)) else ():
        there = p.any_of(p.opt(j, ","), _THERE_ARE)
        for second, end in noun_phrase(p, p.opt(there, "also", "only", "just")) if there else ():
            if _listable(first) and _listable(second):
                items = (*_parts(first), *_parts(second))
                whole = Coord(op="and", items=items, span=p.span(i, end))
                yield replace(given(p, i, end, whole, (), 0), lemma=""), end


def _parts(theme: Meaning) -> tuple[Meaning, ...]:
    return theme.items if isinstance(theme, Coord) else (theme,)


def _listable(theme: Meaning) -> bool:
    """Blocks with their number and looks, or patches."""
    if isinstance(theme, Coord):
        return theme.op == "and" and all(map(_listable, theme.items))
    told = isinstance(theme, Noun) and theme.part_of is None and not theme.conditions
    return told and isinstance(theme, Noun) and bool(theme.traits.colors or theme.traits.labels)


def _goes_on(p: Parser, j: int, theme: Meaning | None) -> bool:
    """Whether more is added to a list that nothing leads: "a red, a green and a blue cube, stacked" are all stacked."""
    comma = p.opt(j, ",")
    joined = p.any_of(comma, ("and", "&"))
    last = theme.items[-1] if isinstance(theme, Coord) else theme
    open_ = comma > j and isinstance(last, Noun) and last.head == "any" and bool(last.traits.colors)
    if comma > j and (det := p.one(comma, ("all", "both"))):
        nouns = [x for x in _parts(theme) if isinstance(x, Noun)] if theme is not None else []
        told = {look for noun in nouns for look in noun.traits.colors}
        return any(named not in told for named, _ in color(p, det))
    return bool(joined or open_) and any(True for _ in _item(p, joined or comma, False))


_AT_HAND = (
    "exist", "exists", "also exist", "also exists",
    *(f"{are} all {there}" for are in ("is", "are")
      for there in ("we have", "i have", "you have", "there is", "there are", "we have got", "you get", "we need")),
    *(
        f"{are} {also}{there}"
        for are in ("is", "are", "being")
        for also in ("", "also ", "already ")
        for there in ("given", "available", "provided", "present", "at hand", "at your disposal", "to hand",
                      "in the scene", "supplied", "at our disposal", "there", "in play", "used", "employed")
    ),
)  # fmt: skip


@choice
def _at_hand(p: Parser, i: int) -> Results[Clause]:
    """ "eight gray blocks are given": blocks with their numbers, and that there are such."""
    for items, j in _run(p, i):
        if k := p.any_of(j, _AT_HAND):
            yield replace(given(p, i, k, _whole(p, i, j, items), (), 0), lemma=""), k


def given(p: Parser, i: int, j: int, theme: Meaning | None, told: tuple[Size, ...], cost: int) -> Clause:
    theme = None if theme is None else of_their_kind(p, theme)
    return Clause(
        verb="exist", lemma="tally", theme=theme, adjuncts=told, mode="given", span=p.span(i, j), cost=cost
    )  # fmt: skip


def _several(theme: Meaning | None) -> bool:
    many = isinstance(theme, Noun) and (
        len(theme.traits.labels) > 1 or (theme.amount is not None and theme.amount.low > 1)
    )
    return many or isinstance(theme, Coord)


def contents(p: Parser, i: int, definite: bool = False) -> list[tuple[Meaning | None, tuple[Size, ...], int]]:
    """Things with their numbers, or a number that holds of each kind."""
    found: list[tuple[Meaning | None, tuple[Size, ...], int]] = []
    for many, j in amounts.amount(p, i):
        k = p.any_of(j, ("blocks", "cubes", "block", "cube", "bricks", "boxes", "pieces", "ones", "of them")) or j
        if end := p.any_of(k, _EACH):
            found.append((None, (Size(what="each", amount=many, span=p.span(i, end)),), end))
        if end := p.any_of(k, IN_TOTAL):
            block = Noun(head="block", amount=many, plural=many.high != 1, span=p.span(i, end))
            found.append((block, (), end))
    found += [(_whole(p, i, j, items), (), j) for items, j in _run(p, i, definite or p.follows(i, (":",)))]
    return found


def _whole(p: Parser, i: int, j: int, items: tuple[Noun, ...]) -> Meaning:
    if len(items) == 1:
        return items[0]
    return Coord(op="and", items=all_colored(p, sized_alike(p, items), j), span=p.span(i, j))


@rule
def _run(p: Parser, i: int, definite: bool = False) -> Results[tuple[Noun, ...]]:
    """Counted things, one after the other. `definite`: "the four red ones" too."""
    for first, j in _item(p, i, definite):
        yield first, j
        after = p.opt(j, ",", ":", ";", "/")
        after = p.any_of(after, _BETWEEN) or after
        goes_on = after > j or (j < p.end and p.tokens[j].kind == "number")
        for rest, k in _run(p, after, definite) if goes_on else ():
            named = retelling(first, rest[0]) if len(first) == len(rest) == 1 and p.stands(j, _OPENERS) else None
            yield named or (*first, *rest), k


@choice
def _item(p: Parser, i: int, definite: bool) -> Results[tuple[Noun, ...]]:
    things = [(theme, j) for theme, j in simple(p, i) if isinstance(theme, Noun) and _counted(theme, definite)]
    for sized, j in simple(p, i):
        if isinstance(sized, Coord) and sized.op == "and" and all(isinstance(x, Noun) for x in sized.items):
            yield tuple(x for x in sized.items if isinstance(x, Noun)), j
    longest = max((j for theme, j in things if theme.traits.labels), default=0)
    yield from (((replace(theme, cost=0),), j) for theme, j in things if not theme.traits.labels or j == longest)
    for theme, j in things:
        for named, k in color(p, j + 1) if not theme.traits.colors and p.words[j : j + 1] == [","] else ():
            if theme.traits.extra and k >= p.end:
                yield (replace(theme, traits=replace(theme.traits, colors=(named,)), span=p.span(i, k)),), k
    for items, j in _colors(p, i):
        for many, k in amounts.count(p, p.opt(j, ",", ":")):
            if end := p.any_of(p.opt(k, "block", "blocks", "cube", "cubes"), ("each", "of each", "apiece")):
                yield tuple(_of_color(c, many, p.span(i, end)) for c in items), end
    for many, j in amounts.count(p, i):
        for named, k in color(p, p.reach(j + 1)) if p.words[j] in ("is", "are", "x", "times", "of", "*") else ():
            yield (_of_color(named, many, p.span(i, k)),), p.opt(k, "blocks", "cubes", "block", "cube")
    for named, j in color(p, i):
        opened = p.one(j, "(")
        for many, k in amounts.count(p, opened or p.opt(p.opt(j, ":", "-", "="), "x")):
            k = p.opt(k, "blocks", "cubes", "block", "cube")
            if opened and not p.one(k, ")"):
                continue
            k += bool(opened)
            yield (_of_color(named, many, p.span(i, k)),), k
    each = p.any_of(i, _FOR_EACH)
    for items, j in _colors(p, each) if each else ():
        there = p.any_of(p.opt(j, ","), _THERE_OR_TAKEN)
        for many, k in amounts.count(p, there) if there else ():
            k = p.opt(k, "block", "blocks", "cube", "cubes", "bricks")
            yield tuple(_of_color(c, many, p.span(i, k)) for c in items), k
    for many, j in amounts.count(p, i):
        k = p.any_of(p.opt(j, "block", "blocks", "cube", "cubes"), _OF_LISTED)
        for items, end in _colors(p, k) if k else ():
            yield tuple(_of_color(c, many, p.span(i, end)) for c in items), end


def _of_color(named: str, many: int, span: tuple[int, int]) -> Noun:
    return Noun(head="block", amount=Amount(many, many), plural=many > 1, traits=Traits(colors=(named,)), span=span)


@choice
def _colors(p: Parser, i: int) -> Results[tuple[str, ...]]:
    listed: list[str] = []
    while (found := next(iter(color(p, i)), None)) is not None:
        listed.append(found[0])
        i = found[1]
        if len(listed) > 1:
            yield tuple(listed), i
        comma = p.opt(i, ",")
        i = p.opt(comma, "and", "&")


def _counted(theme: Noun, definite: bool) -> bool:
    """Whether a phrase brings up blocks and says how many."""
    plain = theme.part_of is None and not theme.conditions and theme.head != "patch"
    marks = theme.traits
    plain = plain and marks.rank is None and not marks.matching and not marks.either
    plain = plain and theme.det in (("bare", "a", "the") if definite else ("bare", "a"))
    if definite and theme.det == "the" and not theme.plural and theme.amount is None and len(marks.colors) == 1:
        return plain
    exact = theme.amount is not None and theme.amount.low == theme.amount.high and not theme.amount.strict
    return plain and (exact or (bool(marks.labels) and theme.amount is None and not marks.open_ended))


_OF_THEM = ("in number", "of them", *IN_TOTAL)


@choice
def _numbered(p: Parser, i: int) -> Results[Clause]:
    """ "the blue cubes are three", "the blocks are two red and two green"."""
    for theme, j in noun_phrase(p, i):
        k = p.any_of(j, _ARE)
        if not k or not (
            isinstance(theme, Pronoun) or (isinstance(theme, Noun) and theme.det in ("the", "bare", "its"))
        ):
            continue
        if isinstance(theme, Noun) and theme.plural and theme.head == "block" and theme.amount is None:
            for many, end in amounts.amount(p, k):
                if p.words[end] not in lexicon.BLOCK and p.words[end] not in lexicon.UNIT:
                    end = p.any_of(end, _OF_THEM) or end
                    counted = replace(theme, det="bare", amount=many, span=p.span(i, end))
                    yield given(p, i, end, counted, (), 1), end
        told = isinstance(theme, Pronoun) and theme.word in ("they", "these", "those")
        if told or (isinstance(theme, Noun) and theme.plural and theme.traits == Traits() and theme.head == "block"):
            for items, end in _run(p, k):
                if len(items) > 1:
                    yield given(p, i, end, _whole(p, k, end, items), (), 1), end
