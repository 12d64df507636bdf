"""How many blocks a line has, and which of them are left out, in the words that tell it and in the task."""

from __future__ import annotations

import re
from collections import Counter

from rpg.ir.node import members
from rpg.ir.schema import COLORS_UNSAID
from rpg.ir.structures import Cells, Row, Spells, Stack
from rpg.ir.walk import names
from rpg.language import lexicon
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST
from rpg.passes.schema.line_said import Said, asked
from rpg.passes.schema.numbers_had import symbols_of

_TOTAL = re.compile(
    f"(?<!there is )(?<!there are )\\b(?P<many>{MANY})(?: blocks| cubes)? (?:in total|in all|altogether|overall)\\b"
)
_EACH = frozenset({"each", "every", "per", "distractor", "distractors", "both", "available"})
_MAKES = re.compile(f"\\b(?:{'|'.join(sorted(lexicon.STRUCTURE))})\\b")


def _number(word: str) -> int:
    return int(word) if word.isdigit() else lexicon.NUMBER[word]


def in_total(said: Said) -> None:
    """Refuse "a row of two red, three blue, six blocks in total" as of five blocks."""
    match = _TOTAL.search(said.text)
    if match is None or not _EACH.isdisjoint(said.text.split()) or not _MAKES.search(said.text):
        return
    many = _number(match["many"])
    used = len({*names(said.task.goal)} & {block.name for block in said.task.blocks})
    if used < many or (said.alone and used > many):
        raise said.refusal(match, "count-mismatch", f"there are to be {many} blocks in all, but {used} are told of",
                           f"say {used}, or tell of them all")  # fmt: skip


_AS_LONG = re.compile(f"\\b{LINE} of [^,]*(?: ,)? as (?:long|tall|high) as (?:an?|the|another|one) {LINE}\\b")


def as_long(said: Said) -> None:
    """Refuse "a row of four red blocks as long as a row of three blue ones"."""
    match = _AS_LONG.search(said.text)
    if match is not None and len({len(line.blocks) for line in said.lines}) > 1:
        raise said.refusal(match, "count-mismatch", "these are not of the same length",
                           "say how many blocks each of them has")  # fmt: skip


_NUMBERED = re.compile(
    rf"\b(?:blocks?|cubes?|bricks?|digits?|numbers?) (?P<listed>\d(?: , \d)*(?: ,)? (?:and )?\d) (?P<color>{COLOR})\b"
    r"(?! (?:block|cube|brick|one)s?\b)"
)


def numbered(said: Said) -> None:
    """Refuse "blocks 1 and 3 red, 2 and 4 blue" as of three red blocks."""
    for match in _NUMBERED.finditer(said.text):
        color = lexicon.COLOR[match["color"]]
        if not all(said.shows(label, color) for label in match["listed"].split() if label.isdigit()):
            raise said.refusal(match, "ambiguous", "do these numbers count blocks, or are they what the blocks show?",
                               "say 'the blocks ... are', or '3 red blocks'")  # fmt: skip


_COUNTED = re.compile(rf"\b{LINE} of (?P<many>\d)(?= ,|$| with\b| where\b| in which\b| :)(?!.*\b\d)")


def counted(said: Said) -> None:
    """Refuse "a row of 3, two red" as of a block that shows a 3, and two red ones."""
    match = _COUNTED.search(said.text)
    if match is not None and said.shows(match["many"]):
        raise said.refusal(match, "ambiguous", "so many blocks, or what a block shows?",
                           f"say '{match['many']} blocks', or 'the block {match['many']}'")  # fmt: skip


_AND_COUNTED = re.compile(
    f"\\b(?:of|from|with) (?P<listed>{COLOR}(?: , {COLOR})*(?: ,)? and {COLOR})(?: blocks| cubes)? , "
    f"(?P<many>{MANY}) (?P<color>{COLOR})\\b"
)


def and_counted(said: Said) -> None:
    """Refuse "a row of red and blue, three red" as of a red one, a blue one and three red ones."""
    match = _AND_COUNTED.search(said.text)
    if match is None or match["color"] not in match["listed"].split() or not said.lines:
        return
    color, many = lexicon.COLOR[match["color"]], _number(match["many"])
    if not any(sum(block.color == color for block in said.blocks(line)) == many for line in said.lines):
        raise said.refusal(match, "ambiguous", "so many of those that are listed, or so many more?",
                           "say how many blocks there are of each color")  # fmt: skip


_OF_EACH = re.compile(f"\\b(?P<many>{MANY})(?: blocks| cubes| ones)? (?:of|in|from) (?:each|every)(?: colors?)?\\b")
_PER_COLOR = re.compile(f"\\b(?P<many>{MANY})(?: blocks| cubes| ones)? per color\\b")


def of_each(said: Said) -> None:
    """Refuse "line up six blocks, two of each color" as six blocks of six colours."""
    match = _OF_EACH.search(said.text) or _PER_COLOR.search(said.text)
    if match is None or not said.lines or not said.task.assumed(COLORS_UNSAID):
        return
    looks = (lambda block: block.color, lambda block: block.size)  # "small and large cubes, two of each"
    counts = [{*Counter(map(look, said.blocks(line))).values()} for line in said.lines for look in looks]
    if {_number(match["many"])} not in counts:
        raise said.refusal(match, "ambiguous", "it is not said which colors these are",
                           "name them: 'two red, two blue and two green blocks'")  # fmt: skip


_OF_WHICH = re.compile(
    f"\\b(?:{LINE}|wall|grid|pyramid|circle|square) of (?P<many>{MANY})(?: blocks| cubes)? , "
    f"(?P<but>all but )?{MANY} of (?:which|them)\\b"
)


def of_which(said: Said) -> None:
    """Refuse "a tower of three blocks, two of which are red" as of two blocks, with another beside it; and "all but one
    of them red" as of two, with none of another colour in it."""
    match = _OF_WHICH.search(said.text)
    used = {*names(said.task.goal)} & {block.name for block in said.task.blocks}
    unsaid = match is not None and match["but"] and said.task.assumed(COLORS_UNSAID)
    if match is not None and (unsaid or len(used) < _number(match["many"])):
        raise said.refusal(match, "ambiguous", "it is not said how the other blocks of this look",
                           "say how many blocks of which colour it has")  # fmt: skip


_NTH = "(?:first|second|third|fourth|fifth|last|middle|leftmost|rightmost|top|bottom|lowest|highest|uppermost)"
_ALL = (
    "(?:all|every|everything|each)(?: of)?"
    "(?: them| (?:the )?(?:blocks|cubes|letters|digits)| one| block| cube| letter| digit)?"
)
_BUT = "(?: ,)? (?:but|except|except for|save|save for|apart from|other than|bar)(?: the)?"
_IS = f"(?:(?:is|are|being|{MUST} be)(?: in)?|in)"
_PLACES = f"{_NTH}(?: (?:left|right))?(?: (?P<many>{MANY}))?"
_HAVE = f"(?: ones?| blocks?| cubes?| letters?| digits?)?(?: ,)?(?: {_IS})?"
_EXCEPT = (
    re.compile(f"\\b{_ALL}{_BUT} {_PLACES}{_HAVE} (?P<color>{COLOR})\\b"),
    re.compile(f"\\b{_ALL}(?: {_IS})? (?P<color>{COLOR})(?: ones| blocks| cubes)?{_BUT} {_PLACES}\\b"),
)
"""All of a line but some of its places: what colour they have."""


def all_but(said: Said) -> None:
    """Refuse "a row of five, all but the last one (in) red" as with the last one red, or with all of them red."""
    for match in (found for pattern in _EXCEPT if (found := pattern.search(said.text)) is not None):
        color, many = lexicon.COLOR[match["color"]], _number(match["many"] or "one")
        wholes = [{*members(x.blocks)} for x in asked(said.task.goal) if isinstance(x, Row | Stack | Cells | Spells)]
        others = [sum(x.name in whole and x.color != color for x in said.task.blocks) for whole in wholes]
        if others and many not in others and not said.begun:
            raise said.refusal(match, "ambiguous", "it is not clear what this leaves out, and how that looks",
                               "say how each block looks, as in 'four red blocks and then a blue one'")  # fmt: skip


_KIND = "(?:the |all |all the |all of the )?(letters|digits|numbers)"
_COME = f"(?: (?:{MUST} )?(?:come|go|stand|be|are))?"
_IN_TURN = re.compile(f"\\b{_KIND}{_COME} (before|after) {_KIND}\\b")


def kinds_in_turn(said: Said) -> None:
    """Refuse "a row of A, B, 1 and 2. The digits come before the letters" as of a row in the order of the list."""
    match = _IN_TURN.search(said.text)
    if match is None or said.begun or match[1] == match[3]:
        return
    first = match[1 if match[2] == "before" else 3] == "letters"
    letters = {block.name for block in said.task.blocks if "".join(symbols_of(block)).isalpha()}
    for order in (line.order for line in said.lines if line.order.by == "given"):
        kinds = [name in letters for rank in order.ranks for name in rank]
        if kinds != sorted(kinds, reverse=first):
            raise said.refusal(match, "contradiction", "this is not the order in which they are listed",
                               "say 'the digits first' where the row is told")  # fmt: skip
