"""Blocks singled out among those that are listed: "the two that share a color", "the letter that comes first in the
alphabet", "the one that is neither red nor blue". They are named by what they look like."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.turned import Turns, all_of_it, turned
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, PATCH, PATCHES, number
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.language.told_by_others import told_by_others

_IS = "(that|which) (is|are)"
_NOR = Turns([
    (f"\\bthose(?: of them)? {_IS} (?=(?:neither|not) {COLOR})", "the ones {1} {2} "),
    (f"\\b{_IS} (?:neither|not) ({COLOR})(?: ,| nor| or) ({COLOR})(?: nor| or| , or| , nor) ({COLOR})\\b",
     "{1} {2} not {3} and not {4} and not {5}"),
    (f"\\b{_IS} (?:neither|not) ({COLOR}) (?:nor|or) ({COLOR})\\b", "{1} {2} not {3} and not {4}"),
])  # fmt: skip
_ONES = "(?:blocks|cubes|ones|pieces)"
_ALIKE = on_demand(
    f"\\b(?:the|both)(?: (?P<many>{MANY}))?(?:(?: {_ONES})?"
    "(?: (?:that|which|who) (?:share|have|are of|are in)| of| with|(?: both)? having| sharing)(?: both)? "
    "(?:an? (?:common |single )?|the (?:very )?same |one (?:and the same )?|equal |an identical )color"
    f"|(?: {_ONES})? (?:that|which) (?:are alike|look alike|look the same|are the same color|are identical)"
    f"| (?:identical|like colored|same colored) {_ONES})(?! as\\b)"
)
_LOT = on_demand(f"\\b(?P<many>an?|{MANY}) (?P<color>{COLOR})\\b(?! (?:{PATCH}|{PATCHES})\\b)")


def singled_out(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with such blocks by their names."""
    words = {token.word for token in tokens}
    if not words.isdisjoint(("neither", "or", "those")):
        tokens = turned(tokens, _NOR)
    if not words.isdisjoint(("share", "sharing", "same", "alike", "identical", "equal", "common")):
        tokens = _alike(tokens)
    if not words.isdisjoint(("alphabet", "alphabetically")):
        tokens = _by_alphabet(tokens)
    return told_by_others(tokens), []


def _alike(tokens: list[Token]) -> list[Token]:
    """The tokens with the one color of which there are so many in the place of what is shared."""
    text = text_of(tokens)
    found = _ALIKE.search(text)
    counts: Counter[str] = Counter()
    for lot in _LOT.finditer(text):
        counts[lexicon.COLOR[lot["color"]]] += 1 if lot["many"] in ("a", "an") else number(lot["many"])
    several = [color for color, count in counts.items() if count > 1]
    if found is None or len(several) != 1 or len(counts) == 1:
        return tokens
    many = counts[several[0]]
    if number(found["many"]) != many if found["many"] else re.search(f"\\b(?:{PATCH}|{PATCHES})\\b", text):
        return tokens  # "the blocks of the same color on the red mat" may be of the color of the mat
    row = f"(?<![^ ]){re.escape(found.group())}(?![^ ])"
    return turned(tokens, Turns([(row, f"the {many} {several[0]} blocks")]), all_of_it)


_ONE = "(?:letter|one|block|cube|character)"
_COMES = "(?:that|which) (?:comes|is|stands|appears|goes)"
_ENDS = on_demand(
    f"\\bthe {_ONE} {_COMES} (?P<a>first|earliest|last|latest) (?:in|by) (?:the )?(?:alphabet|alphabetical order)\\b|"
    f"\\bthe alphabetically (?P<b>first|earliest|last|latest) {_ONE}\\b|"
    f"\\bthe {_ONE} {_COMES} alphabetically (?P<c>first|last)\\b|"
    f"\\bthe {_ONE} {_COMES} (?P<d>first|last) alphabetically\\b"
)
_OTHER_END = on_demand(
    f"\\bthe (?:{_ONE} {_COMES} (?P<a>first|earliest|last|latest)|(?P<b>first|last)(?: one)?(?= [.?!]|$))"
)
_LISTED = frozenset({",", "and", "&"})
_STOCK = Turns(
    [("^(?:the )?letters(?: are| :)? ((?:[a-z](?: , and | , | and | & |$))+)$", "there are the letters {1}")]
)
"""What there is to single out from: of the rest nothing need be said."""


def _by_alphabet(tokens: list[Token]) -> list[Token]:
    """The tokens with the first and the last of the letters that are listed as such."""
    letters = sorted(_letters(tokens), key=lambda token: token.word)
    if len(letters) < 2 or not _ENDS.search(text_of(tokens)):
        return tokens
    ends = {"first": letters[0], "earliest": letters[0], "last": letters[-1], "latest": letters[-1]}
    tokens = turned(tokens, _STOCK)
    told = _ENDS.search(text_of(tokens))
    while told is not None:
        text = text_of(tokens)
        begin, end = text[: told.start()].count(" "), text[: told.end()].count(" ") + 1
        named = ends[next(filter(None, told.groups()))]
        tokens = [*tokens[:begin], tokens[begin].saying("the"), tokens[begin].saying("letter"), named, *tokens[end:]]
        text = text_of(tokens)
        told = _ENDS.search(text) or _OTHER_END.search(text)
    return tokens


def _letters(tokens: Sequence[Token]) -> list[Token]:
    """The letters that stand in lists."""
    found = []
    for n, token in enumerate(tokens):
        beside = {other.word for other in (*tokens[max(n - 1, 0) : n], *tokens[n + 1 : n + 2])}
        if len(token.raw) == 1 and token.raw.isupper() and not beside.isdisjoint(_LISTED):
            found.append(token)
    return found
