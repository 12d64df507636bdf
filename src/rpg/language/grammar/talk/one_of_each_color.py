"""What each of several structures has, told by the colors that there are: "two towers from two red and two blue blocks,
each with one block of each color", "three stacks, each of which contains both colors": each with a red and a blue one.
"""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

_EACH = frozenset({"each", "every"})
_HAS = (
    ("has",), ("gets",), ("contains",), ("holds",), ("with",), ("of",), ("from",), ("includes",), ("consists", "of"),
    ("is", "made", "of"), ("made", "of"), ("must", "have"), ("should", "have"), ("must", "contain"),
    ("should", "contain"), ("of", "which", "contains"), ("of", "which", "has"), ("of", "them", "has"),
    ("of", "them", "contains"), ("one", "has"), ("one", "with"), ("one", "contains"), ("having",), ("containing",),
)  # fmt: skip
_ONE: tuple[tuple[str, ...], ...] = (
    ("one", "block", "of", "each", "color"), ("one", "block", "of", "every", "color"), ("one", "of", "each", "color"),
    ("one", "of", "every", "color"), ("one", "block", "from", "each", "color"), ("one", "of", "each"),
    ("exactly", "one", "block", "of", "each", "color"), ("exactly", "one", "of", "each", "color"),
    ("each", "color", "once"), ("every", "color", "once"), ("each", "color", "exactly", "once"),
    ("every", "color", "exactly", "once"), ("one", "block", "in", "each", "color"),
)  # fmt: skip
_ALL: tuple[tuple[str, ...], ...] = (
    ("both", "colors"), ("both", "of", "the", "colors"), ("all", "the", "colors"), ("all", "colors"),
    ("every", "color"), ("each", "color"), ("both", "the", "colors"),
)  # fmt: skip
_CELLS = frozenset({"row", "column", "layer", "line", "step", "level"})
"""Of a grid or a wall these are parts."""
_WHOLES = frozenset({"grid", "wall", "square", "cube", "pyramid", "staircase", "board", "checkerboard", "matrix"})


def one_of_each_color(tokens: list[Token]) -> list[Token] | None:
    """The words with the blocks of each structure told one by one; None where nothing is told of each by its colors."""
    words = ["block" if token.word in lexicon.BLOCK and token.word != "blocks" else token.word for token in tokens]
    for at in range(len(words) - 2):
        if words[at] not in _EACH:
            continue
        if words[at - 1 : at] in (["in"], ["per"]) and (told := _told_ahead(tokens, words, at)) is not None:
            return told
        head = at + 1 + (words[at + 1] in lexicon.STRUCTURE)
        part = words[at + 1] in _CELLS and not _WHOLES.isdisjoint(words)
        for has in _HAS if not part else ():
            begin = head + len(has)
            if tuple(words[head:begin]) != has:
                continue
            colors = _colors(tokens)
            end = _told(words, begin, colors)
            if end and len(colors) > 1:
                return [*tokens[:begin], *_listed(tokens[begin], colors), *tokens[end:]]
    return None


def _told_ahead(tokens: list[Token], words: list[str], at: int) -> list[Token] | None:
    """ "(Two towers) with one block of each color in each (tower)": each with these."""
    colors = _colors(tokens)
    begin = next((at - 1 - len(x) for x in _ONE if tuple(words[at - 1 - len(x) : at - 1]) == x), 0)
    end = at + 1 + (words[at + 1] in lexicon.STRUCTURE)
    if not begin or words[begin - 1] != "with" or len(colors) < 2:
        return None
    mark = tokens[begin]
    ahead = tokens[: begin - 1] if words[begin - 2] == "," else [*tokens[: begin - 1], mark.saying(",")]
    return [*ahead, mark.saying("each"), mark.saying("with"), *_listed(mark, colors), *tokens[end:]]


def _told(words: list[str], begin: int, colors: dict[str, int]) -> int:
    """Where it ends that each has one of each color, or all of them where there are as many of each as structures."""
    for once in _ONE:
        if tuple(words[begin : begin + len(once)]) == once and words[begin + len(once) :][:1] != ["of"]:
            return begin + len(once)
    said: tuple[str, ...] = next((x for x in _ALL if tuple(words[begin : begin + len(x)]) == x), ())
    end = begin + len(said)
    if words[begin] == "all" and words[begin + 2 : begin + 3] == ["colors"]:
        named = lexicon.NUMBER.get(words[begin + 1], 0) == len(colors)
        said, end = ("all",) if named else (), begin + 3
    both = "both" not in said or len(colors) == 2
    structures = {n for word, n in _counted(words) if word in lexicon.STRUCTURE}
    return end if said and both and {*colors.values()} == structures else 0


def _counted(words: list[str]) -> list[tuple[str, int]]:
    """What is counted, and the number: "(three stacks)", "(two high towers)"."""
    found = []
    for n, word in enumerate(words):
        if (many := lexicon.NUMBER.get(word, 0)) > 1:
            found += [(behind, many) for behind in words[n + 1 : n + 3] if behind in lexicon.STRUCTURE][:1]
    return found


def _colors(tokens: list[Token]) -> dict[str, int]:
    """The colors of the blocks that are told of, with how many there are of each; no color of a patch."""
    found: dict[str, int] = {}
    for n, token in enumerate(tokens):
        behind = next(
            (t.word for t in tokens[n + 1 :] if t.word not in lexicon.COLOR and t.word not in (",", "and")), ""
        )
        many = tokens[n - 1].many if n else 0
        if token.word in lexicon.COLOR and behind not in lexicon.PATCH and not (token.word in found and not many):
            found[token.word] = many or 1
    return found


def _listed(mark: Token, colors: dict[str, int]) -> list[Token]:
    out: list[Token] = []
    for n, color in enumerate(colors):
        out += [mark.saying("and" if n == len(colors) - 1 else ",")] if n else []
        out += [mark.saying("a"), mark.saying(color)]
    return [*out, mark.saying("block")]
