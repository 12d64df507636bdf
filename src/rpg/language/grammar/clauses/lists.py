"""Lists in which a clause may seem to begin: "two red and two blue blocks: a tower", "the letters P, Q and R is"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.meaning import Clause, Coord, Meaning, Noun, Structure


def ends_a_list(p: Parser, j: int, k: int, previous: Clause, item: Meaning) -> bool:
    """Whether what looks like a clause ends a list of what there is: "there are two red and two blue blocks: a row"."""
    listing = (previous.verb == "exist" and not previous.adjuncts) or (previous.lemma == "fact" and ":" in p.words[j:k])
    listing = previous.lemma == "tally" or (listing and not isinstance(previous.theme, Structure))
    return listing and of_the_list(p, j, k, item)


def of_the_list(p: Parser, j: int, k: int, item: Meaning) -> bool:
    """ "a red, a green and a blue cube, stacked in that order": what ends a list is no clause of its own."""
    theme = item.theme if isinstance(item, Clause) and item.mode == "goal" else None
    if theme is not None and theme.span[0] != p.char(j, 0):
        return False  # "..., and on it a red cube"
    for whole in ("members", "part_of"):  # "a tower of two blue ones, both of them"
        theme = getattr(theme, whole, None) or theme
    counted = isinstance(theme, Coord | Noun) and getattr(getattr(theme, "items", (theme,))[0], "amount", None)
    return bool(counted) and p.words[j - 1] in (",", "and") and _FINITE.isdisjoint(p.words[j:k])


_FINITES = "is are must should shall has have goes go lies lie stands stand sits sit"
_FINITE = frozenset(_FINITES.split())


def in_list(p: Parser, j: int) -> bool:
    """Whether the comma before `j` is one of a list of colours or labels: "the red, blue and green blocks"."""
    if j < 2 or j >= p.end or p.words[j - 1] != ",":
        return False
    before, after = p.tokens[j - 2], p.tokens[j]
    if before.word in lexicon.COLOR:
        counted = j > 2 and (p.number(j - 3) is not None or p.words[j - 3] in ("a", "an"))
        placed = counted and p.stands(j + 1, _PLACED)  # "2 green, 1 pink, pink on top"
        return after.word in lexicon.COLOR and not placed
    return all(token.kind in _LABELS or len(token.word) == 1 for token in (before, after))


def in_labels(p: Parser, j: int, before: Clause) -> bool:
    """ "A row of the letters P, Q and R is on the left": all of them are its letters."""
    told = before.theme.members if isinstance(before.theme, Structure) and not before.adjuncts else None
    last, after = p.tokens[j - 2], p.tokens[j] if j < p.end else None
    joined = p.words[j - 1] == "and" and isinstance(told, Noun) and len(told.traits.labels) > 1 and after is not None
    return joined and all(t.kind in _LABELS or len(t.word) == 1 for t in (last, after) if t is not None)


_PLACED = frozenset({"on", "at", "in", "leftmost", "rightmost", "lowest", "topmost"})
_LABELS = frozenset({"literal", "number", "sign"})
"""The kinds of words that labels of blocks are; single letters are words."""
