"""What blocks form, said behind all that is said of their places: "Red at the bottom, blue on top. One stack."."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.tokens import Token

_LEADS = frozenset({"in", "as", "just", "only", "all", "make", "makes", "form", "it", "is", "that", "of", "them", "so",
                    "it's", "a", "one", "an", "two", "three", "four", "single", "straight", "separate", "different",
                    "neat", "simple", "plain", "build", "this", "into"})  # fmt: skip
_SHAPES = ("stack", "row", "line", "column")
_CLOSING = frozenset({".", "!", "please", "total", "altogether"})
_SIGNS = frozenset({".", ";", ",", "!", "("})
_MANY = frozenset({"two", "three", "four"})
_DONE = frozenset({*lexicon.VERB, *lexicon.PATCH, "go", "goes", "come", "comes"})


def shape_ahead(tokens: list[Token]) -> list[Token] | None:
    """The words with the shape in front, where the last few tell no more than that: "One stack: red at the bottom"."""
    end = len(tokens)
    while end and (tokens[end - 1].word in _CLOSING or tokens[end - 1].word == ")"):
        end -= 1
    noun = lexicon.STRUCTURE.get(tokens[end - 1].word) if end else None
    if noun is None or noun[0] not in _SHAPES:
        return None
    begin = end - 1
    while begin and tokens[begin - 1].kind != "punct" and tokens[begin - 1].word in _LEADS:
        begin -= 1
    told = {token.word for token in tokens[begin : end - 1]}
    if begin < 2 or tokens[begin - 1].word not in _SIGNS or noun[1] != bool(told & _MANY):
        return None
    before = tokens[: begin - 1]
    said = {token.word for token in before}
    if not said.isdisjoint(lexicon.STRUCTURE) or ":" in said or not told:
        return None
    if "then" in said and not said.isdisjoint(_DONE):  # what is done one after the other is no order of a row
        return None
    count = [token for token in tokens[begin : end - 1] if token.word in _MANY]
    colon = replace(tokens[end - 1], kind="punct", word=":", raw=":", value=None)
    return [*count, tokens[end - 1], colon, *before]
