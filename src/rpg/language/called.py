"""What something is called: "build a traffic light: red on top, yellow in the middle, green at the bottom"; "imagine a
snowman. A big block is at the bottom ..."; "make a chimney, a tower of five".

The name means nothing here, and nothing of the task hangs on it where all is told behind a colon, or where what stands
behind another mark tells of nothing but what is at its bottom, in its middle, on its left and so on, or which figure it
is. No name is passed over that tells how many blocks there are or how they look, or of a shape that the blocks would
have.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from rpg.language import lexicon
from rpg.language.headings import commanded
from rpg.language.phrases import length_at
from rpg.language.slips import slips_of
from rpg.language.spelling import vocabulary
from rpg.language.telling import SHAPES, may_tell, tells
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
_MAKING = frozenset({"make", "build", "create", "form", "construct", "assemble", "show", "draw", "design", "produce"})
_LEADS = frozenset({"please", "now", "can", "could", "you", "i", "want", "would", "like", "let", "us", "to", "me",
                    "this", "is", "here", "should", "see", "must", "will", "we", "need", "my", "students", "kids",
                    "children", "the", "robot", "arm", "it", "he", "she", "imagine", "think", "of", "picture", "do",
                    "know", "how", "about", *_MAKING})  # fmt: skip
_ARTICLES = frozenset({"a", "an", "the", "my", "our", "some", "one"})
_OUT_OF = frozenset({"with", "from", "using", "of", "out", "made", "built"})
_SHAPES = SHAPES | {
    "zigzag", "spiral", "diamond", "star", "heart", "wave", "ball", "snake", "worm", "diagonal",
}  # fmt: skip
"""Names of shapes: a row of blocks would be none of these."""
_THINGS = frozenset({"robot", "sandwich", "car", "face", "bridge", "gate", "table", "bed"})
"""Names that have another meaning beside blocks, or nearly that of a word with one."""
_LONGEST = 3
"""So many words is a name long at most."""
_PARTS = ({"top"}, {"bottom", "base"}, {"middle", "center"}, {"left"}, {"right"}, {"first"}, {"second"}, {"third"})
"""What something has that is told part by part."""
_POINTING = frozenset({"it", "its", "them", "they"})


def without_names(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens without such names where all is told behind a colon, and notes of them."""
    out: list[Token] = []
    notes: list[str] = []
    at = 0
    while at < len(tokens):
        begins = not out or out[-1].word in _STOPS
        name, end = next(_named(tokens, at), ("", at)) if begins else ("", at)
        name, end = (name, end) if name else next(_lined_up(tokens, at), ("", at))
        if name:
            notes.append(f"'{name}' is what is told behind it")
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
    begin = article + 1
    while begin < end and words[begin] in lexicon.SIZE:
        begin += 1  # "a little bridge": how large it is follows from what is told
    name = tokens[begin:end]
    colon = _behind_stuff(words, end)
    more = colon + 1 < len(words) and words[colon + 1] not in _STOPS
    if more and name and any(map(_strange, name)) and not any(map(_tells, name)):
        said = _that_is(tokens, colon)
        meant = words[colon] == ":" or said > colon + 1
        if meant or (words[colon] in _STOPS | {","} and _all_told(tokens, name, colon)):
            yield " ".join(token.raw for token in name), said


def _that_is(tokens: list[Token], mark: int) -> int:
    """The position behind a mark, and behind "i.e." or "that is" there."""
    words = [token.word for token in tokens]
    said = mark + 1
    if words[mark] in (",", "-", "("):
        said += length_at(words, said, (("that", "is"), ("namely",))) or tokens[said].raw.startswith("i.e")
        said += said > mark + 1 and words[said : said + 1] == [","]
    return said


def _all_told(tokens: list[Token], name: list[Token], mark: int) -> bool:
    """Whether all that stands behind a mark tells how something is made, and nothing else that is to be done."""
    behind = tokens[mark + 1 :]
    words = [token.word for token in behind]
    again = any(token.word in words or may_tell(token.word) for token in name)
    listed = any(one in ("and", "then", ",") and other in lexicon.COMMANDS for one, other in pairwise(words))
    pointed = next((n for n, word in enumerate(words) if word in _POINTING), len(words))
    of_it = pointed < len(words) and not any(map(tells, behind[:pointed]))
    if again or listed or of_it or commanded(behind):
        return False
    return sum(not part.isdisjoint(words) for part in _PARTS) > 1 or (words[0] in _ARTICLES and _one_figure(words))


def _one_figure(words: list[str]) -> bool:
    """ "A (tall) tower of five": one figure, and no list of several."""
    figures = [n for n, word in enumerate(words) if word in lexicon.STRUCTURE]
    return len(figures) == 1 and figures[0] < _LONGEST and lexicon.STRUCTURE[words[figures[0]]][1] is False


def _lined_up(tokens: list[Token], at: int) -> Iterator[tuple[str, int]]:
    """The name of so many things of which it is said how they are lined up, and the position behind it: "a skyline of
    (three towers in a row)", "a rack of (12 cubes, 3 rows by 4 columns)"."""
    words = [token.word for token in tokens]
    end = next((n for n in range(at + 2, at + _LONGEST + 1) if words[n : n + 1] != [] and words[n] in _OUT_OF), 0)
    of = end + length_at(words, end, (("made", "out"), ("built", "out"), ("made",), ("built",), ("out",))) if end else 0
    begun = words[at] in _ARTICLES and 0 < of < len(words) - 2 and words[of] in ("of", "from")
    if not begun or tokens[of + 1].many < 2:
        return
    name = tokens[at + 1 : end]
    end = next((n for n in range(of, len(words)) if words[n] in _STOPS), len(words))
    things = next((n for n in range(of + 2, end) if words[n] not in _LOOKS), end)
    said = " ".join(words[things + 1 : end])
    several = things < end and (
        lexicon.BLOCK.get(words[things]) or lexicon.STRUCTURE.get(words[things], ("", False))[1]
    )
    lined = any(line in said for line in _LINED) or {"rows", "columns"} <= {*words[things:end]}
    named = all(_strange(word) and (word.word in _LONG or not _tells(word)) for word in name)
    if several and lined and named and name[-1].word not in _UPRIGHT:
        yield " ".join(token.raw for token in name), of + 1


_LOOKS = lexicon.COLOR.keys() | lexicon.SIZE.keys() | lexicon.NUMBER.keys() | {"and", ","}
_LINED = (
    "in a row",
    "in one row",
    "in a line",
    "in one line",
    "in a straight row",
    "in a straight line",
    "one behind the other",
    "side by side",
    "stacked",
    "on top of each other",
    "one on top of the other",
)
_LONG = frozenset({"snake", "worm"})
_UPRIGHT = frozenset({"facade", "fence", "window", "screen", "shelf", "bookshelf", "shelves", "cupboard", "cabinet",
                      "curtain", "poster", "billboard", "building", "house", "gate", "hedge", "dam"})  # fmt: skip
"""What would stand upright, of which rows and columns lie flat otherwise."""


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
    return not slips_of(token.word)
