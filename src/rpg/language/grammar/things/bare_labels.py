""" "The cube with A", "the block with the plus sign": what is on a cube, with no word for a letter or a digit."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.labels import label_list, look_at

_SIGNS = frozenset("+-*/=")


def borne(p: Parser, i: int) -> Results[tuple[str, ...]]:
    """The symbols behind "with"; of several a list: "stack the blocks with A on top" tells of one."""
    j = p.one(i, "with")
    if not j or not p.follows(i, lexicon.BLOCK) or look_at(p, i - 2):
        return
    several = lexicon.BLOCK.get(p.words[i - 1])
    for (labels, more), k in label_list(p, p.opt(j, "the"), True):
        sign = p.one(k, ("sign", "symbol")) if labels[-1] in _SIGNS else 0
        if not more and ("and" in p.words[j:k] if several else len(labels) == 1) and (sign or p.words[j] != "the"):
            yield labels, sign or k
