"""Structures as noun phrases: towers, rows, grids, figures, words, equations, with their sizes and members."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar import amounts
from rpg.language.grammar.adjectives import EMPTY, Marks, adjective, colors, merge
from rpg.language.grammar.amounts import Quantity
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.equations import equation, unequal
from rpg.language.grammar.labels import digits_of, literal, run
from rpg.language.grammar.lists import listed
from rpg.language.grammar.modifiers import DETAILS, EDGES, MODIFIERS, OPERATORS
from rpg.language.grammar.shapes import noun
from rpg.language.grammar.sizes import IN_TOTAL, dimensions, ends_in_lines, lines_of, size_phrase
from rpg.language.meaning import (
    Absolute,
    Amount,
    Coord,
    Meaning,
    Noun,
    OrderBy,
    Pattern,
    Places,
    Pronoun,
    Size,
    Structure,
    Traits,
)

_TRUE = tuple(
    f"{that} {true}"
    for that in ("that is", "which is", "that", "which", "so that it is")
    for true in ("true", "correct", "right", "valid", "holds", "works")
)
"""What every equation is."""


@dataclass(frozen=True)
class _Before:
    """What stood in front of the structure's noun."""

    marks: Marks = EMPTY
    sizes: tuple[Size, ...] = ()
    dims: tuple[int, ...] = ()
    upright: bool | None = None
    filled: bool | None = None
    operator: str | None = None
    details: tuple[Meaning, ...] = ()


@rule
def structure(p: Parser, i: int) -> Results[Meaning]:
    """A structure with its determiner, sizes, members."""
    for quantity, j in _quantities(p, i):
        for before, k in _before(p, j):
            yield from _kinds(p, i, k, quantity, before)


def _quantities(p: Parser, i: int) -> Iterator[tuple[Quantity, int]]:
    yield from ((q, j) for q, j in amounts.quantity(p, i) if not q.partitive)
    yield Quantity("bare"), i


@rule
def _before(p: Parser, i: int) -> Results[_Before]:
    """Adjectives, sizes and member nouns before the structure's noun."""
    yield _Before(), i
    for first, j in _piece(p, i):
        j = p.opt(j, ",") if p.words[j : j + 1] == [","] and any(True for _ in _piece(p, j + 1)) else j
        for rest, k in _before(p, j):
            both = _join(first, rest)
            if both is not None:
                yield both, k


def _join(a: _Before, b: _Before) -> _Before | None:
    marks = merge(a.marks, b.marks)
    if marks is None or (a.sizes and b.sizes) or (a.dims and b.dims):
        return None
    return _Before(
        marks, a.sizes or b.sizes, a.dims or b.dims,
        a.upright if a.upright is not None else b.upright,
        a.filled if a.filled is not None else b.filled, a.operator or b.operator, (*a.details, *b.details),
    )  # fmt: skip


_BEFORE_UNITS = {
    "block high": "high", "blocks high": "high", "block tall": "high", "blocks tall": "high", "block long": "long",
    "high": "high", "tall": "high",
    "block": "size", "blocks": "size", "cube": "size", "cubes": "size", "level": "layers", "layer": "layers",
    "step": "steps", "story": "layers",
    "tier": "layers", "letter": "size", "stepped": "steps", "tiered": "layers", "layered": "layers", "digit": "size",
    "block wide": "wide",
    "blocks wide": "wide", "brick": "size", "item": "size", "wide": "wide",
}  # fmt: skip


def _piece(p: Parser, i: int) -> Iterator[tuple[_Before, int]]:
    for phrase, j in p.standing(i, MODIFIERS):
        update = MODIFIERS[phrase]
        yield _Before(upright=update.get("upright"), filled=update.get("filled"), operator=OPERATORS.get(phrase)), j
    for word, j in p.standing(i, DETAILS):
        yield _Before(details=(replace(DETAILS[word], span=p.span(i, j)),)), j
    yield from _colors_before(p, i)
    for found, j in dimensions(p, i):
        for end in dict.fromkeys((j, p.opt(j, "block", "cube", "based"))):
            yield _Before(dims=found), end
    for n, j in amounts.count(p, i):
        for unit, k in p.standing(j, _BEFORE_UNITS):
            yield _Before(sizes=(Size(what=_BEFORE_UNITS[unit], amount=Amount(n, n), span=p.span(i, k)),)), k
    for marks, j in adjective(p, i):
        if "labels" not in marks and ("rank" not in marks or marks["rank"] in ("left", "right")):
            yield _Before(marks=Marks({k: v for k, v in marks.items() if k not in ("target", "long", "size")})), j
    if p.lex(i, lexicon.BLOCK) is not None:
        yield _Before(), i + 1
    rank = _RANKS.get(p.words[i]) if i < p.end else None
    if rank:
        yield _Before(marks=Marks({"rank": rank})), p.reach(i + 1)


def _colors_before(p: Parser, i: int) -> Iterator[tuple[_Before, int]]:
    """ "an alternating red-blue tower", "a red-white-blue tower": which colours, and in which order."""
    turns = p.one(i, "alternating")
    if i and (p.words[i - 1] in lexicon.COLOR or p.words[i - 1] == "alternating"):
        return
    for items, j in listed(p, turns or i):
        joined = all(isinstance(x, Noun) and len(x.traits.colors) == 1 for x in items) and "," not in p.words[i:j]
        if not joined or p.lex(j, lexicon.STRUCTURE) is None or (not turns and "and" in p.words[i:j]):
            continue
        by = "alternating" if turns else "named"
        yield _Before(details=(OrderBy(by=by, items=items, span=p.span(i, j)),)), j


_RANKS = {
    "left": "left", "right": "right", "front": "front", "back": "back", "middle": "middle", "last": "last",
    "near": "front", "far": "back", **{word: str(n) for word, n in lexicon.ORDINAL.items()},
}  # fmt: skip
"""Which of several structures is meant."""


def _kinds(p: Parser, i: int, j: int, quantity: Quantity, before: _Before) -> Results[Meaning]:
    for kind, plural, k in noun(p, j):
        if (
            kind == "cube"
            and len(before.dims) != 3
            and not p.any_of(k, ("of", "out of", "made of", "made from", "from"))
            and not ((m := p.any_of(k, ("with", ","))) and (p.number(m) is not None or p.lex(m, EDGES)))
        ):
            continue
        rank = before.marks.get("rank")
        if rank and (plural or quantity.det not in ("the", "a") or before.sizes or before.dims):
            continue
        if rank and quantity.det == "a":
            if not rank.isdigit():
                continue
            marks = Marks({key: value for key, value in before.marks.items() if key != "rank"})
            before, quantity = replace(before, marks=marks), Quantity("another", quantity.amount)
        if (plural and quantity.det in ("a", "each")) or (quantity.amount and quantity.amount.low > 1 and not plural):
            continue
        if p.words[k - 1] in ("stairs", "steps") and quantity.amount is not None:
            steps = Size(what="steps", amount=quantity.amount, span=p.span(i, k))
            plural, quantity, before = False, Quantity("a"), replace(before, sizes=(*before.sizes, steps))
        operator = before.operator or (OPERATORS.get(p.words[k - 1]) if kind == "equation" else None)
        filled = False if "outline" in p.words[j:k] else before.filled
        base = Structure(
            kind=kind, det=quantity.det, amount=quantity.amount, plural=plural, sizes=before.sizes, dims=before.dims,
            traits=Traits(**before.marks), filled=filled, upright=before.upright, letter=operator,
            details=before.details,
            span=p.span(i, k), cost=1 if kind == "cube" and not before.dims else 0,
        )  # fmt: skip
        yield from _tail(p, i, k, base)
    if (k := p.any_of(j, ("number", "year", "pin", "code"))) and (digits := digits_of(p, k)) is not None:
        yield Structure(kind="word", det="the", letter=digits, span=p.span(j, k + 1)), k + 1
    for text, k in equation(p, j):
        yield Structure(kind="equation", det="the", letter=text, span=p.span(j, k)), k


def _tail(p: Parser, i: int, j: int, base: Structure) -> Results[Meaning]:
    """What follows the noun: "of three green blocks", "three blocks high", "with a 3x3 base", a word in quotes."""
    if base.kind == "word":
        text = literal(p, p.opt(p.any_of(j, (", namely", "namely", ", for example", "such as")) or j, ":"))
        if text is not None:
            end = p.opt(p.any_of(j, (", namely", "namely", ", for example", "such as")) or j, ":") + 1
            yield replace(base, letter=text, span=p.span(i, end)), end
        elif base.det != "the":
            yield base, j
        return
    if base.kind == "equation" and (k := p.any_of(j, _TRUE)):
        yield replace(base, span=p.span(i, k)), k
    if base.kind == "equation":
        for text, k in (*equation(p, p.opt(j, ":")), *unequal(p, p.opt(j, ":"))):
            yield replace(base, letter=text, span=p.span(i, k)), k
    for pattern, k in per_color(p, j):
        base = replace(base, plural=True, details=(*base.details, pattern))
        yield from _sized_members(p, i, k, base)
        return
    yield from _sized_members(p, i, j, base)


def _sized_members(p: Parser, i: int, j: int, base: Structure) -> Results[Meaning]:
    from rpg.language.grammar.each import each_of, heights

    many = base.amount.low if base.amount is not None else 0
    for (tall, named), k in heights(p, j, many) if base.plural and base.kind == "stack" else ():
        traits = replace(base.traits, colors=base.traits.colors or named)
        yield replace(base, sizes=(*base.sizes, tall), traits=traits, span=p.span(i, k)), k
    for sized, k in _sized(p, i, j, base):
        yield sized, k
        yield from _one_each(p, i, k, sized)
        for whole, end in _members(p, i, k, sized):
            yield whole, end
            yield from _one_each(p, i, end, whole)
            for lot, last in each_of(p, end) if base.plural else ():
                yield replace(whole, details=(*whole.details, lot), span=p.span(i, last)), last
            yield from _sided(p, i, end, whole)
            yield from ((more, e) for more, e in _sized(p, i, end, whole) if e > end)
        yield from _sided(p, i, k, sized)
        for lot, end in each_of(p, k) if base.plural else ():
            yield replace(sized, details=(*sized.details, lot), span=p.span(i, end)), end
        yield from _piled(p, i, k, sized)
        if base.kind in ("stack", "row", "line", "column"):
            for items, end in listed(p, p.opt(k, ":", ",")):
                given = OrderBy(by="named", items=items, span=p.span(k, end))
                yield replace(sized, details=(*sized.details, given), span=p.span(i, end), cost=sized.cost + 1), end


def _piled(p: Parser, i: int, k: int, base: Structure) -> Results[Structure]:
    """ "a tower of red on green on blue"."""
    from rpg.language.grammar.onto import one_on_another

    lead = p.any_of(k, ("of", ",", ":", "with", "in which", "where", "made of", ", with", "that is"))
    if not lead or base.kind != "stack" or base.plural or base.sizes or base.traits.colors:
        return
    for order, end in one_on_another(p, lead):
        yield replace(base, details=(*base.details, order), span=p.span(i, end)), end


_DETAILED = frozenset({"with", ",", "having", "where", ":", "whose", "in", "of", "so", "such", "except", "but",
                       "starting", "that", "which"})  # fmt: skip


def _sided(p: Parser, i: int, k: int, base: Structure) -> Results[Structure]:
    """ "a tower with red at the bottom and blue on top": its parts belong to it, wherever it stands in the sentence."""
    from rpg.language.grammar.absolutes import one_more, sided

    if k < p.end and p.words[k] in _DETAILED:
        for detail, end in sided(p, k):
            yield replace(base, details=(*base.details, detail), span=p.span(i, end)), end
    if base.sizes and p.one(k, "and"):
        for detail, end in one_more(p, k + 1):
            yield replace(base, details=(*base.details, detail), span=p.span(i, end)), end


def _one_each(p: Parser, i: int, k: int, base: Structure) -> Results[Structure]:
    """ "two towers ..., one red and one blue", "... the left one red and the right one blue"."""
    from rpg.language.grammar.parts import wholes

    for found, end in wholes(p, k) if base.plural else ():
        places = [x.adjuncts[0] for x in found.items if isinstance(x, Absolute)]
        themes = [x.theme for x in found.items if isinstance(x, Absolute)]
        colors = tuple(c for theme in themes if isinstance(theme, Noun) for c in theme.traits.colors)
        plain = not any(isinstance(theme, Noun) and theme.amount is not None for theme in themes)
        alike = plain and len(colors) == len(themes) and all(isinstance(x, Places) and x.side == "one" for x in places)
        if base.kind == "stack" and alike:
            yield _painted(base, colors, Pattern(unit="stack", span=found.span), p.span(i, end)), end
        else:
            yield replace(base, details=(*base.details, found), span=p.span(i, end)), end


def _painted(base: Structure, colors: tuple[str, ...], pattern: Pattern, span: Span) -> Structure:
    members, traits = base.members, base.traits
    if isinstance(members, Noun):
        members = replace(members, traits=replace(members.traits, colors=members.traits.colors or colors))
    else:
        traits = replace(traits, colors=traits.colors or colors)
    return replace(base, members=members, traits=traits, details=(*base.details, pattern), span=span)


@rule
def per_color(p: Parser, i: int) -> Results[Pattern]:
    """ "per colour", "for each colour"."""
    if j := p.any_of(i, ("per color", "for each color", "for every color", "of each color")):
        yield Pattern(unit="stack", span=p.span(i, j)), j


@rule
def _sized(p: Parser, i: int, j: int, base: Structure) -> Results[Structure]:
    yield base, j
    if len(base.sizes) > 3:
        return
    if k := p.any_of(
        j,
        (
            "with nothing in the middle",
            "with nothing inside",
            "with an empty center",
            "with an empty middle",
            "with a hole in the middle",
            ", hollow",
            ", empty inside",
            "that is hollow",
            ", just the outline",
            ", outline only",
        ),
    ):
        yield from _sized(p, i, k, replace(base, filled=False, span=p.span(i, k)))
    if k := p.any_of(
        j, (", filled", ", filled in", ", solid", "that is filled", "that is filled in", ", completely filled")
    ):
        yield from _sized(p, i, k, replace(base, filled=True, span=p.span(i, k)))
    plain = base.members is None and not base.traits.colors
    comma = p.opt(j, ",") if base.kind != "checkerboard" else p.opt(j, ",", "in")
    if plain and (comma > j or base.kind == "checkerboard"):
        for (named, either), k in colors(p, p.any_of(comma, ("all in", "all", "in")) or comma):
            if not either and (len(named) == 1 or base.kind == "checkerboard") and (k >= p.end or p.words[k] == ","):
                painted = replace(base.traits, colors=named)
                yield replace(base, traits=painted, span=p.span(i, k), cost=base.cost + 1), k
    for size, k in [*lines_of(p, j, base.kind), *size_phrase(p, j)]:
        if size.what == "columns" and p.words[k - 1] == "each" and not base.plural and base.kind in _LINES:
            continue
        k = p.opt(k, "each") if base.plural else k
        changed = replace(base, sizes=(*base.sizes, size), span=p.span(i, k))
        yield from _sized(p, i, k, changed)


_LINES = ("row", "line", "column", "stack", "circle", "pile", "word")
"""Structures of which "two each" says nothing by itself: it is said of the kinds of blocks."""
_OF = ("of", "made of", "made out of", "made from", "made up of", "built from", "consisting of", "composed of",
    "built of", "formed by", "formed of", "comprising",
       "containing", "using", "constructed from", "out of", "built with", "which consists of", "that consists of",
       "which is made of",
       "that is made of", "that consist of", "which consist of", "that are made of", "that contains",
       "which contains", "made with", "with only", "from",
       "built out of", "formed from", "constructed of", "for", "with")  # fmt: skip


def _members(p: Parser, i: int, j: int, base: Structure) -> Results[Structure]:
    from rpg.language.grammar.nouns import noun_phrase

    k = p.any_of(j, _OF) or (p.one(j, "by") if p.number(j + 1) is not None else 0)
    if not k or (p.words[k - 1] == "from" and run(p, k)):
        return
    for start in dict.fromkeys((k, p.one(k, "each"))):
        if not start:
            continue
        for members, end in noun_phrase(p, start):
            if isinstance(members, Coord) and p.one(end, frozenset({"each", "apiece"})):
                continue
            if base.plural and isinstance(members, Coord) and any(map(_mere_number, members.items)):
                continue
            if ends_in_lines(p, j) and base.sizes and members_amount(members) is not None:
                continue
            if isinstance(members, Pronoun) and p.words[k - 1] == "for":
                continue
            if isinstance(members, Structure) or (
                isinstance(members, Coord) and any(isinstance(x, Structure | Pronoun) for x in members.items)
            ):
                continue
            counted = (
                members_amount(members) is not None
                and base.plural
                and (
                    (p.words[k - 1] == "of" and p.words[j] != "out")
                    or p.words[k - 1] in ("with", "containing")
                    or p.one(end, frozenset({"each", "apiece"})) > 0
                )
            )
            end = end if base.plural else p.any_of(end, IN_TOTAL) or end
            if base.plural and isinstance(members, Coord) and members.items[0].span[0] > p.tokens[start].span[0]:
                continue
            listed_ = replace(base, members=members, span=p.span(i, end), each_size=counted)
            yield (
                listed_,
                (
                    (
                        p.any_of(
                            end,
                            (
                                "each",
                                "apiece",
                                "in each one",
                                "in each",
                                "in each of them",
                                "in every one",
                                "per tower",
                                "in each tower",
                                "per stack",
                                "in each stack",
                            ),
                        )
                        or end
                    )
                    if base.plural
                    else end
                ),
            )
    if not base.sizes:
        for found, end in amounts.amount(p, k):
            size = Size(what="size", amount=found, span=p.span(k, end))
            cost = base.cost + (0 if base.plural else 1)
            yield (
                replace(base, sizes=(size,), span=p.span(i, end), cost=cost),
                p.opt(end, "each", "apiece") if base.plural else end,
            )


def _mere_number(item: Meaning) -> bool:
    """ "towers of two and three red blocks": so many of each, no members."""
    return isinstance(item, Noun) and item.head == "any" and item.traits == Traits() and item.amount is not None


def members_amount(members: Meaning) -> Amount | None:
    """The number that a members phrase gives."""
    return getattr(members, "amount", None)
