"""The symbols that blocks of an inventory show."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from rpg.language import lexicon
from rpg.language.tokens import Token

Labels = tuple[Token, ...]
KINDS = {"letter": "letters", "letters": "letters", "digit": "digits", "digits": "digits", "number": "digits",
         "numbers": "digits", "symbol": "blocks", "symbols": "blocks", "numbered": "digits",
         "lettered": "letters"}  # fmt: skip
_SIGNS = {"plus": "+", "minus": "-", "equals": "=", "equal": "=", "times": "*", "multiplication": "*", "division": "/"}
_SHOWN = frozenset({"+", "-", "*", "/", "="})
_MARKED = frozenset({"labelled", "labeled", "marked", "numbered", "showing", "bearing", "carrying", "with", "lettered",
                     "reading"})  # fmt: skip
_OPENED = {",": "", ":": "", "(": ")"}


def _label(tokens: Sequence[Token], i: int) -> tuple[Token | None, int]:
    """A symbol and the position after it: "A", "7", "a minus sign"."""
    if i >= len(tokens):
        return None, i
    token = tokens[i]
    sign = i + (token.word in ("a", "an"))
    if sign + 1 < len(tokens) and tokens[sign].word in _SIGNS and tokens[sign + 1].word == "sign":
        shown = _SIGNS[tokens[sign].word]
        return Token("sign", shown, shown, (token.span[0], tokens[sign + 1].span[1])), sign + 2
    if token.kind == "number" and isinstance(token.value, float) and token.value in range(10):
        return token, i + 1
    if token.kind == "sign" and token.word in _SHOWN:
        return token, i + 1
    if token.kind in ("quote", "literal") and isinstance(token.value, str) and len(token.value) == 1:
        return token, i + 1
    single = token.kind == "word" and len(token.raw) == 1 and token.raw.isupper()
    return (token, i + 1) if single else (None, i)


def labels_at(tokens: Sequence[Token], i: int) -> Iterator[tuple[Labels, int]]:
    """Lists of symbols that begin there, longest first: "A, B and C", "1 to 4"."""
    first, j = _label(tokens, i + (tokens[i].word == "a" and tokens[i].raw == "a") if i < len(tokens) else i)
    if first is None:
        return
    if j < len(tokens) and tokens[j].word == "to":
        last, end = _label(tokens, j + 1)
        run = _run(first, last) if last is not None else ()
        if run:
            yield run, end
        return
    joint = j
    while joint < len(tokens) and tokens[joint].word in (",", "and") and joint < j + 2:
        joint += 1
    for rest, end in labels_at(tokens, joint) if joint > j else ():
        yield (first, *rest), end
    yield (first,), j


def _run(first: Token, last: Token) -> Labels:
    """All symbols from one to another."""
    begin, end = first.word.upper(), last.word.upper()
    if len(begin) != 1 or len(end) != 1 or begin.isdigit() != end.isdigit() or not begin < end:
        return ()
    shown = [chr(n) for n in range(ord(begin), ord(end) + 1)]
    if begin.isdigit():
        return tuple(Token("number", x, x, first.span, float(x)) for x in shown)
    return tuple(Token("word", x.lower(), x, first.span) for x in shown) if begin.isalpha() else ()


def labels_to(
    tokens: Sequence[Token], i: int, count_at: Callable[[Sequence[Token], int], tuple[int, int]]
) -> Iterator[tuple[str, int, int, str]]:
    """What leads to symbols: their kind, how many there are (0: not said), where they begin, and what closes them."""
    many, j = count_at(tokens, i)
    j += not many and i < len(tokens) and tokens[i].word == "the"
    kind = KINDS.get(tokens[j].word, "") if j < len(tokens) else ""
    block = j + bool(kind)
    if block < len(tokens) and tokens[block].word in lexicon.BLOCK:
        plain = not many and tokens[j].word != tokens[i].word
        after = block + 1
        if after < len(tokens) and tokens[after].word in _OPENED and many > 1:
            yield kind or "blocks", many, after + 1, _OPENED[tokens[after].word]
        if after < len(tokens) and tokens[after].word in _MARKED:
            yield from _marked(tokens, after, kind, many)
        if plain or many == 1:
            yield kind or "blocks", many, after, ""
    elif kind:
        opened = _OPENED.get(tokens[block].word) if block < len(tokens) else None
        if opened is not None and many > 1:
            yield kind, many, block + 1, opened
        if not many:
            yield kind, 0, block, ""


def _marked(tokens: Sequence[Token], i: int, kind: str, many: int) -> Iterator[tuple[str, int, int, str]]:
    """ "(three blocks) with the letters A, B and C (on them)", "labelled A, B and C", "numbered from 1 to 4"."""
    j = i + 1
    if tokens[i].word == "with" and j < len(tokens) and tokens[j].word in KINDS and tokens[j].word.endswith("s"):
        after = j + 1
        after += tokens[after : after + 2] != [] and [t.word for t in tokens[after : after + 2]] == ["on", "them"]
        after += after > j + 1
        if after < len(tokens) and tokens[after].word in _OPENED and many > 1:
            yield KINDS[tokens[j].word], many, after + 1, _OPENED[tokens[after].word]
    j += j < len(tokens) and tokens[j].word in ("the", "from")
    shown = KINDS.get(tokens[j].word, "") if j < len(tokens) else ""
    if tokens[i].word == "numbered":
        kind = "digits"
    yield shown or kind or "blocks", many, j + bool(shown), ""
