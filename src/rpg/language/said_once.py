"""What is said once of two things, told of each: "on the left and on the right end of a row", "a red tower of two next
to a blue one of three", "red on the left, blue on the right, in between two green blocks"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.turned import Turns, turned
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, PATCH
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_LINE = "(?:rows?|lines?|columns?|towers?|stacks?|piles?)"
_AT = "(?:on|at)(?: the)?"


def _ends(one: str, other: str, end: str) -> str:
    return f"{_AT} {one}(?: end)? and (?:also )?(?:one )?(?:{_AT} )?(?:the )?{other}{end}"


_PAIRS = (("left", "right"), ("front", "back"), ("front", "rear"), ("near", "far"), ("start", "end"),
          ("beginning", "end"), ("top", "bottom"))  # fmt: skip
_BOTH_ENDS = "|".join(
    _ends(one, other, "(?: ends?)?" if {"top", "end"} & {*pair} else " ends?")
    for pair in _PAIRS
    for one, other in (pair, pair[::-1])
)
_ENDS = Turns([(f"\\b(?:{_BOTH_ENDS}) of (?=(?:a|an|the|this|that) (?:\\w+ ){{0,2}}?{_LINE}\\b)", "at each end of ")])
_ONE_OF = on_demand(f"\\b(?P<a>an?|the) (?P<hue>{COLOR}) one of (?P<many>{MANY})(?= [.,;:!?)]| and\\b| ,|$)")
_SHAPE = f"(?:{'|'.join(sorted(name for name, (_, plural) in lexicon.STRUCTURE.items() if not plural))})"
_AND = "(?: ,| and| , and)"
_FIRST = f"(?:on|at) the (?:left|front|first {PATCH}|{COLOR} {PATCH}|one side|near side)\\b"
_SECOND = f"(?:on|at) the (?:right|back|second {PATCH}|{COLOR} (?:{PATCH}|one)|other side|other|far side)\\b"
_LISTED = f"(.*{_FIRST}.*{_AND} .*{_SECOND}.*?{_AND}) in between"
_BETWEEN = Turns([
    (f"^{_LISTED} (?=(?:(?:two|three|four|\\d+|several|both) |the (?:two|three|four) )(?!.*\\b(?:is|are|put|with)\\b))",
     "{1} in between are "),
    (f"^{_LISTED} (?=(?:an?|the) (?:\\w+ )?{_LINE} of (?!.*\\b(?:is|are|put|with)\\b))", "{1} in between is "),
])  # fmt: skip
_SHAPES = on_demand(f"\\b(?:an?|the) (?:\\w+ )?(?P<shape>{_SHAPE}) of\\b")


def said_of_each(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with what is said once of two things told of each of them."""
    words = {token.word for token in tokens}
    if "of" in words and "and" in words:
        tokens = turned(tokens, _ENDS)
    if "one" in words and "of" in words:
        tokens = _of_so_many(tokens)
    if "between" in words and "in" in words:
        tokens = turned(tokens, _BETWEEN)
    return tokens, []


def _of_so_many(tokens: list[Token]) -> list[Token]:
    """ "A red tower of two next to a blue one of three": a blue tower of three. Only where no other shape is told."""
    text = text_of(tokens)
    found = _ONE_OF.search(text)
    while found is not None:
        shapes = {shape["shape"] for shape in _SHAPES.finditer(text, 0, found.start())}
        if len(shapes) != 1:
            return tokens
        at = text[: found.end("hue")].count(" ") + 1
        tokens = [*tokens[:at], tokens[at].saying(shapes.pop()), *tokens[at + 1 :]]
        text = text_of(tokens)
        found = _ONE_OF.search(text)
    return tokens
