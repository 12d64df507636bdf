"""Figures that are only thought of: "we consider a grid whose ...", "take a 3x3 grid", "consider fourteen blocks; I
want a pyramid whose ...". Where nothing is to be done with it that is the goal; else it may be there already."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.phrases import by_first, length_at
from rpg.language.tokens import Token

CONSIDERED = frozenset({"consider", "take", "imagine", "picture"})
_LEADS = by_first(tuple(f"{who}{verb}" for who in ("", "we ", "let us ", "i ", "now ", "let us now ")
                        for verb in CONSIDERED))  # fmt: skip
_WISHES = tuple(tuple(wish.split()) for wish in (
    "i want", "we want", "i need", "i would like", "build", "make", "form", "create", "please build", "please make"
))  # fmt: skip
_PARTS = frozenset({"center", "rest", "order", "point", "space", "form", "face"})
"""Words of commands that may tell of the figure as well."""
_DOING = (lexicon.COMMANDS - lexicon.STRUCTURE.keys() - _PARTS) | {
    "should", "must", "shall", "will", "can", "it", "them", "they", "then", "start", "starts", "becomes", "where",
    "apart", "down", "away", "off",
}  # fmt: skip
"""With these words more than the figure itself is told."""
_NEAR = 4


def considered(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with the figure as what is to be built, where it is all that is told."""
    begin = length_at(words, 0, _LEADS.get(words[0], ()))
    if not begin or begin + 1 >= len(words):
        return None
    if (end := _so_many(tokens, begin)) and words[end : end + 1] and words[end] in {*STOPS, ","}:
        wish = end + 1 + length_at(words, end + 1, _WISHES)
        if wish > end + 1 and _figure(words, wish) and _DOING.isdisjoint(words[wish:]):
            return [*tokens[begin:end], tokens[end].saying("form"), *tokens[wish:]]
    if _figure(words, begin) and _DOING.isdisjoint(words[begin:]):
        return [tokens[begin - 1].saying("build"), *tokens[begin:]]
    return None


def _so_many(tokens: list[Token], at: int) -> int:
    """Where "fourteen (red) blocks" ends; 0 if it does not begin here."""
    end = at + 1 + (tokens[at + 1].word in lexicon.COLOR)
    counted = tokens[at].many > 1 and end < len(tokens) and tokens[end].word in lexicon.BLOCK
    return end + 1 if counted else 0


def _figure(words: list[str], at: int) -> bool:
    """Whether "a (3x3) grid" begins here."""
    near = words[at + 1 : at + 1 + _NEAR]
    return words[at : at + 1] in (["a"], ["an"], ["one"]) and any(word in lexicon.STRUCTURE for word in near)
