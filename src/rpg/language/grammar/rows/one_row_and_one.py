"""Two rows that are announced and then told one by one: "two rows of four: the letters W to Z, and a row of plain
cubes in front of them", told as a row, and another where it is."""

from __future__ import annotations

import re

from rpg.language.grammar.rows.parting import STOPS, sentences, text_of
from rpg.language.grammar.rows.vocabulary import BUILD, COLOR, CUBE, MANY, MUST
from rpg.language.lexicon import NUMBER
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_IT = "(?:it|that|this|them|those|these|(?:that|the first) (?:one|row))"
_WHERE = "(?P<where>in front of|behind)"
_TWO = on_demand(
    f"(?:{BUILD} )?(?:two|2) rows(?: of (?P<many>{MANY})(?: {CUBE}s)?)?(?: each)?(?: ,)? [:,] (?P<rest>.+)"
)
_JOINT = "(?: ,| ;| and)+"
_OTHER = "(?:an?|one|another|the (?:other|second))"
_BE = f"(?: (?:there )?(?:is|are|lies?|comes?|{MUST} be))?"
_TOLD = (
    on_demand(f"(?P<first>.+?)(?: ,| ;)?(?: and)?(?: ,)? {_WHERE} {_IT}(?: ,)?{_BE} (?P<second>.+)"),
    on_demand(f"(?P<first>.+?){_JOINT} (?P<second>{_OTHER} (?:row )?.+?){_BE} {_WHERE} {_IT}"),
    on_demand(f"(?P<first>(?:an?|one) row of .+?){_JOINT} (?P<second>{_OTHER} row of .+?)(?P<where>)"),
)
_ROW = on_demand(f"(?:{_OTHER}|the first) (?:row|one)(?: (?:of|with)| :)? ")
_BARE = on_demand(f"(?:(?:all|only|plain|{COLOR}) )*(?:blocks|cubes|ones)")
_EACH = on_demand(
    f"((?:an? )?{COLOR}(?:(?: ,| and)+ (?:an? )?{COLOR})+)(?: (?:blocks|cubes|ones|one|block|cube))?(?P<way>.*)"
)
_COUNTED = on_demand(f"(?P<many>{MANY}) (?:[a-z]+ )*(?:blocks|cubes|ones)")
_SYMBOLS = on_demand(
    "(?:the )?(?:(?:letters?|digits?|numbers?|blocks|cubes) )*((?:(?:\\w|,|and|to) )*\\w)\\b(?P<way>.*)"
)


def one_row_and_one(tokens: list[Token]) -> list[Token]:
    """The tokens, with each of two such rows told for itself."""
    if "rows" not in (token.word for token in tokens):
        return tokens
    return [token for sentence in sentences(tokens) for token in _told(sentence) or sentence]


def _told(sentence: list[Token]) -> list[Token]:
    """One and the other row, of as many blocks as were announced; nothing where this is not clear."""
    end = len(sentence) - (sentence[-1].word in STOPS)
    text = text_of(sentence[:end])
    two = _TWO.fullmatch(text)
    parts = next((m for told in _TOLD if two and (m := told.fullmatch(two["rest"]))), None)
    if two is None or parts is None:
        return []
    begin = two.start("rest")
    rows = [_row(sentence, text, begin + parts.start(name), parts[name], two["many"]) for name in ("first", "second")]
    if not all(rows):
        return []
    say = sentence[0].saying
    where = [*map(say, parts["where"].split()), say("it")] if parts["where"] else []
    return [*rows[0], say(","), say("and"), *rows[1], *where, *sentence[end:]]


def _row(sentence: list[Token], text: str, at: int, told: str, many: str | None) -> list[Token]:
    """A row of what is told there, from this character on; with its number where that is not told."""
    lead = _ROW.match(told)
    skipped = lead.end() if lead else 0
    blocks, begin = told[skipped:], text[: at + skipped].count(" ")
    found = sentence[begin : begin + blocks.count(" ") + 1]
    say = sentence[0].saying
    size = _many(many) if many else 0
    counted = _COUNTED.fullmatch(blocks)
    listed = _EACH.fullmatch(blocks) or _SYMBOLS.fullmatch(blocks)
    length = _length(re.findall(COLOR, blocks) or listed[1].split()) if listed else 0
    if _BARE.fullmatch(blocks):
        found = [say(many), *found] if many else []
    elif counted:
        found = found if size in (0, _many(counted["many"])) else []
    elif listed is None or not _way(listed["way"]) or size not in (0, length):
        found = []
    return [*map(say, ("a", "row", "of")), *found] if found else []


_SORTED = (
    "in (?:this|that) order|in (?:alphabetical|ascending|descending) order|from (?:left|right) to (?:left|right)| |,"
)


def _way(told: str) -> bool:
    """Whether all that is said besides is in which order they are."""
    return re.fullmatch(f"(?:{_SORTED})*", told) is not None


def _length(listed: list[str]) -> int:
    """How many symbols or colours a list or a range has."""
    symbols = [word for word in listed if word not in (",", "and", "to")]
    if "to" in listed:
        return abs(ord(symbols[0]) - ord(symbols[-1])) + 1 if len(symbols) == 2 else 0
    return len(symbols)


def _many(told: str) -> int:
    return int(told) if told.isdigit() else NUMBER.get(told, 0)
