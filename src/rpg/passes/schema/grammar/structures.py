"""Structures as noun phrases: towers, rows, grids, pyramids, figures, words, equations, with their sizes and members."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from rpg.passes.schema import lexicon
from rpg.passes.schema.grammar import amounts
from rpg.passes.schema.grammar.adjectives import EMPTY, Marks, adjective, merge
from rpg.passes.schema.grammar.amounts import Quantity
from rpg.passes.schema.grammar.core import Parser, Results, rule
from rpg.passes.schema.grammar.labels import literal
from rpg.passes.schema.meaning import Amount, Meaning, Size, Structure, Traits

_LETTER_SHAPES = frozenset("LTVUX")
_MODIFIERS = {
    "straight": {}, "horizontal": {"upright": False}, "vertical": {"upright": True}, "flat": {"upright": False},
    "filled": {"filled": True}, "solid": {"filled": True}, "hollow": {"filled": False}, "outlined": {"filled": False},
    "simple": {}, "single": {}, "complete": {}, "perfect": {}, "nice": {}, "new": {}, "upright": {"upright": True},
    "single file": {}, "standing": {"upright": True}, "tall": {}, "long": {}, "closed": {}, "proper": {}, "full": {"filled": True},
    "correct": {}, "valid": {}, "true": {}, "math": {}, "mathematical": {}, "arithmetic": {}, "addition": {}, "small": {},
    "single digit": {}, "ordered": {}, "sorted": {}, "separate": {}, "separated": {}, "distinct": {}, "individual": {}, "neat": {},
}  # fmt: skip
_OPERATORS = {"addition": "+", "subtraction": "-", "multiplication": "*", "division": "/"}


@dataclass(frozen=True)
class _Before:
    """What stood in front of the structure's noun."""

    marks: Marks = EMPTY
    size: Amount | None = None
    dims: tuple[int, ...] = ()
    upright: bool | None = None
    filled: bool | None = None
    operator: str | None = None


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
    if marks is None or (a.size and b.size) or (a.dims and b.dims):
        return None
    return _Before(
        marks, a.size or b.size, a.dims or b.dims,
        a.upright if a.upright is not None else b.upright,
        a.filled if a.filled is not None else b.filled, a.operator or b.operator,
    )  # fmt: skip


def _piece(p: Parser, i: int) -> Iterator[tuple[_Before, int]]:
    for phrase, update in _MODIFIERS.items():
        if j := p.seq(i, phrase):
            operator = _OPERATORS.get(phrase)
            yield _Before(upright=update.get("upright"), filled=update.get("filled"), operator=operator), j
    for found, j in dimensions(p, i):
        yield _Before(dims=found), p.opt(j, "block", "cube")
    for n, j in amounts.count(p, i):
        for unit in ("block high", "blocks high", "block tall", "blocks tall", "block long", "high", "tall", "block", "blocks", "cube",
                     "cubes", "level", "layer", "step", "story", "storey", "tier", "letter", "stepped", "tiered", "layered", "digit",
                     "block wide", "blocks wide", "brick", "item"):  # fmt: skip
            if k := p.seq(j, unit):
                yield _Before(size=Amount(n, n)), k
    for marks, j in adjective(p, i):
        if ("rank" not in marks and "labels" not in marks) or ("rank" in marks and marks["rank"] in ("left", "right")):
            yield _Before(marks=Marks({k: v for k, v in marks.items() if k not in ("target", "long")})), j
    for table in (lexicon.BLOCK,):
        plural = p.lex(i, table)
        if plural is not None:
            yield _Before(), i + 1


@rule
def dimensions(p: Parser, i: int) -> Results[tuple[int, ...]]:
    """ "3x3", "3 by 3 by 3", "two by four"."""
    token = p.token(i)
    if token is not None and token.kind == "dims" and isinstance(token.value, tuple):
        p.reach(i + 1)
        yield token.value, i + 1
    first = p.number(i)
    if first is not None and p.words[i + 1 : i + 2] in (["by"], ["x"], ["times"]):
        second = p.number(i + 2)
        if second is not None:
            third = p.number(i + 4) if p.words[i + 3 : i + 4] in (["by"], ["x"], ["times"]) else None
            if third is not None:
                yield (first, second, third), i + 5
            else:
                yield (first, second), i + 3


def _noun(p: Parser, i: int) -> Iterator[tuple[str, bool, dict[str, Any], int]]:
    """The structure's noun: (kind, plural, fields, next)."""
    found = p.lex(i, lexicon.STRUCTURE)
    if found is not None and not (p.tokens[i].kind != "word"):
        kind, plural = found
        j = i + 1
        j = (
            p.opt(j, "shape", "formation", "outline", "pattern", "arrangement", "figure")
            if kind not in ("stack", "pile", "word")
            else j
        )
        yield kind, plural, {}, j
        if kind == "plus":
            yield "plus", plural, {}, p.opt(j, "sign", "shape")
    shape = p.lex(i, lexicon.SHAPE_ADJECTIVE)
    if shape and (
        j := p.one(
            i + 1,
            frozenset(
                {"shape", "arrangement", "formation", "pattern", "layout", "outline", "figure", "form", "line", "ring"}
            ),
        )
    ):
        yield shape, False, {}, j
    if p.words[i : i + 1] in (["cube"], ["cubes"], ["box"], ["block"]):
        yield "cube", p.words[i] == "cubes", {}, p.reach(i + 1)
    token = p.token(i)
    if token is not None and token.kind in ("word", "quote", "literal") and len(token.raw.strip("'\"`")) == 1:
        letter = token.raw.strip("'\"`").upper()
        if letter in _LETTER_SHAPES or (letter == "O"):
            for tail in ("shape", "shapes", "formation", "shaped figure", "shaped structure", "shaped pattern", "shaped arrangement", "figure",
                         "shaped formation", "shaped line"):  # fmt: skip
                if j := p.seq(i + 1, tail):
                    yield ("circle" if letter == "O" else letter), tail == "shapes", {}, j
    for lead in ("shape of an", "shape of a", "shape of the letter", "form of an", "form of a", "figure of an", "figure of a", "shape of the",
                 "form of the letter", "capital", "figure of the letter", "letter"):  # fmt: skip
        if j := p.seq(i, lead):
            token = p.token(j)
            if token is not None and len(token.word) == 1 and token.word.upper() in _LETTER_SHAPES:
                if lead not in ("capital", "letter") or p.one(j + 1, frozenset({"shape", "formation"})):
                    p.reach(j + 1)
                    yield token.word.upper(), False, {}, p.opt(j + 1, "shape", "formation")
            elif lead.startswith(("shape", "form", "figure")):
                inner = p.lex(j, lexicon.STRUCTURE)
                if inner:
                    yield inner[0], False, {}, p.opt(j + 1, "sign", "shape")


def _kinds(p: Parser, i: int, j: int, quantity: Quantity, before: _Before) -> Results[Meaning]:
    for kind, plural, extra, k in _noun(p, j):
        if kind == "cube" and len(before.dims) != 3:
            continue
        if (
            kind == "set"
            or (plural and quantity.det in ("a", "each"))
            or (quantity.amount and quantity.amount.low > 1 and not plural)
        ):
            continue
        if kind == "grid" and not before.dims and p.words[j] in ("array",) and False:
            continue
        base = Structure(
            kind=kind, det=quantity.det, amount=quantity.amount, plural=plural, size=before.size, dims=before.dims,
            traits=Traits(**before.marks), filled=before.filled, upright=before.upright, letter=before.operator,
            span=p.span(i, k), **extra,
        )  # fmt: skip
        yield from _tail(p, i, k, base)
    if (e := p.token(j)) is not None and e.kind == "equation" and isinstance(e.value, str):
        p.reach(j + 1)
        yield Structure(kind="equation", det="the", letter=e.value, span=p.span(i, j + 1)), j + 1


def _tail(p: Parser, i: int, j: int, base: Structure) -> Results[Meaning]:
    """What follows the noun: "of three green blocks", "three blocks high", "with a 3x3 base", a word in quotes."""
    if base.kind == "word":
        text = literal(p, j)
        if text is not None:
            yield replace(base, letter=text, span=p.span(i, j + 1)), j + 1
        elif base.det != "the":
            yield base, j
        return
    if base.kind == "equation":
        token = p.token(j)
        if token is not None and token.kind == "equation" and isinstance(token.value, str):
            yield replace(base, letter=token.value, span=p.span(i, j + 1)), p.reach(j + 1)
    for sized, k in _sized(p, i, j, base):
        yield sized, k
        yield from _members(p, i, k, sized)


@rule
def _sized(p: Parser, i: int, j: int, base: Structure) -> Results[Structure]:
    yield base, j
    for size, k in size_phrase(p, j):
        if not base.size and not base.dims:
            changed = replace(base, size=size.amount, dims=size.dims, span=p.span(i, k))
            yield changed, k


@rule
def size_phrase(p: Parser, i: int) -> Results[Size]:
    """ "three blocks high", "of height 3", "with a 3x3 base", "with four steps", "5 long"."""
    j = p.opt(i, ",")
    j = p.opt(j, "that", "which")
    j = p.opt(j, "is", "are") if j > i else j
    for found, k in amounts.amount(p, j):
        k = p.opt(k, "block", "blocks", "cube", "cubes", "level", "levels", "layer", "layers")
        if end := p.any_of(k, ("high", "tall", "long", "wide", "in height", "in length", "in a row", "deep")):
            yield Size(what="size", amount=found, span=p.span(i, end)), end
    if k := p.any_of(i, ("of height", "with height", "of length", "with a height of", "with a length of", "of size")):
        for found, end in amounts.amount(p, k):
            yield Size(what="size", amount=found, span=p.span(i, end)), p.opt(end, "blocks", "cubes")
        for dims, end in dimensions(p, k):
            yield Size(what="dims", dims=dims, span=p.span(i, end)), end
    if k := p.any_of(i, ("with", "of", "having", "that has", "which has", "containing")):
        for found, e in amounts.amount(p, k):
            if end := p.one(
                e, frozenset({"steps", "levels", "layers", "tiers", "rows", "stairs", "stories", "step", "floors"})
            ):
                yield Size(what="size", amount=found, span=p.span(i, end)), end
        k = p.opt(k, "a", "an")
        for dims, e in dimensions(p, k):
            if end := p.one(p.opt(e, "block", "blocks"), frozenset({"base", "foundation", "bottom", "footprint"})):
                yield Size(what="base", dims=dims, span=p.span(i, end)), end
        for found, e in amounts.amount(p, k):
            if end := p.any_of(
                e,
                ("block base", "blocks base", "cube base", "wide base", "block wide base", "base", "blocks wide base"),
            ):
                yield Size(what="base", amount=found, span=p.span(i, end)), end
        if e := p.any_of(
            k, ("base of", "bottom layer of", "bottom row of", "foundation of", "side of", "sides of", "side length of")
        ):
            for dims, end in dimensions(p, e):
                yield Size(what="base", dims=dims, span=p.span(i, end)), p.opt(end, "blocks", "cubes")
            for found, end in amounts.amount(p, e):
                yield Size(what="base", amount=found, span=p.span(i, end)), p.opt(end, "blocks", "cubes")


def _members(p: Parser, i: int, j: int, base: Structure) -> Results[Meaning]:
    from rpg.passes.schema.grammar.nouns import noun_phrase, simple

    k = p.any_of(j, ("of", "made of", "made out of", "made from", "made up of", "built from", "consisting of", "composed of",
                     "built of", "formed by", "formed of", "comprising", "containing", "using", "constructed from", "out of",
                     "built with", "made with", "with only", "from"))  # fmt: skip
    if not k:
        return
    whole = "of" in p.words[j:k]
    for each in (False, True):
        start = p.one(k, "each") if each else k
        if not start:
            continue
        for members, end in noun_phrase(p, start) if whole else simple(p, start):
            if isinstance(members, Structure) and base.kind not in (
                "row",
                "grid",
                "pile",
                "circle",
                "column",
                "square",
            ):
                continue
            count = members_amount(members)
            listed = replace(base, members=members, span=p.span(i, end), each_size=count is not None and base.plural)
            yield listed, (p.opt(end, "each") if base.plural else end)
    if base.size is None and not base.plural:
        for found, end in amounts.amount(p, k):
            yield replace(base, size=found, span=p.span(i, end), cost=1), end


def members_amount(members: Meaning) -> Amount | None:
    """The number that a members phrase gives."""
    return getattr(members, "amount", None)
