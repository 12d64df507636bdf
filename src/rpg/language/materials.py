"""What blocks are made of or serve for: "the red wooden block", "the four black obstacle cubes" are the red and the
black ones, where that tells no two blocks apart."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.spelling import nearest, vocabulary
from rpg.language.tokens import Token

_MATERIALS = frozenset({
    "wooden", "wood", "plastic", "foam", "rubber", "lego", "duplo", "toy", "cardboard", "paper", "felt", "fabric",
    "metal", "steel", "acrylic", "styrofoam", "cloth", "carpet",
})  # fmt: skip
_BLOCKS = frozenset({*lexicon.BLOCK, "one", "ones"})
_THINGS = frozenset({*_BLOCKS, *lexicon.PATCH, *lexicon.TABLE})
_LOOKS = frozenset({*lexicon.COLOR, *lexicon.SIZE, "building", "colored", "coloured", "letter", "number", "square",
                    "round", "identical", "equal"})  # fmt: skip


_PURPOSES = frozenset({
    "obstacle", "sample", "test", "training", "demo", "practice", "dummy", "example", "decoy", "filler", "calibration",
    "reference", "cargo", "prize", "trophy", "bonus", "mystery", "payload", "player", "game", "benchmark",
})  # fmt: skip
_WHY = "what things are made of or serve for is left out"
_OF_LOOKS = re.compile("(?:ed|y|ish|ic|al|ous|ar|ent|ant|ive|less|ful|ular|ing|er|est)$")
"""How words end that tell what something looks like, which cannot be left out."""


def _serves(word: str) -> bool:
    """Whether a noun ahead of "block" is what it serves for, or means nothing here and is no slip of the pen."""
    if word in _PURPOSES:
        return True
    strange = len(word) > 3 and word.isalpha() and word not in vocabulary() and not _OF_LOOKS.search(word)
    return strange and not nearest(word, 1 + (len(word) > 5))


def without_materials(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens without what blocks, patches and the table are made of or serve for, and a note of it."""
    found = {n: end for n, token in enumerate(tokens) if token.word in _MATERIALS and (end := _thing(tokens, n))}
    ahead = (n for n in range(1, len(tokens) - 1) if tokens[n + 1].word in lexicon.BLOCK and tokens[n].kind == "word")
    found |= {n: n + 1 for n in ahead if _serves(tokens[n].word)}
    if not found:
        return tokens, []
    of_blocks = {tokens[n].word for n, end in found.items() if tokens[end].word in _BLOCKS}
    told = {n: _colored(tokens, n, end) for n, end in found.items()}
    known = all(told[n] or tokens[n].word in _MATERIALS | _PURPOSES for n in found)
    alike = known and (all(told.values()) or not _other_blocks(tokens, found))
    if len(of_blocks) > 1 or not alike:
        return tokens, []
    said = ", ".join(dict.fromkeys(tokens[n].raw for n in found))
    return [token for n, token in enumerate(tokens) if n not in found], [f"{_WHY}: {said}"]


def _thing(tokens: list[Token], at: int) -> int:
    """Where the thing is named that is made of it; 0 where it is said of nothing."""
    end = at + 1
    while end < len(tokens) and (tokens[end].word in _LOOKS or tokens[end].word in _MATERIALS):
        end += 1
    return end if end < len(tokens) and tokens[end].word in _THINGS else 0


def _colored(tokens: list[Token], at: int, end: int) -> bool:
    """Whether a block is known by its colour or sign besides; a patch or the table is known anyway."""
    if tokens[end].word not in _BLOCKS:
        return True
    looks = [*tokens[max(at - 1, 0) : at], *tokens[at + 1 : end], *tokens[end + 1 : end + 2]]
    return any(token.word in lexicon.COLOR or token.kind in ("literal", "number") or _symbol(token) for token in looks)


def _symbol(token: Token) -> bool:
    return len(token.raw) == 1 and token.raw.isupper()


def _other_blocks(tokens: list[Token], found: dict[int, int]) -> bool:
    """Whether blocks are named, by a noun or by a colour alone, of which it is not said what they are made of."""
    ends = set(found.values())
    for n, token in enumerate(tokens):
        if token.word in lexicon.BLOCK and n not in ends:
            return True
        noun = next((t.word for t in tokens[n + 1 :] if t.word not in _LOOKS | _MATERIALS), "")
        if token.word in lexicon.COLOR and noun not in lexicon.PATCH:
            return True
    return False
