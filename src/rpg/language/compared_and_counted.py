"""Blocks that are compared, and counted behind that: "as many red as blue blocks on the mat, two of each", "twice as
many red blocks as blue ones on the mat: four red and two blue ones". They are told by how many they are."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MANY, number
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_ONES = f"(?: {CUBE}s| ones)"
_AS = f"(?P<a>{COLOR}){_ONES}? (?:as|than) (?P<b>{COLOR}){_ONES}?"
_TIMES = {"": 1, "exactly": 1, "just": 1, "twice": 2, "three times": 3, "four times": 4, "double": 2}
_COUNTED = on_demand(
    rf"\b(?P<compared>(?:(?P<times>{'|'.join(filter(None, _TIMES))}) )?(?:as many|(?P<more>more|fewer)) {_AS}) "
    rf"(?P<place>(?:(?!\b(?:{MANY}|and|or|each)\b)[a-z ])+) [:,] (?P<counts>(?P<m>{MANY}) of each"
    rf"|(?P<n1>{MANY}) (?P<c1>{COLOR}){_ONES}? and (?P<n2>{MANY}) (?P<c2>{COLOR}){_ONES}?)(?= [.;!?]|$)"
)
_LEFT_OVER = on_demand(rf"(?:\bas many\b.* as\b|\b(?:more|fewer)\b.* than\b)[^:.;!?]* : {MANY} {COLOR}\b")
"""A comparison with numbers behind it."""


def compared_and_counted(tokens: list[Token]) -> list[Token]:
    """The tokens with the numbers in the place of the comparison, where these agree."""
    words = {token.word for token in tokens}
    if words.isdisjoint(("as", "than")) or words.isdisjoint(("many", "more", "fewer")):
        return tokens
    text = text_of(tokens)
    found = _COUNTED.search(text)
    if found is None or found["a"] == found["b"]:
        return tokens
    if found["m"]:
        one = other = number(found["m"])
    elif {found["c1"], found["c2"]} == {found["a"], found["b"]}:
        counts = {found["c1"]: number(found["n1"]), found["c2"]: number(found["n2"])}
        one, other = counts[found["a"]], counts[found["b"]]
    else:
        return tokens
    more = {"more": one > other, "fewer": one < other}
    if not (more[found["more"]] if found["more"] else one == other * _TIMES[found["times"] or ""]):
        return tokens
    first, behind = (text[: found.start(part)].count(" ") for part in ("compared", "place"))
    counted, end = (text[:at].count(" ") for at in found.span("counts"))
    said = [lexicon.NUMBERS[one], found["a"], "and", lexicon.NUMBERS[other], found["b"], "blocks"]
    return [*tokens[:first], *map(tokens[first].saying, said), *tokens[behind : counted - 1], *tokens[end + 1 :]]


def left_over(text: str) -> bool:
    """Whether a comparison is told with numbers behind it, of what there is or of what is put there."""
    return _LEFT_OVER.search(text) is not None
