"""Blocks of so many colors or sizes: "cubes of two sizes, a red one with a 5 cm edge and a green one with a 3 cm edge",
"ten blocks in five colors, two of each"."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.turned import Turns, all_of_it, turned
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, PATCH, number
from rpg.language.open_colors import CHOSEN
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_NOUN = "(?:blocks|cubes|bricks|boxes)"
_KINDS = f"(?:of|in|with|having) (?:(?P<kinds>{MANY})(?: different)?|different) (?P<what>sizes|colors)"
_SIZE = f"(?:{'|'.join(sorted(lexicon.SIZE))})"
_EDGE = (
    "(?: (?:with|having) an? [\\d.]+ cm (?:edge|side)| (?:with|having) (?:an? )?(?:edge|side)s?(?: lengths?)? of "
    "[\\d.]+ cm| of [\\d.]+ cm)"
)
_LOT = f"(?:an?|one|{MANY}) (?:(?:{_SIZE}|{COLOR}) )*(?:{_SIZE}|{COLOR})\\b(?: (?:ones?|blocks?|cubes?))?{_EDGE}?"
_END = "(?= [.;:!,]|$| and\\b)"
_LISTED = on_demand(
    f"\\b(?:(?P<total>{MANY}) )?{_NOUN} {_KINDS} ?[,:] (?P<list>{_LOT}(?:(?: ,| and| , and) {_LOT})*){_END}"
)
_OF_EACH = (
    on_demand(
        f"\\b(?:(?P<total>{MANY}) )?(?P<noun>{_NOUN}) {_KINDS}(?: ,)?(?: and| with)? (?P<each>{MANY})(?: {_NOUN})? "
        f"(?:of|in|per|for) (?:each|every)(?: color| one| of (?:them|these))?{_END}"
    ),
    on_demand(
        f"\\b(?P<each>{MANY}) (?P<noun>{_NOUN}) (?:of|in) (?:each|every) of (?P<kinds>{MANY})(?: different)? "
        f"(?P<what>colors){_END}"
    ),
)
_HUED = on_demand(f"\\b{COLOR}\\b(?! {PATCH}\\b)")
_ONE = frozenset({"one", "ones", *lexicon.BLOCK})


def with_kinds(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with the blocks of each color or size, where it is said how many of these there are: those that are
    listed, or so many of each of the colors that are chosen here."""
    words = {token.word for token in tokens}
    if words.isdisjoint(("colors", "sizes")):
        return tokens, []
    text = text_of(tokens)
    if (listed := _LISTED.search(text)) is not None and _as_counted(listed.groupdict()):
        return _without_kinds(tokens, *(text[: listed.start(part)].count(" ") for part in (0, "list"))), []
    of_each = next((found for pattern in _OF_EACH if (found := pattern.search(text)) is not None), None)
    hues = _hues(of_each.groupdict(), text) if of_each is not None else []
    if of_each is None or not hues:
        return tokens, []
    told = " and ".join(f"{of_each['each']} {hue} {of_each['noun']}" for hue in hues)
    turn = (f"(?<![^ ]){re.escape(of_each.group())}(?![^ ])", told)
    return turned(tokens, Turns([turn]), all_of_it), [f"the colours are left open: {' and '.join(hues)}"]


def _as_counted(told: dict[str, str]) -> bool:
    """Whether a list has as many kinds, and as many blocks, as are counted."""
    lots = re.findall(_LOT, told["list"])
    kind = COLOR if told["what"] == "colors" else "[\\d.]+ cm" if " cm " in told["list"] else _SIZE
    kinds = re.findall(f"\\b{kind}\\b", told["list"])
    many = _number(told["kinds"]) if told["kinds"] else len(kinds)
    there = sum(_number(lot.split()[0]) for lot in lots)
    return len({*kinds}) == many and _number(told["total"] or str(there)) == there


def _without_kinds(tokens: list[Token], begin: int, first: int) -> list[Token]:
    """The list that begins at `first`, in the place of what it is a list of; its first lot has the noun."""
    noun = next(token for token in tokens[begin:first] if token.word in lexicon.BLOCK)
    at = first + 1
    while tokens[at].word in lexicon.SIZE or tokens[at].word in lexicon.COLOR:
        at += 1
    single = tokens[first].word in ("a", "an") or tokens[first].many == 1
    named = noun.saying("block" if single else "blocks")
    behind = at + (at < len(tokens) and tokens[at].word in _ONE)
    return [*tokens[:begin], *tokens[first:at], named, *tokens[behind:]]


def _hues(told: dict[str, str], text: str) -> list[str]:
    """The colors that are chosen, if none is named but of patches, and the numbers fit."""
    many, each = _number(told["kinds"] or "0"), _number(told["each"])
    free = [hue for hue in CHOSEN if hue not in {lexicon.COLOR.get(word) for word in text.split()}]
    fits = told["what"] == "colors" and not _HUED.search(text) and 1 < many <= len(free)
    return free[:many] if fits and _number(told.get("total") or str(many * each)) == many * each else []


def _number(word: str) -> int:
    return 1 if word in ("a", "an") else number(word)
