"""What is done by something, told once for several: "red is carried by blue, and green by yellow"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

_BE = frozenset({"is", "are", "be", "being", "gets", "get"})
_MUST = frozenset({"should", "must", "shall", "to", "has", "have", "will", "needs", "need"})
_DONE = frozenset({"held", "borne", "held up", "kept"})
_JOINTS = frozenset({",", "and", "while", ";", "whereas"})
_NAMES = frozenset({"the", "a", "an", "one", "ones", "both", "two", "three", "left", "right", "other", "top", "bottom",
                    "middle", *lexicon.COLOR, *lexicon.BLOCK, *lexicon.PATCH, *lexicon.STRUCTURE})  # fmt: skip


def by_again(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The red block is carried by the blue block, the green one by the yellow block": is carried by it, too."""
    for by in (n for n, word in enumerate(words) if word == "by" and n > 1):
        begin = _done(words, by)
        end = next((n for n in range(by, len(words)) if words[n] in (".", "!", "?")), len(words))
        for again in (n for n in range(by + 2, end) if words[n] == "by") if begin else ():
            at = again - 1
            while at > by and words[at] in _NAMES:
                at -= 1
            if by < at < again - 1 and words[at] in _JOINTS and words[again - 1] not in ("the", "a", "an"):
                said = [tokens[again].saying(words[n]) for n in range(begin, by)]
                return [*tokens[:again], *said, *tokens[again:]]
    return None


def _done(words: list[str], by: int) -> int:
    """Where "is carried by" begins; 0 where "by" follows something else."""
    at = by - 2 if words[by - 1] == "up" else by - 1
    done = words[at].endswith("ed") or words[at] in _DONE
    be = at - 1
    if not done or be < 1 or words[be] not in _BE:
        return 0
    while be > 1 and words[be - 1] in _MUST:
        be -= 1
    return be
