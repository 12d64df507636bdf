"""Symbols and lists of them: A; 5; "A, B and C"; "A to E"; 1 through 9; words such as CAT."""

from __future__ import annotations

import string
from collections.abc import Mapping
from typing import Any

from rpg.blocks.traits import symbols_of
from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule

_AND = frozenset({"and", "&", "plus"})
_SIGN_WORDS = {"plus": "+", "minus": "-", "times": "*", "equals": "=", "equal": "=", "divide": "/", "divided": "/"}
_GOES_ON = frozenset({",", "and", "&", "equals", "minus", "times", "="})
"""What a list goes on with behind "plus", where that is a sign of its own."""
_CUBES = frozenset({"block", "cube", "brick", "box", "sign", "symbol", "signs", "symbols"})
_TO = frozenset({"to", "through", "thru", "until", "till"})
_TOWARD = ("to", "through", "thru", "until", "till", "up to", "down to")


def symbol(p: Parser, i: int, spoken: bool = False) -> str | None:
    """The symbol at i. `spoken`: after "letter" or "number", where "a" is a letter and "two" a digit."""
    token = p.token(i)
    if token is None or (token.raw == "I" and p.follows(i, _WHEN) and p.stands(i + 1, _GO)):
        return None
    found: str | None = None
    if token.kind in ("quote", "literal") and isinstance(token.value, str) and len(token.value) == 1:
        found = token.value.upper()
    elif token.kind == "word" and len(token.raw) == 1 and token.raw.isalpha():
        if token.raw.isupper() or spoken or token.word not in _WORDS or _among_letters(p, i) or _in_letters(p, i):
            found = token.raw.upper()
    elif (token.kind == "number" and token.word in string.digits) or token.kind == "sign":
        found = token.word
    elif (sign := p.lex(i, _SIGN_WORDS)) is not None:
        found = sign
    elif spoken:
        number = p.number(i)
        found = str(number) if number is not None and number < 10 else None
    if found is not None and (found in string.ascii_uppercase + string.digits + "+-*/="):
        p.reach(i + 1)
        return found
    return None


_WHEN = frozenset({"before", "after", "when", "until", "while", "once", "as", "because", "since", "if"})
_GO = frozenset({"go", "come", "leave", "get", "return", "arrive"})
"""Between these "I" is who speaks: "before I go home"."""
_WORDS = frozenset({"a", "i", "x"})
"""Letters that are words as well."""
_RUN = 3
"""So many letters in a row are a list, even of small ones."""


def _in_letters(p: Parser, i: int) -> bool:
    """ "a b c", "d c b a", "a b and c": one of a run of single letters; "a b and a c" are two blocks."""
    begin = end = i
    while begin > 0 and _one_letter(p, begin - 1):
        begin -= 1
    while _one_letter(p, end):
        end += 1
    last = p.words[end] in _AND and _one_letter(p, end + 1) and not _one_letter(p, end + 2)
    return end - begin + last >= _RUN


def _one_letter(p: Parser, i: int) -> bool:
    token = p.token(i)
    return token is not None and token.kind == "word" and len(token.raw) == 1 and token.raw.isalpha()


def _among_letters(p: Parser, i: int) -> bool:
    """ "c, a and t", "put a on b", "the a cube": an "a" beside other letters, where no article could stand."""
    if p.words[i] != "a":
        return False
    called = i > 0 and p.words[i - 1] == "the" and p.words[i + 1] in lexicon.BLOCK
    if not called and p.words[i + 1] not in _BEHIND_ONE:
        return False
    return any(_one_letter(p, n) and p.words[n] not in _WORDS for n in range(p.end))


_BEHIND_ONE = frozenset({"and", "", ".", ",", "on", "onto", "under", "in", "at", "above", "below", "beside", "next",
                         "behind", "is", "must", "should", "goes"})  # fmt: skip


def _between(first: str, last: str) -> tuple[str, ...]:
    for row in (string.ascii_uppercase, string.digits):
        if first in row and last in row and row.index(first) <= row.index(last):
            return tuple(row[row.index(first) : row.index(last) + 1])
    return ()


COUNTED_NOUNS = frozenset({"color", "colors", "hues", "shades", "ends", "sides", "halves", "kinds", "others", "of"})
"""Nouns that a number in front of them counts; it is no label then."""


@rule
def run(p: Parser, i: int) -> Results[tuple[str, ...]]:
    """ "1 to 5", "E down to A": symbols one after the other, either way."""
    first = symbol(p, i)
    j = p.any_of(i + 1, _TOWARD) if first is not None else 0
    last = symbol(p, j) if j else None
    if first is not None and last is not None:
        found = span_of(first, last)
        if len(found) > 1:
            yield found, j + 1


def span_of(first: str, last: str) -> tuple[str, ...]:
    """The symbols from one to another, either way."""
    return _between(first, last) or _between(last, first)[::-1]


def of_such(p: Parser, i: int, k: int, quality: str | None, update: Mapping[str, Any]) -> Mapping[str, Any]:
    """ "(the odd numbers) from 1 to 9": those of the range that are odd; of numbers that are listed each has to be."""
    labels = update.get("labels", ())
    if not quality or len(labels) < 3 or labels != span_of(labels[0], labels[-1]) or _TO.isdisjoint(p.words[i:k]):
        return update
    return {**update, "labels": tuple(label for label in labels if label in symbols_of(quality))}


@rule
def label_list(p: Parser, i: int, spoken: bool = False) -> Results[tuple[tuple[str, ...], bool]]:
    """Labels in the order said, longest list first, and whether it goes on ("A, B, C...")."""
    first = symbol(p, i, spoken)
    if first is None or (
        first in "+-*/="
        and p.words[i] in ("plus", "times", "minus", "equals", "equal", "divided", "divide")
        and not spoken
        and p.words[i + 1] not in _CUBES
        and not (p.follows(i, ("a", "an", "one")) and p.words[i + 1] in (",", "and", "", ".", ";", ")"))
    ):
        return
    if (j := p.one(i + 1, _TO)) and (last := symbol(p, j, spoken)) and (run := _between(first, last)):
        yield (run, False), j + 1
    readings: list[tuple[tuple[tuple[str, ...], bool], int]] = [(((first,), False), i + 1)]
    labels, at = [first], i + 1
    while True:
        j = p.opt(at, ",")
        j = j if p.words[j] == "plus" and p.words[j + 1] in _GOES_ON else p.opt(j, *_AND)
        if p.one(j, "…") and j > at - 1:
            readings.append(((tuple(labels), True), j + 1))
            break
        again = _named_again(p, i, j) if j > at else 0
        j = again or j
        after = symbol(p, j, spoken)
        signed = after is not None and after in "+-*/=" and labels[-1].isalpha()  # "A/B": no list of three
        if after is None or (j == at and (signed or not _bare_row(p, at, spoken))):
            break
        if after == labels[-1] and p.stands(j + 1, _UPON):  # "1 on 2, 2 on 3": the next pair
            break
        if p.follows(at + 1, (",",)) and p.any_of(j + 1, TOO):  # "A left of B, C too": so is C
            break
        labels.append(after)
        at = j + 1
        if (k := p.one(at, _TO)) and (last := symbol(p, k, spoken)) and (run := _between(after, last)):
            labels += run[1:]
            at = k + 1
        readings = [] if again else readings
        readings.append(((tuple(labels), False), at))
    yield from reversed(readings)


TOO = ("too", "also", "likewise", "as well")
"""What says of the last one that is named what was said of the first."""
_NAMES = {"letters": "letter", "numbers": "number", "digits": "digit", "blocks": "block", "cubes": "cube"}


def _named_again(p: Parser, i: int, j: int) -> int:
    """Past the word of "cubes number 5 and number 6", "the letters A and letter B", where one of them is next, or 0."""
    before = p.words[i - 1]
    word = "number" if before == "number" and p.words[i - 2] in _NAMES else _NAMES.get(before, "")
    return p.one(p.opt(j, "the"), word) if word and i > 0 else 0


_ORDERING = frozenset({"line", "arrange", "order", "stack", "lay", "sort"})
_NEXT_CLAUSE = frozenset({"then", "before", "after", "while", "without", "but", "once"})


def from_to(p: Parser, i: int) -> Results[tuple[str, ...]]:
    """ "(the letters) from A to D (are on the mat)": which ones, where that is not the order of all."""
    if j := p.one(i, "from"):
        rising = ((labels, k) for labels, k in run(p, j) if k < p.end and labels[0] < labels[-1])
        yield from ((labels, k) for labels, k in rising if not _told_in_order(p, i, k))


def _told_in_order(p: Parser, i: int, k: int) -> bool:
    """ "line up the letters from A to D, then ...": the order of all, where the clause ends behind k."""
    joint = p.opt(k, ",", ";")
    j = p.opt(joint, "and")
    ends = p.words[joint] in _NEXT_CLAUSE or (j > k and any(x == "base" for *_, x in p.lex(j, lexicon.VERB) or ()))
    return ends and not _ORDERING.isdisjoint(p.words[max(0, i - 4) : i])


def once_more(p: Parser, i: int, j: int) -> Results[tuple[str, ...]]:
    """ "(the A and) the other A", "(a 4 and) another 4": a symbol that was named before, not a number."""
    for at in (j, j - 1):
        named = symbol(p, at) if i < at < p.end and p.words[at] in p.words[:i] else None
        if named is not None and p.lex(at + 1, lexicon.BLOCK) is None:
            yield (named,), at + 1
            return


def look_at(p: Parser, i: int) -> bool:
    """Whether a look stands at i: "red block number 2" is the second of the red ones."""
    return symbol_at(p, i) or (i >= 0 and p.words[i] in lexicon.COLOR)


def symbol_at(p: Parser, i: int) -> bool:
    """Whether a letter or a number stands at i: in "(stack A, B and) C with the C at the bottom" it needs no other."""
    return i >= 0 and (p.tokens[i].kind != "word" or (len(p.tokens[i].raw) == 1 and p.tokens[i].raw.isupper()))


_UPON = frozenset({"on", "onto", "above", "over", "below", "under", "beside", "next", "behind", "atop"})
"""What begins what is said of a symbol."""


def _bare_row(p: Parser, at: int, spoken: bool) -> bool:
    """ "A B C", "7 8 9", "a b c": symbols side by side without commas."""
    token = p.token(at)
    if _one_letter(p, at) and (spoken or _in_letters(p, at)):
        return True
    return token is not None and (token.kind in ("sign", "number") or (len(token.raw) == 1 and token.raw.isupper()))


def literal(p: Parser, i: int) -> str | None:
    """A word to be spelt: quoted, after "the word" or "spell", or in capitals."""
    token = p.token(i)
    if token is None:
        return None
    if token.kind in ("quote", "literal") and isinstance(token.value, str):
        p.reach(i + 1)
        return token.value.upper()
    if token.kind == "word" and len(token.raw) > 1 and token.raw.isupper() and token.raw.isalpha():
        p.reach(i + 1)
        return token.raw
    return None


def initials(p: Parser, i: int) -> bool:
    """ "(Line the blocks up as) RGB": what stands for colours where no letters are spoken of."""
    text = literal(p, i) or ""
    colors = {color[0].upper() for color in lexicon.COLORS} | {"K"}
    return (
        p.follows(i, ("as",)) and len({*text}) == len(text) and {*text} <= colors and p.all.isdisjoint(lexicon.LETTER)
    )


def digits_of(p: Parser, i: int) -> str | None:
    """A number of several digits, to be written with a cube for each."""
    token = p.token(i)
    plain = token is not None and token.kind == "number" and len(token.raw) > 1 and token.raw.isdigit()
    return token.raw if token is not None and plain and p.reach(i + 1) else None
