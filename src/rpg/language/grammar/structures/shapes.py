"""The nouns of structures: "tower", "ring", "L shape", "shape of a T"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns

_LETTER_SHAPES = frozenset("LTVUX")


@choice
def noun(p: Parser, i: int) -> Results[tuple[str, bool]]:
    """The structure's noun: its kind, and whether it is a plural."""
    found = p.lex(i, lexicon.STRUCTURE)
    if found is not None and p.tokens[i].kind == "word":
        kind, plural = found
        j = (
            i + 1
            if kind in ("stack", "pile", "word")
            else p.opt(
                p.opt(i + 1, "sign"), "shape", "formation", "outline", "frame", "pattern", "arrangement", "figure"
            )
        )
        j = p.opt(j, "tower") if kind == "pyramid" else j
        yield (kind, plural), j
    shape = p.lex(i, lexicon.SHAPE_ADJECTIVE)
    if shape and (j := p.one(i + 1, _FORMS)):
        yield (shape, False), j
    if p.words[i : i + 1] in (["cube"], ["cubes"]):
        yield ("cube", p.words[i] == "cubes"), p.reach(i + 1)
    if p.words[i : i + 1] in (["block"], ["box"], ["cuboid"]) and _dims_before(p, i, 3):
        yield ("cube", False), p.reach(i + 1)
    for many, kind in ((2, "grid"), (3, "cube")) if p.stands(i, _LAYOUTS) else ():
        if _dims_before(p, i, many):
            yield (kind, False), p.reach(i + 1)
    if j := p.any_of(i, ("chess board", "checker board", "checkers board", "chess pattern", "checker pattern")):
        yield ("checkerboard", False), p.opt(j, "pattern")
    if j := p.any_of(i, ("flight of stairs", "flight of steps", "set of stairs", "set of steps")):
        yield ("staircase", False), j
    for lead in ("color gradient", "gradient", "rainbow"):
        if j := p.seq(i, lead):
            yield ("gradient", False), j
    yield from _letter_shapes(p, i)


_LAYOUTS = frozenset({"layout", "arrangement", "formation", "pattern", "field", "board", "block"})


def _dims_before(p: Parser, i: int, many: int) -> bool:
    """ "a 2 by 2 by 2 block": three dimensions make it one of many blocks; "a 3x3 layout": two make it a grid."""
    token = p.tokens[i - 1] if i else None
    if token is not None and token.kind == "dims" and isinstance(token.value, tuple):
        return len(token.value) == many
    if many == 2:
        return i > 2 and p.words[i - 2] == "by" and p.words[i - 4 : i - 3] != ["by"] and p.words[i - 1].isalnum()
    words = p.words[max(0, i - 5) : i]
    return len(words) == 5 and words[1] == words[3] == "by" and words[4].isalnum()


_FORMS = frozenset(
    {"shape", "arrangement", "formation", "pattern", "layout", "outline", "figure", "form", "line", "ring"}
)


_TAILS = ("shape", "shapes", "formation", "shaped figure", "shaped structure", "shaped pattern", "shaped arrangement",
    "figure", "shaped formation",
          "shaped line", "shaped form", "shaped outline")  # fmt: skip


_LEADS = ("shape of an", "shape of a", "shape of the letter", "form of an", "form of a", "figure of an",
    "figure of a", "shape of the", "outline of a", "outline of an",
          "form of the letter", "capital", "figure of the letter", "letter", "shape of capital", "shape of a capital",
          "shape", "letter shape", "letter form")  # fmt: skip


_FORMING = frozenset(
    {"shape", "lay", "like", "form", "forms", "make", "draw", "build", "create", "into", "as", "forming", "of"}
)


_DRAWING = frozenset({"form", "forms", "forming", "into", "like", "draw", "shape"})
"""With these "a letter L" is no block."""
_TO_BE = Patterns("shall|must|should|has_to|is_to|will be", "is")
_DRAWN = frozenset({"formed", "drawn", "shaped", "outlined"})
"""What is done with a shape, and with no letter block: "the letter L shall be formed by four cubes"."""


@choice
def _letter_shapes(p: Parser, i: int) -> Results[tuple[str, bool]]:
    """ "L shape", "shape of a T", "an L"."""
    letter = _letter_at(p, i)
    if letter and i == 0 and p.tokens[i].raw.isupper() and p.stands(i + 1, ("from", "of", "out", "made")):
        yield (letter, False), p.reach(i + 1)
    if letter:
        for tail, j in p.standing(i + 1, _TAILS):
            yield (letter, tail == "shapes"), j
        drawn = i == 0 and p.tokens[i].raw.isupper()
        if drawn and (_made_of(p, i + 1) or p.any_of(i + 1, _WITH_LIMBS) or _so_many(p, p.any_of(i + 1, _SET_OFF))):
            yield (letter, False), p.reach(i + 1)
        if (
            (p.words[i - 1 : i] in (["a"], ["an"]) or (_described(p, i) and _made_of(p, i + 1)) or _turned(p, i))
            and i > 0
            and not (i + 1 < p.end and p.words[i + 1] in lexicon.BLOCK)
            and p.tokens[i].raw.isupper()
        ):
            yield (letter, False), p.reach(i + 1)
    for lead, j in p.standing(i, _LEADS):
        letter = _letter_at(p, j)
        if letter and (
            lead not in ("letter", "the letter")
            or p.one(j + 1, ("shape", "formation"))
            or p.words[i - 1] == "like"
            or (p.words[i - 1] == "the" and p.words[i - 2] in _FORMING)
            or (p.follows(i, ("a",)) and p.follows(i - 1, _DRAWING))
            or _made_of(p, j + 1)
            or any(p.stands(k, _DRAWN) for k in _TO_BE.matches(p, j + 1))
        ):
            yield (letter, False), p.opt(p.reach(j + 1), "shape", "formation")
        elif not letter and lead not in ("capital", "letter"):
            inner = p.lex(j, lexicon.STRUCTURE)
            if inner:
                yield (inner[0], False), p.opt(j + 1, "sign", "shape")


_OF = ("of", "from", "out of", "made of", "made from", "made out of", "built from", "with", "using", "built of")
_SET_OFF = (",", ":")
_KINDS = frozenset({*lexicon.SIZE, "capital", "flat", "simple"})
"""What may stand between "a" and the letter that a figure looks like; a colour would be that of a block."""


def _described(p: Parser, i: int) -> bool:
    return p.follows(i, _KINDS) and p.follows(i - 1, ("a", "an"))


UPSIDE_DOWN = ("upside down", "reversed")
"""As "inverted" is read, too."""
_POINTED = frozenset({"T", "U", "V"})
"""Letters of which this tells one way to lie: an L may be mirrored."""


def upside_down(p: Parser, i: int) -> int:
    """The position behind "upside-down" in "an upside-down T of five", "(five blocks) as an inverted V", or 0."""
    j = p.any_of(i, UPSIDE_DOWN)
    if not j or _letter_at(p, j) not in _POINTED:
        return 0
    formed = p.follows(i, ("a", "an")) and p.follows(i - 1, _AS) and p.words[j + 1] in _CLOSED
    return j if formed or _made_of(p, j + 1) else 0


_AS = frozenset({"as", "in", "into"})
_CLOSED = frozenset({"", ",", ";"})


def _turned(p: Parser, i: int) -> bool:
    """Whether "upside-down" stands before a letter that is a figure."""
    return any(upside_down(p, i - len(said.split())) == i for said in UPSIDE_DOWN if i > len(said.split()))


def _made_of(p: Parser, i: int) -> bool:
    """ "(V) with five green blocks", "(the letter T) from red cubes": so many that they form a figure."""
    of = p.any_of(i, _OF)
    many = of > 0 and p.stands(of, lexicon.COLOR) and lexicon.BLOCK.get(p.words[of + 1]) is True
    return (many and p.words[of - 1] not in _BESIDE) or _so_many(p, of)


def _so_many(p: Parser, i: int) -> bool:
    """ "seven yellow blocks": enough for a figure, and not said to be anywhere where they may be others."""
    many = p.number(i) if i else None
    if many is None or many < 3:
        return False
    k = i + 1 + p.stands(i + 1, lexicon.COLOR)
    end = k + (lexicon.BLOCK.get(p.words[k]) is True)
    return (end > i + 1 or p.words[i - 1] not in _SET_OFF) and (
        p.words[i - 1] not in _BESIDE or p.words[end] in ("", ",", ".", ";")
    )


_BESIDE = ("with", "using", ",", ":")


_WITH_LIMBS = tuple(f"with {the}{limb}" for the in ("", "a ", "the ", "its ") for limb in ("foot", "leg", "arm", "bar"))
"""What only a figure has, and no block with a letter."""


def _letter_at(p: Parser, i: int) -> str | None:
    token = p.token(i)
    if token is None or token.kind not in ("word", "quote", "literal"):
        return None
    raw = token.raw.strip("'\"`")
    letter = raw.upper()
    if len(raw) != 1 or letter not in _LETTER_SHAPES | {"O"}:
        return None
    return "circle" if letter == "O" else letter
