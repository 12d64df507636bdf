"""A line that is told as a list, and what is then changed in it: "The row is red, blue, green from left to right. Swap
the two outer ones.", "Start with a tower of A, B and C, A at the bottom. Take the top two off."

What a command of change follows is how the line is at the start, in the order in which it is listed; and the blocks
that the command tells by their places in it are called by what they are.
"""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.grammar.rows.row_places import word_of
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_LINES = {"row": "row", "line": "row", "tower": "tower", "stack": "tower", "pile": "tower"}
_BLOCK = "(?:block|cube|one|letter|digit|number)"
_ITEM = rf"(?:the |an? )?(?:@?\w+)(?: {_BLOCK})?"
_UPWARDS = "from (?:the )?bottom to (?:the )?top|from (?:the )?bottom(?: up| upwards)?|bottom to top|bottom up"
_DOWNWARDS = "from (?:the )?top to (?:the )?bottom|from (?:the )?top(?: down| downwards)?|top to bottom|top down"
_ACROSS = "from (?:the )?left to (?:the )?right|from (?:the )?left|left to right"
_BACKWARDS = "from (?:the )?right to (?:the )?left|from (?:the )?right|right to left"
_WAY = f"(?:{_UPWARDS}|{_DOWNWARDS}|{_ACROSS}|{_BACKWARDS})"
_AT = "(?:at the bottom|on top|at the top|on the left|on the right|at the left end|at the right end|leftmost|rightmost)"
_LIST = rf"(?P<list>{_ITEM}(?: , {_ITEM})*(?: , and| and| ,) {_ITEM})"
_END = rf"(?P<end>{_ITEM}) (?P<at>{_AT})(?: and {_ITEM} {_AT})?"
_TAIL = rf"(?: ,)?(?: in (?:this|that) order)?(?: ,)?(?: (?P<way>{_WAY})| (?:with )?{_END})?"
_TOLD = tuple(
    on_demand(rf"(?:{row}){_TAIL}")
    for row in (
        rf"(?:the|an?|my|our) (?P<line>row|line|tower|stack|pile) (?P<copula>is) {_LIST}",
        rf"(?:at the start (?:, )?)?(?:there is|we have|i have|start with|begin with|we start with|we begin with|"
        rf"it starts as|you start with) (?:the|an?|my|our) (?P<line>row|line|tower|stack|pile) (?:of|with|:) {_LIST}",
        rf"(?:an?|the|my|our) (?P<line>row|line|tower|stack|pile) of {_LIST} (?:is|stands) "
        rf"(?:there|already there|on the table)",
        rf"(?P<ahead>{_WAY})(?: ,)? (?:lie|stand|sit|are|there are|we have|lie the blocks|stand the blocks) {_LIST}",
        rf"(?:right now |now |currently |at the moment |at the start )?(?P<are>the|my) "
        rf"(?:blocks|cubes|letters|digits|numbers|letter blocks|number blocks) are {_LIST}",
        rf"{_LIST} (?:are|stand|are standing|lie|are lying) "
        rf"(?P<kind>stacked|in a row|in a line|lined up|in a stack|in a tower)",
    )
)
"""How a line is listed; the groups tell what kind it is, what it is made of and which way it is told."""
_CHANGES = frozenset({"swap", "exchange", "switch", "reverse", "change", "rearrange", "reorder", "take", "remove",
                      "bring", "turn", "flip", "invert", "move", "lift", "undo", "sort", "rebuild"})  # fmt: skip
_LED = frozenset({"now", "then", "please", "and", "first", ","})
_FIRST_OF = {"row": ("first", "leftmost"), "tower": ("bottom", "lowest", "lower")}
_LAST_OF = {"row": ("last", "rightmost"), "tower": ("top", "highest", "upper", "uppermost")}
_NOUN = "(?: blocks| cubes| ones| letters)?"
_OUTER = (
    "(?:the )?(?:two (?:blocks |cubes )?(?:at|on) the (?:two )?(?:ends|outside)|(?:two )?(?:outer|outermost|end) "
    "(?:two|blocks|cubes|ones|letters)|(?:two )?ends|"
    f"first and (?:the )?last{_NOUN}|first and (?:the )?last (?:one|block|cube|letter))"
)
_OFF = on_demand(r"(?:take|lift) (?:(?P<ahead>off) )?(?P<them>.+? and .+?)(?(ahead)| (?:off|down))(?: again)?")
_SO_THAT = on_demand(r"(?:change|alter|reorder|sort) (?:it|the row|the tower|them) so(?: that)? ")
_ARTICLES, _NOUNS = ("the", "a", "an"), ("block", "cube", "one", "letter", "digit", "number")


def listed_lines(tokens: list[Token]) -> list[Token]:
    """The tokens with a line that is listed told of the start, if it is changed by the next sentence."""
    first, *rest = sentences(tokens) or [tokens]
    if not rest or not _changed(rest[0]):
        return tokens
    words = [word_of(first, n) for n in range(len(first)) if first[n].word not in STOPS]
    words[:1] = [words[0].lstrip("@")] if words[1:2] and words[1] in _LINES else words[:1]
    text = " ".join(words)
    told = next((met for row in _TOLD if (met := row.fullmatch(text))), None)
    if told is None or not any(map(told.groupdict().get, ("copula", "kind", "end", "ahead", "are"))):
        return tokens  # what is there by its words, and in an order that is told, is read as it stands
    kind = _kind(told)
    if kind is None:
        return tokens
    begin = text[: told.start("list")].count(" ")
    listed = first[begin : begin + told["list"].count(" ") + 1]
    names = [name for name in (_named(part) for part in _parts(listed)) if name]
    way = _direction(told, kind, [_look(name) for name in names])
    looks = {_look(name) for name in names}
    if len(looks) != len(names) or "" in looks or way is None:
        return tokens
    base = first[0]
    lead = ["at", "the", "start", "there", "is", "a", kind, "of"]
    start = [*(base.saying(word) for word in lead), *_and(names, base), *(base.saying(w) for w in way.split())]
    ordered = names[::-1] if way in ("from top to bottom", "from right to left") else names
    out = [*start, base.saying(".")]
    for sentence in rest:
        out += _by_name(sentence, ordered, kind)
    return out


def _changed(sentence: list[Token]) -> bool:
    words = [token.word for token in sentence]
    at = next((n for n, word in enumerate(words) if word not in _LED), 0)
    return bool(words) and words[at] in _CHANGES


def _kind(told: re.Match[str]) -> str | None:
    """The kind of line: by what it is called, by how its blocks stand, or by the way in which they are told."""
    parts = told.groupdict()
    if parts.get("line"):
        return _LINES[parts["line"]]
    if parts.get("kind"):
        return "tower" if parts["kind"] in ("stacked", "in a stack", "in a tower") else "row"
    way = parts.get("ahead") or parts.get("way")
    return None if way is None else "row" if re.fullmatch(f"{_ACROSS}|{_BACKWARDS}", way) else "tower"


def _parts(listed: list[Token]) -> list[list[Token]]:
    out: list[list[Token]] = [[]]
    for token in listed:
        if token.word in (",", "and"):
            out.append([])
        else:
            out[-1].append(token)
    return [part for part in out if part]


def _named(part: list[Token]) -> list[Token]:
    kept = [n for n in range(len(part)) if word_of(part, n) not in _ARTICLES]
    return [part[n] for n in kept if part[n].word not in _NOUNS or n == kept[0]]


def _look(name: list[Token]) -> str:
    """What a block is called by: its colour, or what it shows."""
    word = word_of(name, 0)
    return word if word[0] == "@" or name[0].kind in ("number", "literal") else lexicon.COLOR.get(word, "")


def _direction(told: re.Match[str], kind: str, looks: list[str]) -> str | None:
    """Which way a line is listed, from the words or from which end one of its blocks has; None if they fit no order."""
    way, end = told["way"] or told.groupdict().get("ahead") or "", told["end"]
    if end is not None:
        look = next((lexicon.COLOR.get(w, w) for w in end.split() if lexicon.COLOR.get(w) or w[0] == "@"), "")
        low = told["at"] in ("at the bottom", "on the left", "at the left end", "leftmost")
        if look not in (looks[0], looks[-1]) or (kind == "tower") != (told["at"] in _UPRIGHT):
            return None
        ahead = (look == looks[0]) == low
    else:
        ahead = not re.fullmatch(f"{_DOWNWARDS}|{_BACKWARDS}", way)
        if way and (kind == "tower") != (re.fullmatch(f"{_UPWARDS}|{_DOWNWARDS}", way) is not None):
            return None
    return {("row", True): "from left to right", ("row", False): "from right to left",
            ("tower", True): "from bottom to top", ("tower", False): "from top to bottom"}[kind, ahead]  # fmt: skip


_UPRIGHT = ("at the bottom", "on top", "at the top")


def _and(names: list[list[Token]], base: Token) -> list[Token]:
    """ "Red, blue and green"."""
    out: list[Token] = []
    for n, name in enumerate(names):
        out += [base.saying("and" if n == len(names) - 1 else ",")] if n else []
        out += name
    return out


def _by_name(sentence: list[Token], names: list[list[Token]], kind: str) -> list[Token]:
    """A later sentence with the blocks named that it tells by their places in the line."""
    places = {
        _OUTER: (names[0], names[-1]),
        f"(?:the )?(?:(?:two )?(?:{'|'.join(_FIRST_OF[kind])}) two|two (?:{'|'.join(_FIRST_OF[kind])})){_NOUN}": names[
            :2
        ],
        f"(?:the )?(?:(?:two )?(?:{'|'.join(_LAST_OF[kind])}) two|two (?:{'|'.join(_LAST_OF[kind])})){_NOUN}": names[
            -2:
        ],
    }
    for place, pair in places.items():
        text = " ".join(word_of(sentence, n) for n in range(len(sentence)))
        met = re.search(rf"(?<!\S){place}(?!\S)", text)
        if met is None:
            continue
        begin = text[: met.start()].count(" ")
        end = begin + met.group().count(" ") + 1
        base = sentence[begin]
        the = base.saying("the")
        sentence = [*sentence[:begin], the, *pair[0], base.saying("and"), the, *pair[1], *sentence[end:]]
    return _off_it(sentence) if kind == "tower" else _so_that(sentence)


def _off_it(sentence: list[Token]) -> list[Token]:
    """ "Take red and blue off", "take off red and blue": off the tower."""
    stop = len(sentence) - (bool(sentence) and sentence[-1].word in STOPS)
    text = " ".join(token.word for token in sentence[:stop])
    met = _OFF.fullmatch(text)
    if met is None:
        return _so_that(sentence)
    begin = text[: met.start("them")].count(" ")
    end = begin + met["them"].count(" ") + 1
    base = sentence[0]
    off = [base.saying(word) for word in ("off", "the", "tower")]
    return [base, *sentence[begin:end], *off, *sentence[stop:]]


def _so_that(sentence: list[Token]) -> list[Token]:
    """ "Change it so that ...": rearrange it so that."""
    if _SO_THAT.match(" ".join(token.word for token in sentence)) is None:
        return sentence
    return [sentence[0].saying("rearrange"), *sentence[1:]]
