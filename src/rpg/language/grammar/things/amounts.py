"""Determiners and quantities: "the two", "exactly three of the four", "half a dozen", "none of the"; lengths."""

from __future__ import annotations

from typing import NamedTuple

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.things.left_alone import left_alone
from rpg.language.meaning import Amount


class Quantity(NamedTuple):
    """A determiner with its amount. `partitive`: "of the ..." must follow. `plural`: None when it does not say."""

    det: str
    amount: Amount | None = None
    plural: bool | None = None
    partitive: bool = False


THE = frozenset({"the", "these", "those", "this", "that", "my", "your", "our"})
_VAGUE = (
    "several", "a few", "many", "multiple", "various", "a number of", "a set of", "a collection of", "a series of",
    "a bunch of", "a handful of", "some", "lots of", "a lot of", "a variety of", "a group of", "a mix of",
    "a mixture of", "any number of",
)  # fmt: skip
_LOW = ("at least", "no fewer than", "no less than", "not fewer than", "not less than", "a minimum of", "minimum",
        "at the least", "at the very least", "at a minimum", "minimally", "upwards of")  # fmt: skip
_HIGH = ("at most", "no more than", "up to", "a maximum of", "maximum", "not more than", "never more than",
         "at the most", "at the very most", "at a maximum", "maximally")  # fmt: skip
_EXACT = ("exactly", "precisely", "only", "just")
_SINGLE = ("one and only one", "one but only one", "one , and only one", "one and exactly one", "just the one")


_DOZENS = {
    "a pair of": 2, "a couple of": 2, "a couple": 2, "pair of": 2, "couple of": 2, "half a dozen": 6,
    "a half dozen": 6, "half dozen": 6, "a half a dozen": 6, "a dozen": 12, "one dozen": 12, "a full dozen": 12,
    "two dozen": 24, "dozen": 12, "a duo of": 2, "a twosome of": 2, "a trio of": 3, "a threesome of": 3,
    "a triple of": 3, "a triplet of": 3, "a quartet of": 4, "a foursome of": 4, "a quintet of": 5, "a sextet of": 6,
}  # fmt: skip
"""Numbers of several words; what one begins with stands behind it."""
_ALTOGETHER = ("a total of", "a set of", "altogether", "a handful of")
"""What may stand ahead of a number and changes nothing."""
_PIECES = ("pieces of", "pieces", "units of", "items of", "x")
"""What may be counted in place of blocks that are named behind it."""
_NAMED = frozenset({*lexicon.COLOR, *lexicon.BLOCK})


@rule
def count(p: Parser, i: int) -> Results[int]:
    """A bare whole number: "two", "3", "a pair of", "half a dozen", "a total of three", "three pieces of",
    "three (3)"."""
    for phrase, j in p.standing(i, _DOZENS):
        yield _DOZENS[phrase], (p.opt(j, "of") if "dozen" in phrase else j)
        return
    if all_ := p.any_of(i, _ALTOGETHER):
        yield from count(p, all_)
    number = p.number(i)
    if number is not None:
        tens = p.number(i + 1) if number in range(20, 60, 10) and p.token(i).kind == "word" else None  # type: ignore[union-attr]
        if tens is not None and 0 < tens < 10:
            yield number + tens, i + 2
        else:
            yield number, i + 1
            named = p.any_of(i + 1, _PIECES)
            if named and p.stands(named, _NAMED):
                yield number, named
            if p.stands(i + 1, ("(",)) and p.number(i + 2) == number and (again := p.one(i + 3, ")")):
                yield number, again


@rule
def amount(p: Parser, i: int) -> Results[Amount]:
    """A number with its bounds: "exactly two", "at least 3", "two or three", "between 2 and 4"."""
    if only := p.any_of(i, _SINGLE):
        yield Amount(1, 1, True), only
        return
    if either := p.one(i, "either"):
        for n, j in count(p, either):
            yield from ((Amount(n, m, True), k) for m, k in count(p, p.one(j, "or")) if p.one(j, "or") and m > n)
    for n, j in count(p, i):
        yield Amount(n, n), j
        if k := p.any_of(j, ("or more", "and more", "or even more")):
            yield Amount(n, None, True), k
        if k := p.any_of(j, ("or fewer", "or less")):
            yield Amount(0, n, True), k
        if k := p.one(j, ("or", "to")):
            for m, after in count(p, k):
                if m > n:
                    yield Amount(n, m, True), after
            if n == 1 and (both := p.one(k, "both")):
                yield Amount(1, 2, True), both
    for phrases, kind in ((_EXACT, "exact"), (_LOW, "low"), (_HIGH, "high")):
        if j := p.any_of(i, phrases):
            for n, k in count(p, j):
                bounds = {"exact": (n, n), "low": (n, None), "high": (0, n)}[kind]
                yield Amount(bounds[0], bounds[1], True), k
    yield from _both_bounds(p, i)
    if j := p.seq(i, "more than"):
        yield from ((Amount(n + 1, None, True), k) for n, k in count(p, j))
    if j := p.any_of(i, ("fewer than", "less than")):
        yield from ((Amount(0, n - 1, True), k) for n, k in count(p, j) if n > 0)
    if j := p.one(i, "between"):
        for n, k in count(p, j):
            if k := p.one(k, "and"):
                yield from ((Amount(n, m, True), after) for m, after in count(p, k) if m > n)


@choice
def _both_bounds(p: Parser, i: int) -> Results[Amount]:
    """ "At least one, but no more than two,", "some, but at most two", "fewer than four but more than one": both ends
    of a range, of which either is said first."""
    lows, highs = [*_least(p, i)], [*_most(p, i)]
    for n, j in (*lows, *highs):
        but = p.any_of(j, (", but", "but", "and", ", and", ","))
        for m, k in (_most(p, but) if lows else _least(p, but)) if but else ():
            if (n <= m) if lows else (m <= n):
                yield Amount(min(n, m), max(n, m), True), k
                if p.words[j] == "," and (closed := p.one(k, ",")):
                    yield Amount(min(n, m), max(n, m), True), closed


def _least(p: Parser, i: int) -> Results[int]:
    """The low end of a range."""
    if j := p.any_of(i, _LOW):
        yield from count(p, j)
    if j := p.seq(i, "more than"):
        yield from ((n + 1, k) for n, k in count(p, j))
    if some := p.one(i, "some"):
        yield 1, some


def _most(p: Parser, i: int) -> Results[int]:
    """The high end of a range."""
    if j := p.any_of(i, _HIGH):
        yield from count(p, j)
    if j := p.any_of(i, ("fewer than", "less than")):
        yield from ((n - 1, k) for n, k in count(p, j) if n > 0)


_ENOUGH = ("enough", "just enough", "sufficiently many", "sufficient", "as many as needed")
_FOR_WHAT = frozenset({"make", "form", "build", "get", "reach", "until", "create"})
"""What there has to be enough for is told by one of these."""


@rule
def quantity(p: Parser, i: int) -> Results[Quantity]:
    """Everything that may stand before the adjectives of a noun phrase."""
    yield from _universal(p, i)
    yield from _shares(p, i)
    if (
        p.words[i : i + 1] in (["n"], ["k"])
        and i + 1 < p.end
        and (p.words[i + 1].endswith("s") or p.words[i + 2 : i + 3] != [""])
    ):
        yield Quantity("some", None, True), p.reach(i + 1)
    if j := p.one(i, ("a", "an")):
        yield Quantity("a", Amount(1, 1), False), j
        if k := p.one(j, "single"):
            yield Quantity("a", Amount(1, 1), False), k
    if j := p.one(i, THE):
        yield Quantity("the"), p.seq(j, "one and only") or j
        for found, k in amount(p, j):
            yield Quantity("the", found, found.high != 1), k
    yield from _but_not_all(p, i)
    for found, j in amount(p, i):
        yield Quantity("bare", found, found.high != 1), j
        of = p.any_of(j, ("of", "out of")) or _out_of_so_many(p, j)
        if k := j if p.words[j - 1] == "of" and p.one(j, THE) else of:  # "a pair of the four"
            yield Quantity("some", found, True, partitive=True), k
        if k := p.one(j, ("more", "other", "additional", "extra")):
            yield Quantity("other" if p.words[j] == "other" else "another", found, found.high != 1), k
    if j := p.any_of(i, _VAGUE):
        yield Quantity("some", None, True), j
    if (j := p.any_of(i, _ENOUGH)) and not _FOR_WHAT.isdisjoint(p.words[j:]):
        yield Quantity("some", None, True), j
    if j := p.one(i, ("its", "their")):
        yield Quantity("its"), j
    yield from _others(p, i)


def _out_of_so_many(p: Parser, j: int) -> int:
    """ "Two from the four", "two among the four": where the others are counted, it is of them, and no place."""
    k = p.one(j, ("from", "among"))
    return k if k and p.one(k, "the") and p.number(k + 1) is not None else 0


_NOT_ALL = tuple(f"{lead} not all{of}" for lead in (", but", "but", "and", ", and", "though", ", though")
                 for of in (" of", " , of"))  # fmt: skip


@choice
def _but_not_all(p: Parser, i: int) -> Results[Quantity]:
    """ "Some, but not all of the", "at least two but not all of the": up to one less than there are."""
    for n, j in _least(p, i):
        if of := p.any_of(j, _NOT_ALL):
            yield Quantity("some", Amount(n, -1, True), True, partitive=True), of


_SHARES = {
    "half of": "half", "half": "half", "one half of": "half", "a half of": "half", "exactly half of": "half",
    "a third of": "third", "one third of": "third", "a quarter of": "quarter", "one quarter of": "quarter",
    "two thirds of": "two thirds", "three quarters of": "three quarters", "three fourths of": "three quarters",
    "most of": "most", "the majority of": "most", "a majority of": "most", "more than half of": "most",
    "at least half of": "at least half", "half or more of": "at least half", "no fewer than half of": "at least half",
    "at most half of": "at most half", "no more than half of": "at most half", "not more than half of": "at most half",
    "less than half of": "less than half", "fewer than half of": "less than half",
    "not all of": "not all", "not all": "not all", "not every one of": "not all", "some but not all": "some",
    "not both of": "not all", "not both": "not all", "not every": "not all",
}  # fmt: skip


@choice
def _shares(p: Parser, i: int) -> Results[Quantity]:
    """ "half of the", "most of the", "not all of the", "all but one of the": a share of a number."""
    for phrase, j in p.standing(i, _SHARES):
        if p.words[j : j + 1] and (_SHARES[phrase] == "not all" or p.words[j] in THE | {"them", "all"}):
            yield Quantity(_SHARES[phrase], None, True, partitive=True), j
    if j := p.any_of(i, ("all but", "all except", "everything but")):
        for found, k in count(p, j):
            if of := p.one(k, "of"):
                yield Quantity("all but", Amount(found, found), True, partitive=True), of


_UNIVERSAL = {
    "all": "all", "both": "both", "each": "each", "every": "each", "any": "any", "no": "no", "none": "no",
    "neither": "no", "not one": "no", "either": "any", "one": "any", "whichever": "any",
}  # fmt: skip
"""Words for all or for any, and the determiner that they come to."""


@choice
def _universal(p: Parser, i: int) -> Results[Quantity]:
    for word, j in p.standing(i, _UNIVERSAL):
        det = _UNIVERSAL[word]
        if det == "both":
            fixed: Amount | None = Amount(2, 2)
        elif word == "neither":
            fixed = Amount(2, 2, True)
        else:
            fixed = None
        j = p.opt(j, "single") if det in ("each", "no") else j
        of = p.one(j, "of")
        if of:
            yield Quantity(det, Amount(1, 1) if word in ("one", "whichever") else fixed, True, partitive=True), of
        if word in ("any", "whichever") and (of := next((p.one(k, "of") for _, k in count(p, j)), 0)):
            yield from ((Quantity("some", Amount(n, n), True, partitive=True), of) for n, _ in count(p, j) if n > 1)
        if word in ("each", "every", "any") and (of := p.seq(j, "one of")):
            yield Quantity(det, fixed if det != "any" else Amount(1, 1), True, partitive=True), of
        bare = p.peek(j, lexicon.COLOR) and not p.peek(j + 1, lexicon.BLOCK) and not p.stands(j + 1, ("or", ","))
        if word in ("none", "one", "not one") or (word == "either" and bare):
            continue
        plural = None if det in ("any", "no") else det != "each"
        if word == "no" and (k := p.one(j, ("other", "further", "additional"))):
            yield Quantity("no other", None, None), k
            continue
        yield Quantity(det, fixed, plural), j
        k = p.one(j, THE)
        if k and det in ("all", "both"):
            yield Quantity(det, fixed, True), k
            j = k
        if det in ("all", "any", "no"):
            for found, k in amount(p, j):
                yield Quantity("bare" if det == "any" and found.low > 1 else det, found, found.high != 1), k
                if det == "no" and (of := p.one(k, "of")):
                    yield Quantity(det, found, True, partitive=True), of


@choice
def _others(p: Parser, i: int) -> Results[Quantity]:
    if j := p.one(i, "another"):
        yield Quantity("another", Amount(1, 1), False), j
        for found, k in amount(p, j):
            yield Quantity("another", found, found.high != 1), k
    without = p.words[i - 2] == "without" if p.follows(i, ("touching",)) else False
    if (j := p.seq(i, "any other")) and not (without or left_alone(p, i)):
        yield Quantity("another", Amount(1, 1), False), j
    if j := p.seq(i, "all other"):
        yield Quantity("other"), j
    j = p.opt(i, "all")
    j = p.opt(j, "of")
    if j := p.any_of(j, ("the other", "the remaining", "the rest of the", "the others of the", "the leftover")):
        yield Quantity("other"), j
        for found, k in amount(p, j):
            yield Quantity("other", found, found.high != 1), k
    if j := p.seq(i, "the"):
        for found, k in amount(p, j):
            if k := p.one(k, ("other", "remaining")):
                yield Quantity("other", found, found.high != 1), k


@rule
def length(p: Parser, i: int) -> Results[float]:
    """A length in metres: "5 cm", "half a centimetre", "two inches"."""
    value = p.figure(i)
    if value is not None:
        spelt = p.words[i + 1] == "in" and p.tokens[i].kind == "word"  # "put two in the corner", "TEN in white letters"
        factor = p.lex(i + 1, lexicon.UNIT) if not spelt and not _so_colored(p, i + 1) else None
        if factor is not None:
            yield round(value * factor, 6), i + 2
    j = p.one(i, ("a", "an", "one"))
    if j and not p.stands(j, ("in",)) and (factor := p.lex(j, lexicon.UNIT)) is not None and factor < 1:
        yield factor, j + 1
    if j := p.any_of(i, ("half a", "half an")):
        factor = p.lex(j, lexicon.UNIT)
        if factor is not None:
            yield factor / 2, j + 1


def _so_colored(p: Parser, i: int) -> bool:
    """ "The digit 2 in red (on the mat)", "the letter A in blue": no inches, as in "a 2 in red cube"; nor are there any
    in "the 3 in between (the 7 and the 8)"."""
    if p.words[i : i + 1] != ["in"]:
        return False
    if p.words[i + 1] not in lexicon.COLOR:
        return i > 1 and p.words[i - 2] in _SHOWN and p.words[i + 1] in ("between", "front", "the")
    behind = i + 2
    while p.words[behind] in lexicon.COLOR or p.words[behind] in ("and", "or"):
        behind += 1
    return p.words[behind] not in lexicon.BLOCK and p.words[behind] not in lexicon.LOOSE_BLOCK


_SHOWN = frozenset({"the", "digit", "number", "block", "cube"})
"""Behind these a number is what a block shows."""
_WIDE = ("block width", "block widths", "cube width", "cube widths", "block", "blocks", "cube", "cubes", "empty block",
         "empty blocks", "block 's width", "cube 's width", "block length", "block lengths", "cube length",
         "cube lengths", "block size", "width of a block", "further block", "more block")  # fmt: skip
_SIZED = frozenset({"edge", "edges", "sized", "size", "sizes", "big", "large", "small", "larger", "smaller", "bigger"})
"""With these words a block is not said to be as wide as blocks are."""
USUAL_EDGE = 0.04


@rule
def block_widths(p: Parser, i: int) -> Results[float]:
    """ "(a gap of) one block", "(room for) two cubes": as wide as so many blocks, in metres."""
    many: float | None = p.number(i) or (1 if p.stands(i, ("a", "an")) else None)
    at = i + 1
    if half := p.any_of(i, ("half a", "half the", "half of a", "one half of a")):
        many, at = 0.5, half
    elif many is not None and (half := p.any_of(at, ("and a half",))):
        many, at = many + 0.5, half
    j = p.any_of(at, _WIDE) if many is not None else 0
    if many is not None and j and p.all.isdisjoint(_SIZED):
        yield round(many * USUAL_EDGE, 6), j


_LENGTHS = ("edge length", "edge lengths", "side length", "side lengths",
            *(f"{block} {wide}" for block in ("block", "cube", "brick", "block 's", "cube 's")
              for wide in ("width", "widths", "length", "lengths", "edge", "edges")))  # fmt: skip
_OTHER_SIZES = _SIZED - {"edge", "edges"}


@rule
def edge_lengths(p: Parser, i: int) -> Results[float]:
    """ "Two edge lengths", "one block width": a distance in metres."""
    many = p.figure(i)
    many = 1.0 if many is None and p.stands(i, ("a", "an")) else many
    if many is not None and (j := p.any_of(i + 1, _LENGTHS)) and p.all.isdisjoint(_OTHER_SIZES):
        yield round(many * USUAL_EDGE, 6), j


def makes_number(p: Parser, k: int) -> bool:
    """Whether what follows a digit makes it a number: "3 blocks", "2 red ..."."""
    word = p.words[k] if k < p.end else ""
    tables = (
        lexicon.BLOCK,
        lexicon.LOOSE_BLOCK,
        lexicon.COLOR,
        lexicon.STRUCTURE,
        lexicon.UNIT,
        lexicon.LETTER,
        lexicon.DIGIT,
        lexicon.SIZE,
        lexicon.PATCH,
    )
    return (word != "in" and any(word in table for table in tables)) or word in (
        "of",
        "by",
        "x",
        "more",
        "steps",
        "rows",
        "layers",
        "high",
        "wide",
        "each",
        "other",
        "letters",
    )


def of_more(p: Parser, i: int, begin: int | None = None) -> bool:
    """ "a tower of three and a row of four, all green": said of more than the last of several that have no look."""
    return p.stands(i, ("all",)) and "and" in p.words[:i][:begin] and lexicon.COLOR.keys().isdisjoint(p.words[:i])
