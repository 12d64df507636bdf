"""Words that are there at first and are changed: "the blocks spell CAT. Swap the C and the T"."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, Meaning, Structure, parts_of, replace

_IS_SO = re.compile(r"\b(?:is|are|spells?|reads?|shows?|forms?|says?|makes?|has been|have been)\b", re.IGNORECASE)
_PASSIVE = re.compile(r"\b(?:is|are|has been|have been)\b", re.IGNORECASE)
_WANTED = re.compile(
    r"\b(?:must|should|shall|has to|have to|needs? to|ought|will|can|may|let|want|wish|end|finally|final|goal|target|"
    r"result|make sure|ensure|so that)\b",
    re.IGNORECASE,
)


def worded_first(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences, with a word or an equation that is told to be there told of the start, where the very next
    sentence changes it: exchanges blocks of it, or asks for another word."""
    for n, chain in enumerate(chains[:-1]):
        word = chain.clauses[0]
        shape = _spelled(word)
        before = text[chains[n - 1].span[1] if n else 0 : chain.span[1]]
        plain = _IS_SO.search(before) is not None and _WANTED.search(before) is None
        if len(chain.clauses) > 1 or shape is None or not isinstance(word, Clause) or not plain:
            continue
        after = chains[n + 1]
        told = word.mode == "goal" or (word.mode == "command" and _PASSIVE.search(before) is not None)
        if told and _changes(after.clauses[0], shape, text[chain.span[1] : after.span[1]]):
            begun = replace(chain, clauses=(replace(word, mode="start"),))
            chains = (*chains[:n], begun, *chains[n + 1 :])
    return chains


def _spelled(clause: Meaning) -> str | None:
    """The word or the equation that a clause tells of."""
    if not isinstance(clause, Clause) or clause.negated or clause.verb not in ("spell", "arrange", "build", "be"):
        return None
    shape = clause.theme
    told = isinstance(shape, Structure) and shape.kind in ("word", "equation") and shape.det == "the"
    return shape.letter if told and isinstance(shape, Structure) else None


def _changes(order: Meaning, word: str, told: str) -> bool:
    if not isinstance(order, Clause) or order.negated:
        return False
    if order.mode in ("command", "goal") and order.verb in ("swap", "reverse", "unstack", "replace"):
        return True
    made = told.lstrip(" .;").lower().startswith("make ")
    asked = made or order.mode == "command" or _WANTED.search(told) is not None
    others = [x.letter for x in parts_of(order) if isinstance(x, Structure) and x.kind in ("word", "equation")]
    return asked and any(other is not None and other != word for other in others)
