"""What something is called: "build a traffic light: red on top, yellow in the middle, green at the bottom".

The name means nothing here, and nothing of the task hangs on it where all is told behind a colon. No name is passed
over that tells how many blocks there are or how they look, or of a shape that the blocks would have.
"""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.spelling import LONG_WORD, nearest, slip, vocabulary
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
_MAKING = frozenset({"make", "build", "create", "form", "construct", "assemble", "show", "draw", "design", "produce"})
_LEADS = frozenset({"please", "now", "can", "could", "you", "i", "want", "would", "like", "let", "us", "to", "me",
                    "this", "is", "here", "should", "see", "must", "will", "we", "need", "my", "students", "kids",
                    "children", "the", "robot", "arm", *_MAKING})  # fmt: skip
_ARTICLES = frozenset({"a", "an", "the", "my", "our", "some", "one"})
_OUT_OF = frozenset({"with", "from", "using", "of", "out"})
_SHAPES = frozenset({
    "zigzag", "zig", "zag", "spiral", "hexagon", "pentagon", "octagon", "polygon", "diamond", "rhombus", "star",
    "heart", "arc", "arch", "semicircle", "wave", "curve", "helix", "trapezoid", "trapezium", "parallelogram", "oval",
    "ellipse", "sphere", "dome", "cylinder", "cone", "ball", "snake", "worm", "diagonal", "chevron",
})  # fmt: skip
"""Names of shapes: a row of blocks would be none of these."""
_THINGS = frozenset({"robot", "sandwich", "car", "face", "bridge", "gate", "table", "bed"})
"""Names that have another meaning beside blocks, or nearly that of a word with one."""
_LONGEST = 3
"""So many words is a name long at most."""


def without_names(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens without such names where all is told behind a colon, and notes of them."""
    out: list[Token] = []
    notes: list[str] = []
    at = 0
    while at < len(tokens):
        begins = not out or out[-1].word in _STOPS
        name, end = next(_named(tokens, at), ("", at)) if begins else ("", at)
        if name:
            notes.append(f"'{name}' is what is told behind the colon")
            at = end
        else:
            out.append(tokens[at])
            at += 1
    return out, notes


def _named(tokens: list[Token], start: int) -> Iterator[tuple[str, int]]:
    """The name of what is to be made, and the position behind the colon."""
    words = [token.word for token in tokens]
    at = start
    while at < len(words) and words[at] in _LEADS and words[at + 1 : at + 2] != [":"]:
        at += 1
    article = at - 1 if at > start and words[at - 1] in _ARTICLES else at
    if article >= len(words) or words[article] not in _ARTICLES:
        return
    end = article + 1
    while end < len(words) and end - article <= _LONGEST and tokens[end].kind == "word" and words[end] not in _OUT_OF:
        end += 1
    name = tokens[article + 1 : end]
    colon = _behind_stuff(words, end)
    more = colon + 1 < len(words) and words[colon] == ":" and words[colon + 1] not in _STOPS
    if more and name and any(map(_strange, name)) and not any(map(_tells, name)):
        yield " ".join(token.raw for token in name), colon + 1


def _behind_stuff(words: list[str], at: int) -> int:
    """The position behind "(made) out of the cubes", of which no more is said."""
    stuff = at
    while stuff < len(words) and words[stuff] in _OUT_OF:
        stuff += 1
    stuff += words[stuff : stuff + 1] == ["the"] and stuff > at
    return stuff + 1 if stuff > at and stuff < len(words) and lexicon.BLOCK.get(words[stuff]) else at


def _tells(token: Token) -> bool:
    """Whether a word tells more than a name: of the blocks, their looks, or of a shape."""
    word = token.word
    known = word in lexicon.COLOR or word in lexicon.NUMBER or word in lexicon.BLOCK or word in lexicon.PATCH
    return known or word in lexicon.STRUCTURE or word in lexicon.SIZE or word in _SHAPES


def _strange(token: Token) -> bool:
    """A word that means nothing here, and is no slip for one that does."""
    return token.word in _THINGS or unheard(token)


def unheard(token: Token) -> bool:
    """A word that is none of the language, nor a slip for one that is."""
    if token.word in vocabulary() or len(token.word) < 3 or token.raw.isupper():
        return False
    near = nearest(token.word, 1 if len(token.word) < LONG_WORD else 2)
    return not any(len(known) > 2 and slip(token.word, known) for known in near)
