"""What there is, told beside what is asked for or behind it: in front, in a sentence of its own.

"Five black cubes: two on the red mat", "make two towers (six blocks)", "with three red blocks, one of them ...".
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Literal

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences, text_of
from rpg.language.grammar.rows.vocabulary import MANY
from rpg.language.grammar.talk.exactly_so_many import so_many_at
from rpg.language.inventories.colors_behind import colors_behind
from rpg.language.inventories.frames import Stock, counted, stock_of
from rpg.language.inventories.lots import Lot, lots_at, several_at, with_nouns
from rpg.language.inventories.patches_behind import patches_behind
from rpg.language.inventories.plain import STOPS, bare, in_words, lots_in_words
from rpg.language.tokens import Token

_LEADS = frozenset({"with", "given", "using", "from", "out", "having", "of", "among", "for"})
_SHORTEST = 2
"""So many words a stock and what is asked have at least."""
_FEW = 6
"""Among so many words it is told how many of those that are there are meant: "no more than two of which"."""


Wanted = Literal["", "look", "block"]


def stocks_ahead(tokens: list[Token]) -> Iterator[tuple[list[Token], Wanted]]:
    """Ways in which the words tell what there is, each with that in front, and what has to be wanted for something
    where nothing but the list says that it is there: each look of it, or each block."""
    parts = sentences(tokens, STOPS)
    for n, part in enumerate(parts):
        rest = [token for other in (*parts[:n], *parts[n + 1 :]) for token in other]
        pointed = n > 0 and any(map(_of_these, parts[n + 1 : n + 2]))
        if len(parts) > 1 and not pointed and (stock := _told(part)) is not None:
            yield [*in_words(stock, part), *rest], "look" if stock_of(bare(part)) is None else ""
        if (idle := _idle(part)) is not None:
            yield [*idle, *rest], ""
        if (colors := colors_behind(part, rest)) is not None:
            yield [*colors, *rest], ""
        if (each := _so_many_of_each(part, rest)) is not None:
            yield [*each, *rest], ""
        for stock, asked, wanted in _apart(part):
            if n and _of_these(asked):
                continue
            yield [*in_words(stock, part), *(t for p in (*parts[:n], asked, *parts[n + 1 :]) for t in p)], wanted
    yield from ((named, "") for named in _one_by_one(tokens))
    if (patches := patches_behind(tokens)) is not None:
        yield [*patches, *tokens], ""


def _of_these(told: list[Token]) -> bool:
    """ "(No red block is on the mat. There are two blue blocks.) They must be in a row.": what stands behind a stock
    speaks of it, and would speak of others with the stock in front of all."""
    for token, after in pairwise(told):
        if token.word in _POINTED or (token.word in ("all", "both", "each") and after.word not in _TAKING):
            return True
        if any(token.word in table for table in _NAMED):
            return False
    return False


def _so_many_of_each(part: list[Token], rest: list[Token]) -> list[Token] | None:
    """ "(No red block may touch a blue block.) Three of each.": three red and three blue ones, if of such is told."""
    match = _OF_EACH.match(text_of(part))
    colored = [(a.word, b.word) for a, b in pairwise(rest) if match and a.word in lexicon.COLOR]
    looks = dict.fromkeys(color for color, noun in colored if noun in _BLOCKS)
    if match is None or len(looks) < 2 or any(noun not in _BLOCKS | {*lexicon.PATCH} for _, noun in colored):
        return None
    if not _THEM.isdisjoint(token.word for token in rest):
        return None  # whom that means depends on where it is told how many there are
    listed = " and ".join(f"{match[1]} {look} blocks" for look in looks)
    return [part[0].saying(word) for word in f"there are {listed} .".split()]


_THEM = frozenset({"they", "them", "these", "those", "it", "all", "everything", "both"})
_POINTED = frozenset({"they", "them", "these", "those", "it"})
_TAKING = frozenset({"of", "the", "my", *lexicon.NUMBER, *lexicon.COLOR, *lexicon.BLOCK})
"""With one of these behind it "all" is said of what is named, or "of them" tells of whom."""
_NAMED = (lexicon.COLOR, lexicon.BLOCK, lexicon.PATCH, lexicon.STRUCTURE, lexicon.COLOR_PLURAL)
_BLOCKS = frozenset({*lexicon.BLOCK, "one", "ones"})
_OF_EACH = re.compile(
    f"^(?:there are |we have |i have |use )?({MANY}) (?:blocks |cubes )?of (?:each|every|both)(?: color| kind)?"
    "(?: [.;!])?$"
)


def _idle(part: list[Token]) -> list[Token] | None:
    """ "Two pink cubes may lie anywhere": blocks of which nothing is asked, so that they are distractors."""
    words = bare(part)
    told = [t.word for t in words]
    for lots, end in lots_at(words, 0):
        if end + 2 < len(told) and told[end] in _MAY and told[end + 1] in _LIE and told[end + 2 :] == ["anywhere"]:
            named = with_nouns(lots)
            if named is not None and not any(lot.patch for lot in named):
                many = len(named) > 1 or named[0].size > 1
                said = ("are", "distractors") if many else ("is", "a", "distractor")
                return [*lots_in_words(named), *(part[-1].saying(word) for word in (*said, "."))]
    return None


_MAY = frozenset({"may", "can", "might", "could"})
_LIE = frozenset({"be", "lie", "stand", "stay", "sit", "go", "remain"})


def _one_by_one(tokens: list[Token]) -> Iterator[list[Token]]:
    """ "Sort six blocks, three red and three blue, by colour": with the blocks of each look named where they stand."""
    for n in range(len(tokens)):
        for lots, end in several_at(tokens, n):
            named = [*tokens[:n], *lots_in_words(lots)]
            if any(token.word in lexicon.COLOR for token in (*tokens[:n], *tokens[end:])):
                return  # "... One pink block starts there": one of these, or a further one?
            yield [*named, *tokens[end:]]
            if end < len(tokens) and tokens[end].word == ",":
                yield [*named, *tokens[end + 1 :]]
            return


def _told(part: list[Token]) -> Stock | None:
    """What these words tell to be there, if they tell no more."""
    words = bare(part)
    if len(words) < _SHORTEST:
        return None
    if (stock := stock_of(words, True)) is not None:
        return stock
    if (number := counted(words, True)) is None or number[1] is None:
        return None
    return Stock((Lot(many=number[0], noun=number[1]),), True, number[2])


def _apart(part: list[Token]) -> Iterator[tuple[Stock, list[Token], Wanted]]:
    """A stock that a sentence tells beside what it asks, what that is, and what of the stock has to be wanted."""
    words = bare(part)
    stop = part[len(words) :]
    lead = 2 if [t.word for t in words[:2]] == ["out", "of"] else int(words[0].word in _LEADS) if words else 0
    for n in range(len(words) - _SHORTEST, _SHORTEST - 1, -1):
        if words[n].kind != "punct" or words[n].word not in (",", ":", "("):
            continue
        before, after = words[:n], words[n + 1 :]
        if words[n].word != "(" and (stock := _told(before[lead:] if lead else before)) is not None:
            asked = _asked(after)
            if "which" in (t.word for t in after) and stock_of(before) is not None and not _must(after):
                continue  # "there are three mats, each of which has a block on it": now or in the end?
            if lead or words[n].word == ":" or asked != after:
                yield stock, [*asked, *stop], "look"
        closed = after[:-1] if words[n].word == "(" and after[-1].word == ")" else after
        idle = any(token.word in ("distractor", "distractors") for token in before)
        if not idle and (words[n].word == ":" or len(closed) < len(after)) and (stock := _told(closed)) is not None:
            colon: Wanted = "block" if words[n].word == ":" else "look"
            yield stock, [*before, *(stop or [replace(words[n], word=".", raw=".")])], colon


def _must(tokens: list[Token]) -> bool:
    return any(token.word in ("must", "should", "shall", "may", "can") for token in tokens)


def _asked(after: list[Token]) -> list[Token]:
    """ "and at least one of them ...", "of which one ...", "no two of which ...": what is asked, as a sentence."""
    words = [token.word for token in after]
    if words[:1] == ["and"]:
        return after[1:]
    if words[:2] in (["of", "which"], ["of", "these"], ["of", "them"]) and len(words) > 3:
        begun = 2 + (words[2] == ",")
        many = so_many_at(after, words, begun) or begun + bool(after[begun].many)
        them = [after[0], after[1].saying("them")]
        return [*after[begun:many], *them, *after[many:]] if many > begun else [after[0], after[1].saying("these"),
                after[0].saying(","), *after[begun:]]  # fmt: skip
    of = next((n for n in range(1, min(_FEW, len(words))) if words[n - 1 : n + 1] == ["of", "which"]), 0)
    return [*after[:of], after[of].saying("them"), *after[of + 1 :]] if of else after
