"""How one more block looks, told behind it: "in the middle one more that is black", "one more block, a white one"."""

from __future__ import annotations

from rpg.language.grammar.rows.vocabulary import COLOR, CUBE, MUST
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_PLACE = " (?:in|at|on|to|above|over|inside|between|next|behind)\\b"
_FURTHER = on_demand(
    f"\\b(?:one|an?) (?:more|further|additional|extra|single)(?: (?:{CUBE}|one))?(?: ,)? (?:(?:that|which) "
    f"(?:is|{MUST} "
    f"be)|an?|and it(?: is| {MUST} be)) ({COLOR})(?: one| {CUBE})?(?: ,(?={_PLACE}))?(?= [.,;!]|$|{_PLACE})"
)


def one_more(tokens: list[Token]) -> list[Token]:
    """The tokens with its colour ahead of it: one more of a colour that was told of before is another such."""
    words = [token.word.replace(" ", "_") or "_" for token in tokens]
    if {"more", "further", "additional", "extra", "single"}.isdisjoint(words):
        return tokens
    text = " ".join(words)
    found = _FURTHER.search(text)
    if found is None:
        return tokens
    first, last = text[: found.start()].count(" "), text[: found.end()].count(" ") + 1
    color = text[: found.end(1)].count(" ")
    the = tokens[first].saying("another" if words[color] in words[:first] else "a")
    return [*tokens[:first], the, tokens[color], tokens[first].saying("block"), *tokens[last:]]
