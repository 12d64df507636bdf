"""Formulas of planners in words: "on(A, B)" and "(on A B)" say that A is on B, "clear(A)" that nothing is on A."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Stray, Token

_TWO = {
    ("on",): ("on",), ("above",): ("above",), ("under",): ("under",), ("below",): ("under",), ("beside",): ("beside",),
    ("near",): ("near",), ("behind",): ("behind",), ("touching",): ("touching",), ("between",): ("between",),
    ("left", "of"): ("left", "of"), ("right", "of"): ("right", "of"), ("in", "front", "of"): ("in", "front", "of"),
    ("next", "to"): ("next", "to"), ("leftof",): ("left", "of"), ("rightof",): ("right", "of"),
    ("nextto",): ("next", "to"), ("stacked",): ("on",), ("ontop",): ("on",), ("inside",): ("on",),
}  # fmt: skip
"""Relations of two or more things."""
_OF_ONE = {
    ("ontable",): ("is", "on", "the", "table"), ("on", "table"): ("is", "on", "the", "table"),
    ("clear",): ("has", "nothing", "on", "it"),
}  # fmt: skip
_HAND = ("handempty", "armempty", "gripperempty", "handfree", "armfree")
_HANDS = tuple((hand, "empty") for hand in ("hand", "arm", "gripper"))
"""What holds at the end of every task."""
_JOINTS = frozenset({"and", "or", "&", "∧", ",", ";", "."})
_HOLD = (("hold",), ("holds",), ("are", "true"), ("is", "true"), ("are", "satisfied"), ("is", "satisfied"), ("true",))
_ACHIEVE = frozenset({"achieve", "satisfy", "establish", "make", "reach", "realize", "fulfil", "fulfill"})
"""Verbs of which a formula is the object."""
_AHEAD = _JOINTS | _ACHIEVE | {":", "(", "that", "where", "is", "are", "with", "until", "such", "so", "goal", "ensure"}
"""What a formula may stand behind."""


def formulas_told(tokens: list[Token], strays: list[Stray]) -> tuple[list[Token], list[Stray]]:
    """The tokens of a text with such formulas in words, and the characters that belong to no word."""
    if not any(t.word == "(" or t.word in _HAND for t in tokens):
        return tokens, strays
    out: list[Token] = []
    at, told, opened = 0, False, 0
    while at < len(tokens):
        words, end = _formula(tokens, at) if told or not out or out[-1].word in _AHEAD else (None, at)
        if words is not None:
            _join(out, words, told, tokens[at])
            at, told = end, True
        elif tokens[at].word == "(" and _joined(tokens, at):
            opened, at = opened + 1, at + 2
        elif opened and tokens[at].word == ")":
            opened, at = opened - 1, at + 1
        elif told and (held := next((h for h in _HOLD if _words(tokens, at, len(h)) == h), None)):
            at += len(held)
        else:
            out.append(tokens[at].saying("and") if told and tokens[at].word in ("&", "∧") else tokens[at])
            told = told and tokens[at].word in _JOINTS
            at += 1
    return out, (strays if out == tokens else [s for s in strays if s.text != "_"])


def _join(out: list[Token], words: list[Token], told: bool, first: Token) -> None:
    """Put what a formula says behind what was said; one of the empty hand takes the joint before it away."""
    if told and words and out[-1].word not in _JOINTS:
        out.append(first.saying(","))
    elif out and out[-1].word in _ACHIEVE:
        out[-1] = out[-1].saying("ensure")
    while not words and out and out[-1].word in _JOINTS:
        out.pop()
    out += words


def _words(tokens: list[Token], at: int, many: int) -> tuple[str, ...]:
    return tuple(t.word for t in tokens[at : at + many])


def _joined(tokens: list[Token], at: int) -> bool:
    """Whether a list of formulas begins there, as in "(and (on A B) (on B C))"."""
    return _words(tokens, at + 1, 1) == ("and",) and _formula(tokens, at + 2)[0] is not None


def _formula(tokens: list[Token], at: int) -> tuple[list[Token] | None, int]:
    """What the formula that begins there says, and where it ends; None where there is none."""
    if at >= len(tokens):
        return None, at
    if _words(tokens, at, 2) in (("not", "("), ("(", "not")):
        inner, end = _formula(tokens, at + 2)
        if inner and _words(tokens, end, 1) == (")",):
            return _denied(inner), end + 1
    if tokens[at].word == "not":
        inner, end = _formula(tokens, at + 1)
        return (_denied(inner), end) if inner else (None, at)
    if _words(tokens, at, 2) in _HANDS:
        return [], at + 2
    if tokens[at].word in _HAND:
        return [], at + 1 + 2 * (_words(tokens, at + 1, 2) == ("(", ")"))
    lisp = tokens[at].word == "("
    if lisp and _words(tokens, at + 1, 1)[:1] in [(word,) for word in _HAND]:
        return ([], at + 3) if _words(tokens, at + 2, 1) == (")",) else (None, at)
    begin = at + lisp
    for table, several in ((_OF_ONE, False), (_TWO, True)):
        for name, said in sorted(table.items(), key=lambda item: -len(item[0])):
            inside = begin + len(name) + (not lisp)
            if _words(tokens, begin, len(name)) != name or (not lisp and _words(tokens, inside - 1, 1) != ("(",)):
                continue
            close = next((k for k in range(inside, len(tokens)) if tokens[k].word in ("(", ")", ".")), len(tokens))
            things = _things(tokens[inside:close], lisp) if _words(tokens, close, 1) == (")",) else []
            if things and (len(things) > 1) == several:
                return _said(things, said, tokens[at]), close + 1
    return None, at


def _things(tokens: list[Token], lisp: bool) -> list[list[Token]]:
    """What stands between the brackets, thing by thing; none where it is no such list."""
    found: list[list[Token]] = [[]]
    for token in tokens:
        if token.word == ",":
            found.append([])
        elif lisp and found[-1]:
            found.append([_thing(token)])
        else:
            found[-1].append(_thing(token))
    plain = not lisp or all(_named(token) for thing in found for token in thing)
    return found if plain and all(0 < len(thing) <= _LONGEST for thing in found) else []


_LONGEST = 3
"""Words of a thing, as in "the red block"."""


def _named(token: Token) -> bool:
    """Whether one word names a thing, as in "(on A table)"."""
    return token.kind == "number" or len(token.raw) == 1 or token.word in lexicon.COLOR or token.word == "table"


def _thing(token: Token) -> Token:
    """A block's letter is one, as small as it may be written."""
    small = token.kind == "word" and len(token.raw) == 1
    return Token("word", token.word, token.raw.upper(), token.span) if small else token


def _said(things: list[list[Token]], said: tuple[str, ...], name: Token) -> list[Token]:
    first, *others = things
    if said[0] in ("is", "has"):
        return [*first, *(name.saying(word) for word in said)]
    told = [*first, *(name.saying(word) for word in ("is", *said))]
    for n, other in enumerate(others):
        told += [name.saying("and")] * (n > 0)
        told += [name.saying("the")] * ([t.word for t in other] == ["table"]) + other
    return told


def _denied(words: list[Token]) -> list[Token]:
    """The statement, denied."""
    at = next(n for n, t in enumerate(words) if t.word in ("is", "has"))
    if words[at].word == "has":
        return [*words[:at], words[at], words[at].saying("something"), *words[at + 2 :]]
    return [*words[: at + 1], words[at].saying("not"), *words[at + 1 :]]
