"""Structures as noun phrases: towers, rows, grids, figures, words, equations, with their sizes and members."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.sides import SIDES, toward
from rpg.language.grammar.places.slopes import DIAGONAL
from rpg.language.grammar.structures.copies import copies
from rpg.language.grammar.structures.equations import equation, promised, result_alone, unequal
from rpg.language.grammar.structures.heights import bar_chart
from rpg.language.grammar.structures.makeup import per_color, sized_members
from rpg.language.grammar.structures.modifiers import DETAILS, EDGES, MODIFIERS, OPERATORS
from rpg.language.grammar.structures.ring_around import ring_around, with_a_ring
from rpg.language.grammar.structures.shapes import noun, upside_down
from rpg.language.grammar.structures.sizes import dimensions, in_lines, layers_of, rows_and_columns
from rpg.language.grammar.structures.superlatives import RANKS, largest, one_of_several
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.adjectives import EMPTY, Marks, adjective, merge
from rpg.language.grammar.things.amounts import Quantity
from rpg.language.grammar.things.labels import digits_of, literal
from rpg.language.grammar.things.lists import listed
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import (
    Amount,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Size,
    Structure,
    Toward,
    Traits,
    replace,
)

_SHOWN = (
    "in cubes", "in blocks", "with cubes", "with blocks", "out of cubes", "out of blocks", "in digit blocks",
    "in digit cubes", "as blocks", "as cubes",
    *(f"as an equation{of}" for of in ("", " of blocks", " of cubes", " in blocks", " in cubes", " with blocks")),
)  # fmt: skip
"""What says no more of an equation than that blocks show it."""
_SAYS = ("that says", "which says", "saying", "that reads", "which reads", "reading", "stating", "stating that",
         "that states", "which states", "showing", "showing that", "that shows", "namely", ", namely",
         "that says that")  # fmt: skip
"""What the text of an equation follows."""
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
    lines: bool = False
    upright: bool | None = None
    filled: bool | None = None
    operator: str | None = None
    parallel: bool = False
    details: tuple[Meaning, ...] = ()


@rule
def structure(p: Parser, i: int) -> Results[Meaning]:
    """A structure with its determiner, sizes, members."""
    for size, j in layers_of(p, i):
        base = Structure(kind="grid", sizes=(size,), span=p.span(i, j))
        yield from _tail(p, i, j, base)
    for dims, j in () if p.anywhere(_GRIDS) else rows_and_columns(p, i):
        yield from _tail(p, i, j, Structure(kind="grid", dims=dims, span=p.span(i, j)))
        return
    yield from _as_many_symbols(p, i)
    yield from one_of_several(p, i)
    yield from bar_chart(p, i)
    yield from with_a_ring(p, i)
    yield from copies(p, i)
    for base, j in largest(p, i):
        yield from _tail(p, i, j, base)
    for quantity, j in _quantities(p, i):
        for before, k in _before(p, j):
            yield from _kinds(p, i, k, quantity, before)


@rule
def _as_many_symbols(p: Parser, i: int) -> Results[Meaning]:
    """ "3 by 3 digits 1 to 9", "2x2 of the letters A B C D": a grid, for there is one for each of its places; and so
    is what blocks stand "in a 2x3"."""
    begin = p.opt(i, "a")
    for dims, j in dimensions(p, begin):
        k = p.any_of(p.opt(j, ":", ","), _SHOWING) or p.opt(j, ":", ",")
        for shown, end in simple(p, k) if len(dims) == 2 and min(dims) > 1 else ():
            marks = shown.traits if isinstance(shown, Noun) else Traits()
            plain = marks == Traits(labels=marks.labels, kind=marks.kind)
            if plain and len(marks.labels) == dims[0] * dims[1] and marks.labels and not marks.open_ended:
                yield Structure(kind="grid", dims=dims, members=shown, span=p.span(i, end)), end
        if len(dims) == 2 and min(dims) > 1 and begin > i and p.stands(j, ("of", "where", "with", "made", "from")):
            one = Structure(kind="grid", det="a", amount=Amount(1, 1), dims=dims, span=p.span(i, j))
            yield from ((grid, end) for grid, end in _tail(p, i, j, one) if end > j or p.stands(j, ("where",)))
        if len(dims) == 2 and min(dims) > 1 and i == 0 and p.stands(j, (":",)):  # "3x3: left column red, ..."
            board = Structure(kind="grid", dims=dims, span=p.span(i, j))
            told = ((x, end) for x, end in _tail(p, i, j, board) if isinstance(x, Structure))
            yield from ((grid, end) for grid, end in told if grid.details)
        if len(dims) == 2 and min(dims) > 1 and p.follows(i, _SHAPED) and (j >= p.end or p.words[j] in _CLOSED):
            yield Structure(kind="grid", dims=dims, span=p.span(i, j)), j


_SHAPED = ("in", "as", "into")
_CLOSED = frozenset({",", ":", "with", "so", "where", "and", "in", "on", "such"})
_SHOWING = ("with", "of", "with the", "of the", "out of", "made of", "showing")


_GRIDS = frozenset({"grid", "grids", "square", "rectangle", "wall", "checkerboard", "arrangement", "matrix"})
"""Of what else rows and columns may be told."""


def _quantities(p: Parser, i: int) -> Iterator[tuple[Quantity, int]]:
    if i > p.last(_named):
        return
    yield from ((q, j) for q, j in amounts.quantity(p, i) if not q.partitive)
    yield Quantity("bare"), i


@rule
def _before(p: Parser, i: int) -> Results[_Before]:
    """Adjectives, sizes and member nouns before the structure's noun."""
    yield _Before(), i
    for first, j in _piece(p, i):
        j = p.opt(j, ",") if p.words[j : j + 1] == [","] and any(True for _ in _piece(p, p.reach(j + 1))) else j
        for rest, k in _before(p, j):
            both = _join(first, rest)
            if both is not None:
                yield both, k


def _join(a: _Before, b: _Before) -> _Before | None:
    marks = merge(a.marks, b.marks)
    whats = [size.what for size in (*a.sizes, *b.sizes)]
    if marks is None or (a.sizes and b.sizes and set(whats) != {"rows", "columns"}) or (a.dims and b.dims):
        return None
    return _Before(
        marks, (*a.sizes, *b.sizes), a.dims or b.dims, a.lines or b.lines,
        a.upright if a.upright is not None else b.upright,
        a.filled if a.filled is not None else b.filled, a.operator or b.operator,
        a.parallel or b.parallel, (*a.details, *b.details),
    )  # fmt: skip


_OF_SO_MANY = (("stack", False), ("row", False), ("line", False), ("column", False))
_BEFORE_UNITS = {
    "block high": "high", "blocks high": "high", "block tall": "high", "blocks tall": "high", "block long": "long",
    "high": "high", "tall": "high",
    "block": "size", "blocks": "size", "cube": "size", "cubes": "size", "level": "layers", "layer": "layers",
    "step": "steps", "story": "layers",
    "tier": "layers", "letter": "size", "stepped": "steps", "tiered": "layers", "layered": "layers", "digit": "size",
    "row": "rows", "rows": "rows", "column": "columns", "columns": "columns",
    "block wide": "wide",
    "blocks wide": "wide", "brick": "size", "item": "size", "wide": "wide",
}  # fmt: skip


@choice
def _piece(p: Parser, i: int) -> Iterator[tuple[_Before, int]]:
    for phrase, j in p.standing(i, MODIFIERS):
        update = MODIFIERS[phrase]
        yield (
            _Before(
                upright=update.get("upright"), filled=update.get("filled"), operator=OPERATORS.get(phrase),
                parallel=phrase == "parallel",
            ),
            j,
        )  # fmt: skip
    for word, j in p.standing(i, DETAILS):
        yield _Before(details=(replace(DETAILS[word], span=p.span(i, j)),)), j
    if (j := p.one(i, ("diagonal", "slanted", "slanting"))) and p.lex(j, lexicon.STRUCTURE) in _OF_SO_MANY:
        yield _Before(details=(Toward(axis=DIAGONAL, span=p.span(i, j)),)), j
    if j := upside_down(p, i):
        yield _Before(details=(Manner(kind="turn", value=180.0, span=p.span(i, j)),)), j
    yield from _colors_before(p, i)
    yield from _laid_before(p, i)
    for found, j in dimensions(p, i):
        for end in dict.fromkeys((j, p.opt(j, "block", "cube", "based"))):
            yield _Before(dims=found, lines=in_lines(p, i, j)), end
    for n, j in amounts.count(p, i):
        for unit, k in p.standing(j, _BEFORE_UNITS):
            yield _Before(sizes=(Size(what=_BEFORE_UNITS[unit], amount=Amount(n, n), span=p.span(i, k)),)), k
        close = j < p.end and (p.tokens[j].joined or (n > 1 and p.follows(i, ("a", "the"))))
        if close and p.peek(j, lexicon.STRUCTURE) in _OF_SO_MANY:  # "a 2-tower"
            yield _Before(sizes=(Size(what="size", amount=Amount(n, n), span=p.span(i, j)),)), j
    for marks, j in adjective(p, i):
        if marks.keys() & {"size", "long"} or p.words[i] == "identical":
            continue
        if "labels" not in marks and ("rank" not in marks or marks["rank"] in ("left", "right")):
            yield _Before(marks=Marks({k: v for k, v in marks.items() if k != "target"})), j
    if p.lex(i, lexicon.BLOCK) is not None:
        yield _Before(), i + 1
    if rank := p.peek(i, RANKS):
        yield _Before(marks=Marks({"rank": rank})), p.reach(i + 1)


@choice
def _colors_before(p: Parser, i: int) -> Iterator[tuple[_Before, int]]:
    """ "an alternating red-blue tower", "a red-white-blue tower": which colours, and in which order."""
    yield from _initials(p, i)
    turns = p.one(i, "alternating")
    if p.lex(turns or i, lexicon.COLOR) is None or p.follows(i, lexicon.COLOR) or p.follows(i, ("alternating",)):
        return
    if not p.anywhere(_STRUCTURES):
        return
    for items, j in listed(p, turns or i):
        joined = all(isinstance(x, Noun) and len(x.traits.colors) == 1 for x in items) and "," not in p.words[i:j]
        if not joined or p.lex(j, lexicon.STRUCTURE) is None or (not turns and "and" in p.words[i:j]):
            continue
        by = "alternating" if turns else "named"
        yield _Before(details=(OrderBy(by=by, items=items, span=p.span(i, j)),)), j


_PRIMARY = {"R": "red", "G": "green", "B": "blue"}


@choice
def _initials(p: Parser, i: int) -> Iterator[tuple[_Before, int]]:
    """ "an RGB tower": red, green and blue, in this order."""
    text = literal(p, i)
    if text is None or sorted(text) != sorted(_PRIMARY) or p.lex(i + 1, lexicon.STRUCTURE) not in _OF_SO_MANY:
        return
    items = tuple(Noun(head="any", traits=Traits(colors=(_PRIMARY[x],)), span=p.span(i, i + 1)) for x in text)
    yield _Before(details=(OrderBy(by="named", items=items, span=p.span(i, i + 1)),)), i + 1


@choice
def _laid_before(p: Parser, i: int) -> Iterator[tuple[_Before, int]]:
    """ "a red-on-blue tower", "a left-to-right line": which block is on which, and which way a line goes."""
    if p.peek(i, SIDES) and p.stands(i + 1, ("to",)):
        for way, j in toward(p, i):
            if p.lex(j, lexicon.STRUCTURE) is not None:
                yield _Before(details=(way,)), j
    if p.lex(i, lexicon.COLOR) is None or not p.stands(i + 1, _ON) or not p.tokens[i + 1].joined:
        return
    first = "top" if p.words[i + 1] in _UPON else "bottom"
    named = [p.peek(i, lexicon.COLOR)]
    j = i + 1
    while p.stands(j, _UPON if first == "top" else _ON - _UPON) and p.tokens[j].joined:
        named.append(p.lex(j + 1, lexicon.COLOR))
        j += 2
    if None not in named and p.lex(j, lexicon.STRUCTURE) == ("stack", False):
        items = tuple(Noun(head="any", traits=Traits(colors=(x,)), span=p.span(i, j)) for x in named if x)
        yield _Before(details=(OrderBy(by="named", items=items, first=first, span=p.span(i, j)),)), j


_UPON = frozenset({"on", "over", "above", "atop"})
_ON = _UPON | {"under", "below"}
_STRUCTURES = frozenset(lexicon.STRUCTURE)


@choice
def _named(p: Parser, i: int) -> Results[object]:
    """Where what names a structure stands, whatever is said in front of it."""
    yield from (found for found in noun(p, i) if found[0][0] != "cube" or _made_up(p, found[1]) or _dims_told(p))
    if j := p.any_of(i, _CODES):
        yield None, j
    yield from equation(p, i)


_OUTLINES = frozenset({"outline", "frame"})
_POINTED = frozenset({"that", "this", "these", "those"})
_TOLD_BY = frozenset({":", ",", "of", "with", "that", "which", "made", "from", "in", "(", "where", "whose", "using"})
"""What may stand between "this tower" and what is told of it."""
_CODES = ("number", "year", "pin", "code")


def _dims_told(p: Parser) -> bool:
    return any(token.kind == "dims" or token.word == "by" for token in p.tokens)


def _made_up(p: Parser, k: int) -> bool:
    """Whether a cube is one of several blocks, as what follows the word tells."""
    if p.any_of(k, ("of", "out of", "made of", "made out of", "made from", "from", "that is made of", "built of")):
        return True
    if (m := p.any_of(k, ("with", ","))) and (p.number(m) is not None or p.lex(m, EDGES)):
        return True
    return p.number(k) is not None and p.stands(k + 1, ("wide", "long", "deep", "high", "tall"))


def _kinds(p: Parser, i: int, j: int, quantity: Quantity, before: _Before) -> Results[Meaning]:
    for (kind, plural), k in noun(p, j):
        if kind == "cube" and len(before.dims) != 3 and not _made_up(p, k):
            continue
        if before.parallel and (not plural or kind not in ("row", "column")):
            continue
        rank = before.marks.get("rank")
        if rank and (plural or quantity.det not in ("the", "a") or before.sizes or before.dims):
            continue
        if rank and quantity.det == "a":
            if not rank.isdigit():
                continue
            marks = Marks({key: value for key, value in before.marks.items() if key != "rank"})
            before, quantity = replace(before, marks=marks), Quantity("another", quantity.amount)
        if plural and kind in ("row", "column") and p.anywhere(_GRIDS) and i > 2 and rows_and_columns(p, i - 3):
            continue  # "a grid of two rows and three columns"
        several = quantity.amount is not None and quantity.amount.low > 1 and p.number(j - 1) is not None
        plural = plural or (several and p.words[k - 1] == "tower")  # "two tower", and not "two-block tower"
        if (plural and quantity.det in ("a", "each")) or (quantity.amount and quantity.amount.low > 1 and not plural):
            continue
        if p.words[k - 1] in ("stairs", "steps") and quantity.amount is not None and quantity.amount.low > 1:
            steps = Size(what="steps", amount=quantity.amount, span=p.span(i, k))
            plural, quantity, before = False, Quantity("a"), replace(before, sizes=(*before.sizes, steps))
        operator = before.operator or (OPERATORS.get(p.words[k - 1]) if kind == "equation" else None)
        filled = False if not _OUTLINES.isdisjoint(p.words[j:k]) else before.filled
        if p.words[k - 1] in ("countdown", "countdowns"):
            down = OrderBy(by="number", descending=True, span=p.span(j, k))
            before = replace(before, details=(*before.details, down))
        dims = before.dims[::-1] if before.lines and kind == "wall" else before.dims  # a wall is measured by its width
        base = Structure(
            kind=kind, det=quantity.det, amount=quantity.amount, plural=plural, sizes=before.sizes, dims=dims,
            traits=Traits(**before.marks), filled=filled, upright=before.upright, letter=operator,
            details=before.details,
            span=p.span(i, k), cost=1 if kind == "cube" and not before.dims else 0,
        )  # fmt: skip
        pointed = p.stands(i, _POINTED) and not p.stands(k, _TOLD_BY)  # "next to that tower blue on yellow"
        for found, end in [(base, k)] if pointed else _tail(p, i, k, base):
            yield found, end
            yield from ring_around(p, i, end, found)
    if (k := p.any_of(j, _CODES)) and (digits := digits_of(p, k)) is not None:
        yield Structure(kind="word", det="the", letter=digits, span=p.span(j, k + 1)), k + 1
    for text, k in equation(p, j):
        end = p.any_of(p.opt(k, ","), _SHOWN) or k
        again = p.opt(end, ":", ",", "=")
        end = next((m for same, m in equation(p, again) if again > end and same == text), end)
        yield Structure(kind="equation", det="the", letter=text, span=p.span(j, end)), end


def _said_by_it(p: Parser, j: int, base: Structure) -> Iterator[tuple[str, int]]:
    """ "A row that reads FOX (stands on the mat)": what it says, as the subject of a verb."""
    line = base.kind in ("row", "line") and base.det == "a" and not (base.plural or base.sizes)
    k = p.any_of(j, _READS) if line else 0
    if k and (text := literal(p, k)) is not None and len(text) > 1 and p.stands(k + 1, _STANDS):
        yield text, k + 1


_READS = (
    *(f"{that} {reads}" for that in ("that", "which") for reads in ("reads", "spells", "says")),
    "reading", "spelling", "saying",
)  # fmt: skip
_STANDS = frozenset({"stands", "is", "lies", "sits", "goes", "should", "must", "shall", "has"})


def _tail(p: Parser, i: int, j: int, base: Structure) -> Results[Meaning]:
    """What follows the noun: "of three green blocks", "three blocks high", "with a 3x3 base", a word in quotes."""
    if base.kind == "word":
        text = literal(p, p.opt(p.any_of(j, (", namely", "namely", ", for example", "such as")) or j, ":"))
        if text is not None:
            end = p.opt(p.any_of(j, (", namely", "namely", ", for example", "such as")) or j, ":") + 1
            yield replace(base, letter=text, span=p.span(i, end)), end
        else:
            yield base, j
        return
    if base.kind == "equation" and (k := p.any_of(j, _TRUE)):
        yield replace(base, span=p.span(i, k)), k
    if base.kind == "equation":
        told = p.any_of(p.any_of(j, _SHOWN) or j, _SAYS) or p.opt(p.any_of(j, _SHOWN) or j, ":", ",")
        for text, k in (*equation(p, told), *unequal(p, told), *promised(p, j)):
            yield replace(base, letter=text, span=p.span(i, k)), k
        for result, k in result_alone(p, j):
            yield replace(base, letter=f"{base.letter or '+'}={result}", span=p.span(i, k)), k
    for text, k in _said_by_it(p, j, base):
        yield Structure(kind="word", det="the", letter=text, span=p.span(i, k)), k
    for pattern, k in per_color(p, j):
        base = replace(base, plural=True, details=(*base.details, pattern))
        yield from sized_members(p, i, k, base)
        return
    yield from sized_members(p, i, j, base)
