"""Lists behind "in order" that are in no order: "put the numbers in order: 3, 1, 2"."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_SHOWN = frozenset({"numbers", "digits", "letters", "number", "digit", "letter"})
_MARKS = frozenset({":", ","})


def check_order(words: list[Token]) -> None:
    """Refuse a list that could be the order itself, or what is to be put in the order that its symbols have.

    Raises:
        Refusal: "ambiguous", where the list is not in the order of the numbers or the alphabet.
    """
    for at in (n for n in range(2, len(words) - 3) if [w.word for w in words[n - 1 : n + 1]] == ["in", "order"]):
        shown = not _SHOWN.isdisjoint(word.word for word in words[max(0, at - 4) : at - 1])
        if not shown or words[at + 1].word not in _MARKS:
            continue
        listed = []
        for word in words[at + 2 :]:
            if word.kind == "number" or (len(word.word) == 1 and word.word.isalpha()):
                listed.append(word)
            elif word.word not in (",", "and"):
                break
        values = [word.many if word.kind == "number" else ord(word.word) for word in listed]
        rising = {one < other for one, other in pairwise(values)}
        if len(rising) > 1:
            raise refuse("ambiguous", "in the order of this list, or in that of these symbols?",
                         (listed[0].span[0], listed[-1].span[1]),
                         "say 'in this order', 'in alphabetical order' or 'in numerical order'")  # fmt: skip
