"""Sentences that tell no more than what there is: "on the table lie ...", "... are given", "the scene contains ..."."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.inventories.lots import (
    Lots,
    apart,
    count_at,
    labelled,
    lots_at,
    total_at,
    with_nouns,
    with_their_patches,
    words_at,
)
from rpg.language.tokens import Token


@dataclass(frozen=True)
class Stock:
    """What a sentence says there is. `closed`: and nothing else; `lying`: it says that this is on the table; `beside`:
    the blocks are told to be next to the mat."""

    lots: Lots
    closed: bool = False
    lying: bool = False
    beside: bool = False


_TABLE = "the|a|an|my|your|our empty|otherwise_empty? table|table_top|tabletop|workspace"
_LIE = "is|are|lie|lies|stand|stands|sit|sits|rest|rests"
_LYING = f"{_LIE}|is_lying|are_lying|is_placed|are_placed|is_standing|are_standing|is_laid_out|are_laid_out"
_LYING += "|are_put|have_been_placed|has_been_placed|have_been_put|has_been_put|were_placed|were_put|was_placed|was_put"
_SEE = "have|see|find|get|have_got|can_see|will_find|can_use|may_use|will_see|start_with|work_with|are_given|can_find|"
_SEE += "will_need|need|will_have|will_get|got|will_use|start_out_with|begin_with|use"
_ONLY = "only|just|exactly|also|now?"
_SCENE = (
    "the|our|this|your scene|inventory|set|kit|box|task|material|workspace|collection|setup|setting|stock|test|"
    "scenario|experiment|benchmark|environment"
)
_AHEAD = Patterns(
    f"there is|are {_ONLY} on_the_table? {_ONLY}",
    f"here is|are {_ONLY}",
    f"on {_TABLE} ,? there? {_LYING} {_ONLY}",
    f"on {_TABLE} ,? we|you|i|the_robot {_SEE}|has {_ONLY}",
    f"{_SCENE} contains|has|holds|consists_of|includes|offers|shows|is|comprises {_ONLY}",
    f"in {_SCENE} ,? there? {_LYING} {_ONLY}",
    f"in_front_of|before you|me|us|the_robot there? {_LYING} {_ONLY}",
    f"we|you|i {_SEE} here|today? {_ONLY}",
    "the robot has|is_given|gets",
    "we|i|you|somebody|someone have|has put|placed|laid|set|laid_out",
    "we|you|i are_working_with|work_with|are_going_to_use",
    "all|all_that there_is|we_have|you_have|lies on_the_table? is|are",
    "given is|are",
    "the following is|are on_the_table|given|there|available :",
    "the following blocks|things|objects|cubes is|are|lie on_the_table|given|there|available :",
    "available is|are",
    "take|use|start_with|begin_with|work_with",
    "the|our|my|all|all_the? blocks|cubes|bricks|boxes|inventory|stock|material|setup available|given|in_play|at_hand? "
    ":|are|is",
    "given|available|these|those :",
    "imagine|picture|suppose|assume|consider that? there_is|there_are?",
    "on_the_table :",
)
"""What stands in front of a list of what there is."""
_AROUND = Patterns(
    f"{_TABLE} has|holds|carries|contains {_ONLY}",
    f"there is {_TABLE} with {_ONLY}",
    "a|the|one table with",
)
"""The same of the table, with or without "on it" behind the list."""
_NOTHING_BUT = Patterns(
    "there is nothing on_the_table? except|but|besides|other_than",
    "on_the_table there? is nothing except|but|besides|other_than",
    "the table is empty except_for|apart_from|but_for|save_for",
    "nothing except|but|other_than",
)
_BEHIND = Patterns(
    f"all|both? {_LYING} loosely|scattered|together|around|only|just? on {_TABLE}",
    f"all|both? {_LYING} scattered|loosely? around? on {_TABLE}",
    f"is|are scattered|spread|spread_out|distributed over|across|on {_TABLE}",
    "is|are given|available|there|present|at_hand|provided|in_the_scene|at_your_disposal|supplied|to_be_used|used|"
    "in_play",
    f"on {_TABLE}",
    "here|at_hand|available|in_all|in_total|altogether|in_the_scene",
)
"""What stands behind it."""
_MORE_WITH = (("together", "with"), ("along", "with"), ("with",), (",", "and"), ("and",), (",", "together", "with"),
              ("next", "to"), ("beside",), ("around",), ("near",), ("as", "well", "as"))  # fmt: skip
_BESIDE = frozenset({"next", "beside", "around", "near"})
_NO_MORE = (("and", "nothing", "else"), (",", "and", "nothing", "else"), (",", "nothing", "else"), ("only",),
            ("and", "no", "others"), (",", "nothing", "more"), ("and", "nothing", "more"))  # fmt: skip
_SOME = (("some", "blocks"), ("a", "few", "blocks"), ("several", "blocks"), ("the", "following", "blocks"),
         ("some", "cubes"), ("several", "cubes"), ("a", "few", "cubes"))  # fmt: skip
_EXACT = frozenset({"only", "just", "exactly"})
_SET_OFF = frozenset({",", ":", "("})
_OF_WHICH = ((",", "of", "which"), ("of", "which"), (",", "of", "these"), (",", "of", "them"))
_TABLES = frozenset({"table", "tabletop"})
_TOO = ((",", "too"), ("too",), ("as", "well"))


def stock_of(tokens: Sequence[Token], bare: bool = False) -> Stock | None:
    """What a sentence says there is, if it says no more. `bare`: it may be a list that does not say so."""
    found = [*_readings(tokens, bare)]
    lots = with_their_patches(found[0].lots) if found else None
    if lots is None:
        return None
    return replace(found[0], lots=lots, closed=any(stock.closed for stock in found if stock.lots == found[0].lots))


def _readings(tokens: Sequence[Token], bare: bool) -> Iterator[Stock]:
    p = Parser([*tokens])
    words = [t.word for t in tokens]
    lying = not _TABLES.isdisjoint(words)
    closed = not _EXACT.isdisjoint(words[:6]) or "nothing" in words or "otherwise" in words
    for start in _NOTHING_BUT.matches(p, 0):
        for stock in _listed(p, tokens, start, tokens[0].word == "nothing"):
            yield Stock(stock.lots, True, lying)
    for start in _AROUND.matches(p, 0):
        on_it = len(tokens) - 2 - (words[-3:-2] == [","])
        for end in (len(tokens), on_it):
            if end == len(tokens) or (words[-2:] == ["on", "it"] and not _on_something(words[start:])):
                for stock in _listed(p, tokens[:end], start, False):
                    yield Stock(stock.lots, closed or stock.closed, True)
        yield from _on_it(tokens, start)
    for start in {0, *_AHEAD.matches(p, 0)}:
        for stock in _listed(p, tokens, start, not start and not bare):
            yield Stock(stock.lots, closed or stock.closed, lying, stock.beside)
    yield from _of_those_there(p, tokens, lying)


def _on_something(words: Sequence[str]) -> bool:
    """Whether "on it" may be said of a thing that is listed: "a blue mat with a red block on it"."""
    return any(word == "with" and before not in ("together", "along") for before, word in pairwise(words))


def _listed(p: Parser, tokens: Sequence[Token], start: int, framed: bool) -> Iterator[Stock]:
    """A list that begins there and all that follows it. `framed`: what follows has to say that these are there."""
    for lots, j in lots_at(tokens, start):
        if (named := with_nouns(lots)) is not None:
            yield from _closing(p, tokens, named, j, framed)
    many, noun, kind, j = total_at(tokens, start)
    yield from _of_some(tokens, start)
    if not many:
        return
    for after in {j, *(_behind(p, tokens, j))}:
        if after >= len(tokens):
            continue
        which = words_at(tokens, after, *_OF_WHICH)
        if not which and tokens[after].word not in _SET_OFF:
            continue
        close = ")" if tokens[after].word == "(" else ""
        begin = which or words_at(tokens, after + 1, ("namely",)) or after + 1
        own = labelled(tokens, begin, many, kind or "blocks") if many > 0 and not which else ()
        for lots, end in (*own, *(() if kind else apart(tokens, begin, many, noun))):
            if close and (end >= len(tokens) or tokens[end].word != close):
                continue
            for stock in _closing(p, tokens, lots, end + bool(close), framed and after == j):
                yield Stock(stock.lots, True, stock.lying, stock.beside)


def _of_some(tokens: Sequence[Token], start: int) -> Iterator[Stock]:
    """ "(there are) some blocks on the table: one red and two blue"."""
    some = words_at(tokens, start, *_SOME)
    some = words_at(tokens, some, ("on", "the", "table")) or some
    begin = words_at(tokens, some, (":",), (",",)) if some else 0
    for lots, end in lots_at(tokens, begin, True) if begin else ():
        if end >= len(tokens) and all(lot.color and not lot.labels and lot.noun is None for lot in lots):
            named = with_nouns(lots, tokens[some - 1].saying("blocks"))
            yield Stock(named or lots, True)


def _behind(p: Parser, tokens: Sequence[Token], j: int) -> list[int]:
    return [k for k in _BEHIND.matches(p, p.opt(j, ",")) if k <= len(tokens)]


def _closing(p: Parser, tokens: Sequence[Token], lots: Lots, j: int, framed: bool) -> Iterator[Stock]:
    """The list with what follows it: "... lie on the table together with a mat"."""
    ends = [*({} if framed else {j: None}), *_behind(p, tokens, j)]
    for end in ends:
        last = words_at(tokens, end, *_NO_MORE)
        last = last or words_at(tokens, end, *_TOO) or end
        if last >= len(tokens):
            yield Stock(lots, bool(words_at(tokens, end, *_NO_MORE)))
            continue
        joint = words_at(tokens, end, *_MORE_WITH)
        if joint and (end > j or tokens[end].word in ("with", "and", ",")):
            yield from _joined(tokens, lots, end, joint)


def _joined(tokens: Sequence[Token], lots: Lots, at: int, joint: int) -> Iterator[Stock]:
    beside = tokens[at].word in _BESIDE
    for more, end in lots_at(tokens, joint):
        named = with_nouns(more)
        if named is None or not any(lot.patch for lot in (*lots, *named)):
            continue
        around = words_at(tokens, end, ("around", "it"), ("next", "to", "it"), ("beside", "it"), ("near", "it"))
        if (around or end) < len(tokens) or (around and beside):
            continue
        near = beside or bool(around)
        if not near or (len(named) == 1 and named[0].patch) or (around and len(lots) == 1 and lots[0].patch):
            yield Stock((*lots, *named), beside=near)


def _on_it(tokens: Sequence[Token], start: int) -> Iterator[Stock]:
    """ "(the table has) five blocks on it: black, white, ..."."""
    many, noun, kind, j = total_at(tokens, start)
    after = words_at(tokens, j, ("on", "it", ":"), ("on", "it", ",")) if many else 0
    if not after:
        return
    begin = words_at(tokens, after, ("namely",)) or after
    own = labelled(tokens, begin, many, kind or "blocks")
    for lots, end in (*own, *(() if kind else apart(tokens, begin, many, noun))):
        if end >= len(tokens):
            yield Stock(lots, True, True)


def _of_those_there(p: Parser, tokens: Sequence[Token], lying: bool) -> Iterator[Stock]:
    """ "of the five blocks on the table, three are red and two are blue"."""
    of = p.any_of(0, _OF_THE)
    many, noun, kind, j = total_at(tokens, of) if of else (0, None, "", 0)
    if not many or kind:
        return
    end = next(iter(_behind(p, tokens, j)), j)
    for lots, last in apart(tokens, words_at(tokens, end, (",",)) or end, many, noun):
        if last >= len(tokens):
            yield Stock(lots, True, lying)


_OF_THE = ("of the", "of these", "of my", "of our")


def counted(tokens: Sequence[Token], bare: bool = False) -> tuple[int, Token | None, bool] | None:
    """How many blocks a sentence says there are, if it says no more: "five blocks are on the table"."""
    p = Parser([*tokens])
    for start in {0, *_AHEAD.matches(p, 0)}:
        many, noun, kind, j = total_at(tokens, start)
        if not many or kind or noun is None or noun.word not in lexicon.BLOCK:
            continue
        if (j >= len(tokens) and (start or bare)) or any(k >= len(tokens) for k in _behind(p, tokens, j)):
            return many, noun, not _TABLES.isdisjoint(t.word for t in tokens)
    return None


def looks_of(tokens: Sequence[Token], many: int, noun: Token | None) -> Lots | None:
    """How so many blocks of the sentence before look: "three of them are green, the other two are purple"."""
    rest = [*tokens]
    if len(rest) > 1 and [t.word for t in rest[-4:-1]] == ["the", "others", "are"]:
        told = next((lots for lots, end in lots_at(tokens, 0, bare=True) if end >= len(tokens) - 5), ())
        left = many - sum(lot.size for lot in told)
        if told and left > 0:
            number = rest[-4].saying(str(left))
            number = Token("number", str(left), str(left), number.span, float(left))
            rest = [*rest[:-4], number, *rest[-2:]]
    return next((lots for lots, end in apart(rest, 0, many, noun) if end >= len(rest)), None)


__all__ = ["Stock", "count_at", "counted", "looks_of", "stock_of"]
