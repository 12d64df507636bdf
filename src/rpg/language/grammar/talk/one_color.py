"""Figures of one colour: "a single-colour tower of three blocks" is one of three blocks of the same colour."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_OF_ONE = (
    *((one, color) for one in ("single", "one", "same", "solid") for color in ("color", "colored")),
    ("monochrome",), ("monochromatic",), ("unicolored",), ("uniformly", "colored"), ("uniform", "color"),
)  # fmt: skip
ONE_COLOR = frozenset(words[0] for words in _OF_ONE)
_EACH = frozenset({"each", "every", "per"})
"""What makes several figures of one: "for each colour a monochrome tower"."""
_OUT_OF = frozenset({"of", "from", "with", "using"})


def one_color(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """Several such figures are "monochrome" ones; of a single one it is said of its blocks, unless they are told to be
    of one colour anyway. What is left is refused."""
    at = next((n for n in range(len(words)) if _figure(words, n)), None)
    if at is None:
        return None
    figure = at + _figure(words, at)
    said, rest = tokens[at].saying("monochrome"), tokens[figure:]
    if lexicon.STRUCTURE[words[figure]][1]:
        return [*tokens[:at], said, *rest]
    end = next((n for n in range(at, len(words)) if words[n] in STOPS), len(words))
    colors = {lexicon.COLOR[word] for word in words[at:end] if word in lexicon.COLOR}
    if len(colors) == 1 and "not" not in words[at:end]:
        return [*tokens[:at], *rest]
    if colors or not _EACH.isdisjoint(words[:end]):
        return [*tokens[:at], said, *rest] if words[at] != "monochrome" else None
    blocks = _blocks(tokens, figure + 1)
    number = figure + 2 if not blocks and _counted(tokens, figure + 1) else 0
    named = "blocks" if number else "" if blocks else "of blocks"
    same = [tokens[at].saying(word) for word in (*named.split(), "of", "the", "same", "color")]
    behind = (blocks or number or figure) + 1
    return [*tokens[:at], *tokens[figure:behind], *same, *tokens[behind:]]


def _figure(words: list[str], at: int) -> int:
    """How many words say that it has one colour, where the name of a figure follows; else 0."""
    long = length_at(words, at, _OF_ONE)
    end = at + long
    told = long and end < len(words) and words[end] in lexicon.STRUCTURE
    return long if told else 0


def _blocks(tokens: Sequence[Token], at: int) -> int:
    """Where the blocks are named that it is made of; 0 where they are not."""
    return at + 2 if _counted(tokens, at) and tokens[at + 2 : at + 3] and tokens[at + 2].word in lexicon.BLOCK else 0


def _counted(tokens: Sequence[Token], at: int) -> bool:
    """Whether it is said here of how many it is made: "(a tower) of three"."""
    return at + 1 < len(tokens) and tokens[at].word in _OUT_OF and tokens[at + 1].many >= 1


def all_of_color(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A tower of four blocks behind a tower of two blocks, all of them brown": both are brown."""
    for end in range(4, len(words) + 1):
        if words[end - 1] not in lexicon.COLOR or (end < len(words) and words[end] not in STOPS):
            continue
        lead = next((n for n in range(end - 2, max(end - 6, 0), -1) if words[n] == ","), 0)
        begin = max((n + 1 for n in range(lead) if words[n] in STOPS), default=0)
        said = tokens[begin:lead]
        figures = [n for n in range(len(said)) if _figures(said, n)]
        colored = any(token.word in lexicon.COLOR for token in said)
        if not length_at(words, lead + 1, _ALL_OF_THEM) == end - lead - 2 > 0 or len(figures) < _SEVERAL or colored:
            continue
        spots = [_blocks(said, n + 1) or n for n in figures]
        told = [part for n, token in enumerate(said) for part in ([tokens[end - 1]] if n in spots else []) + [token]]
        return [*tokens[:begin], *told, *tokens[end:]]
    return None


def _figures(said: Sequence[Token], n: int) -> bool:
    """Whether a figure is named, or another one "of two blocks"."""
    one = said[n].word == "one" and n > 0 and _blocks(said, n + 1) > 0
    part = said[n].word in _PARTS or (said[n].word in _LINES and any(token.word in _STAIRS for token in said[:n]))
    return one or (said[n].word in lexicon.STRUCTURE and not part)


_ALL_OF_THEM = tuple(
    (*whom, *be)
    for whom in (("all",), ("all", "of", "them"), ("both",), ("both", "of", "them"), ("each",), ("each", "of", "them"),
                 ("everything",), ("all", "blocks"), ("all", "the", "blocks"))
    for be in ((), ("in",), ("are",), ("is",))
)  # fmt: skip
_SEVERAL = 2
_PARTS = frozenset({"step", "steps", "stair", "stairs"})
_LINES = frozenset({"column", "columns", "row", "rows", "stack", "stacks", "tower", "towers"})
_STAIRS = frozenset({"staircase", "stairs", "grid", "wall", "square", "rectangle"})
"""These may be of a figure that is named besides, as lines are of a staircase or a grid."""
