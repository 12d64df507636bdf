"""Words spelled along a row or down a tower, with the colours of their letters."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from rpg.language.frames.groups.shared_words import GLYPHS, glyphs
from rpg.language.frames.lots import one
from rpg.language.frames.pieces import Piece, Unclear, number, patterns
from rpg.language.frames.shared import BREAKS, GLUE, WHERE
from rpg.language.frames.wishes import WHOSE, WISHES

_X = (
    "(?:(?:(?:one|[2-9]) of )?(?:the |letter |an |a |one |both |all |every |each |only |its )*(?:[A-Z]s?|'[A-Z]')"
    "(?: blocks?| cubes?)?)"
)
_XS = f"{_X}(?:(?: ,)?(?: and)? {_X})*"
_PART = "first|second|third|fourth|fifth|last|middle|final|initial"
_LETTER = "(?:letters?|characters?|symbols?|(?:letter )?BLOCK)"
_CLASS = (
    f"(?:the |a |all |all the |both |its |every |each )*(?:(?:{_PART}) (?:letter|one|BLOCK)|first and last "
    "letters?|first and the last letter|vowels?|consonants?|(?:rest|others?|remaining ones|(?:other|remaining) "
    f"{_LETTER})(?: of (?:the letters|the word|them))?)"
)
_ALL = (
    "(?:one |[2-9] )?(?:(?:all|every|each|the|its|both|everything|all of)(?: of)?(?: the| its)? )*(?:the )?"
    f"{_LETTER}(?: of the word)?|it all|everything|all of it|the (?:whole )?word"
)
_IS = (
    "(?:(?:both|all|being|in|with|colored|painted|printed|shown|made|of|written|have|has|a|an|body|BE|as|must be|"
    "must) )*"
)

PATTERNS = [
    *patterns("glue", None, "'(?:ME|US)'(?= '[A-Z]+')"),
    *patterns(
        "word", lambda match: match["word"],
        f"(?:{WHOSE} 's name(?: ,| is)?(?: :)? )'(?P<word>[A-Z]{{2,}})'",
        "(?:the |my |our |a )?(?:(?:english |short |little |single )*(?:word|name|text|sign|message|letters|string|"
        "sequence|term|inscription|title|phrase|label|letter sequence) (?:, "
        ")?)?(?:: )?'(?P<word>[A-Z0-9]{2,})'(?: 's name)?",
    ),
    *patterns(
        "tower", None,
        "(?:(?:in|as|down|into|on|along|like|to form|forming|of|using) )*(?:a |the |one |an |single |vertical |"
        "upright |tall |letter )*(?:tower|stack|pillar)(?: of(?: the)?(?: [2-9])? (?:letter BLOCK|letters|BLOCK))?",
        "(?:stacked|stack)(?: up)?(?: on top of (?:each other|one another))?", "on top of (?:each other|one another)",
        "vertically|vertical",
    ),
    *patterns(
        "order", "from top to bottom",
        "(?:(?:which |that |it |i |can |be |when |to |when |from|reading|reads?|going|legible|starting|spelled|"
        "written) )*(?:the )?top (?:down )?to (?:the )?bottom", "(?:from )?(?:the )?top down(?:wards?)?",
        "downwards?", "(?:starting |beginning |reading )?from (?:the )?top", "top first",
    ),
    *patterns(
        "order", "from bottom to top", "(?:(?:reading|reads?|from|going) )*(?:the )?bottom (?:up )?to (?:the )?top",
        "(?:from )?(?:the )?bottom up(?:wards?)?", "upwards?",
        "(?:starting |beginning |reading )from (?:the )?bottom",
    ),
    *patterns(
        "row", None,
        "(?:(?:which |that |it |can |be |from|reading|reads?|going|legible|written|spelled|in order) )*(?:the "
        ")?left to (?:the )?right",
        "(?:(?:in|as|along|into|on|to form|on to) )*(?:a |one |the |single |straight |neat |horizontal |nice |"
        "letter )*(?:row|line)(?: of(?: the)?(?: [2-9])? (?:letter BLOCK|letters|BLOCK))?", "side by side",
        "one after (?:the other|another)", "next to (?:each other|one another)", "horizontally|across",
        "along the row",
    ),
    *patterns(
        "end", lambda match: (match["side"], glyphs(match["who"])),
        f"(?:(?:with|so|that|and|where|starting with|beginning with|then|so that) )*(?P<who>{_X}) (?:(?:BE|must|"
        "should|at|on|the|very|as) )*(?P<side>top|bottom|highest|lowest|uppermost|topmost)(?: (?:block|one|of "
        "it))?", f"(?P<side>top|bottom) (?:BE )?(?P<who>{_X})",
    ),
    *patterns(
        "end", lambda match: (match["side"], glyphs(match["who"])),
        f"(?:(?:with|so|that|and|where|starting with|beginning with|then|so that) )*(?P<who>{_X}) (?:(?:BE|must|"
        "should|at|on|the|very|far|as) )*(?P<side>left|right|leftmost|rightmost|first|last)(?: end| side| one| "
        "block)*",
    ),
    *patterns("upside", lambda match: glyphs(match["who"]),
        rf"(?:only )?(?P<who>{_X}) (?:(?:BE|must|should|has|turned|standing|placed) )*(?:upside down|on its head)"),
    *patterns(
        "tint", lambda match: (match["who"], match["color"]),
        f"(?P<who>{_XS}|{_CLASS}|{_ALL}) (?:both |all )?{_IS}(?P<color>COLOR)(?: BLOCK| ones?| body| colored)?(?! "
        f"{_LETTER})", f"(?:in )?(?P<color>COLOR) (?:for|on) (?P<who>{_XS}|{_CLASS})",
    ),
    *patterns(
        "tint", lambda match: (f"a {match['who']}" if match["article"] else match["who"], match["color"]),
        "(?:with |from )*(?:the |(?P<article>an? |one ))?(?P<color>COLOR) (?:letter )?(?P<who>(?:[A-Z]s?|'[A-Z]')|"
        "vowels?|consonants?)(?: BLOCK)?",
        f"(?:with )?(?:the |(?P<article>a ))?(?P<color>COLOR) (?P<who>(?:{_PART}) letter)",
    ),
    *patterns("tint", lambda match: (match["who"], match["color"], number(match["count"])),
        r"(?:the |with |from )*(?P<count>[2-9]) (?P<color>COLOR) (?P<who>[A-Z])s?(?: BLOCK)?"),
    *patterns("tint", lambda match: (match["who"], match["color"], number(match["count"])),
        rf"(?:the |with )*(?P<count>[2-9]) (?P<who>[A-Z])s?(?: blocks)? {_IS}(?P<color>COLOR)"),
    *patterns(
        "tint", lambda match: ("all", match["color"]),
        "(?:with|from|in|of|using|use|out of|by means of|by)?(?: the| only| all| just)* ?(?P<color>COLOR) "
        f"{_LETTER}", "(?:all )?(?:in|colored) (?P<color>COLOR)", "all (?P<color>COLOR)",
    ),
    *patterns(
        "count", lambda match: number(match["count"]), f"(?:the |using |with |from |of )*(?P<count>[2-9]) {_LETTER}",
    ),
    *patterns(
        "gaps", "The letters touch each other.",
        "(?:with |so that |and )*(?:all )?(?:of )?(?:the )?(?:neighboring |letters |BLOCK )*(?:BE )?(?:touching|"
        "touch)(?: (?:each other|one another))?",
        "(?:with |leaving |leave |and )?(?:no|zero) (?:gaps?|spaces?)(?: (?:between|in between)(?: (?:them|the "
        "letters|the BLOCK|letters|BLOCK))?)?",
        "without (?:any )?(?:gaps?|spaces?)(?: between (?:them|the BLOCK|the letters|letters))?",
    ),
    *patterns(
        "gaps", lambda match: _gaps(match),
        r"(?:with |leave |leaving |keep |keeping |at |and )*(?:a |gaps? of |spaces? of )*(?P<gap>[\d.]+) "
        "(?P<unit>cm|mm) (?:(?:gaps?|of space|spaces?|apart|between|in between|of air|each|the|neighbo(?:u)?rs|"
        f"them|neighboring|adjacent|{_LETTER}) ?)+(?<! )(?= )",
    ),
    *WISHES,
    *GLYPHS,
    *WHERE,
    *BREAKS,
    *GLUE,
    *patterns(
        "glue", None,
        "so that|such that|so|it|they|them|these|making|for making|forming|to make|standing|lying|appear|appears|"
        "runs?|made|shall",
    ),
    *patterns("glue", None, "(?:layout|orientation|arrangement|direction|figure|form|shape|style) :"),
    *patterns("tint", lambda match: ("all", match["color"]), "(?:the )?color(?: BE| :) (?P<color>COLOR)",
        f"(?:the )?color of (?:every|each|all|all the|the|its|all its) {_LETTER} BE (?P<color>COLOR)"),
    *patterns(
        "spell", None, "<=>|string|sequence|term|inscription|title|phrase|letter|letters|letter BLOCK|BLOCK with "
        "letters|word|name|text|tiles|lettered BLOCK",
        "spell|spells|spelled|spelt|spelling|write|writes|written|wrote|writing|read|reads|reading|say|says|saying|"
        "display|displays|displayed|print|prints|printed|type|typed|legible|readable|spell out|spelled out|(?:can|"
        "could|may|should) be read|can "
        "read",
    ),
    *patterns(
        "glue", None, "on|onto|one(?= (?:reads?|can|may|sees?) )|rearrange|rearranged|reorder|order|ordered|using",
        "(?:with|from|of|by) "
        "(?:letter )?(?:cube|block)",
        "for (?:me|us|my|our|the) (?:class|pupils|kids|children|students|son|daughter|lesson)|by means of|out|"
        "correctly|properly|in order|in (?:this|that|the right) order|upright|in capital letters|in capitals|"
        "single|vertical|horizontal",
    ),
]  # fmt: skip
_VERB = re.compile("spel|read|say|writ")
_WRITTEN = re.compile("writ|wrote|print|typed?$")
_ON_BLOCKS = re.compile("on(to)? (?!.*letter).*(block|cube|brick)s?$")
_NOUNS = frozenset({"word", "name", "text", "letters", "letter"})
_WORDS = frozenset({"word", "name", "text"})
_LETTERS_ALONE = re.compile("'?[A-Z]'?( ,)?( [A-Z]( ,)?)* [A-Z]")
_HAS_ONE = re.compile(r"\b(has|have) (a|an|one) .*(block|cube|brick|piece|tile|one)s?$")
_INITIALS = frozenset("ROYGCBPKWV")
"""First letters of colours."""
_ON = frozenset({"on", "onto", "on top of", "atop", "above", "over", "below", "under", "behind"})
_FIRST = frozenset({"top", "highest", "uppermost", "topmost", "left", "leftmost", "first"})


def _on_blocks(pieces: Sequence[Piece]) -> bool:
    """Whether something is on blocks of a colour that are not said to be letters."""
    said = [piece for piece in pieces if piece.words != "the"]
    return any(b.kind == "tint" and _ON_BLOCKS.match(f"{a.words} {b.words}") for a, b in pairwise(said))


def _gaps(match: re.Match[str]) -> str:
    """ "5 cm apart" is between centres, a gap is between faces."""
    apart = "apart" in match[0] and not re.search("gap|space|air|between", match[0])
    length = f"{match['gap']} {match['unit']}"
    return f"The blocks are {length} apart." if apart else f"The gaps are {length}."


def told(pieces: Sequence[Piece]) -> str:
    """The word in plain sentences.

    Raises:
        Unclear: there is none or several, or something that is told of it does not fit.
    """
    pieces = _by_letters(pieces)
    word, order, count, gaps, where = (one(pieces, kind) for kind in ("word", "order", "count", "gaps", "where"))
    kinds = {piece.kind for piece in pieces}
    at = [n for n, piece in enumerate(pieces) if piece.kind == "word"]
    if (
        len(at) != 1
        or not word
        or pieces[at[0] - 1].words in ("in", "of", "into")
        or pieces[0].words in ("is", "are", "it")
    ):
        raise Unclear
    if any(a.words == b.words == "." for a, b in pairwise(pieces)):
        raise Unclear  # a sentence was taken for talk: "the order does not matter" contradicts a word
    if where and any(piece.kind == "tint" and piece.words.startswith(("with", "using", "use")) for piece in pieces):
        raise Unclear  # "with red blocks on the mat", which are not those of the word
    if any(piece.kind == "tint" and _HAS_ONE.search(piece.words) for piece in pieces):
        raise Unclear  # "the first letter has a blue one", which lies on it
    single = [n for n, piece in enumerate(pieces) if piece.kind == "glyphs" and len(piece.value) == 1]
    if any(piece.words in _ON for n in single[:1] for piece in pieces[n : single[-1]]):
        raise Unclear  # "spell GO, the G on the O" tells where they are, and not only which they are
    if _on_blocks(pieces) and not any(_WRITTEN.match(piece.words) for piece in pieces):
        raise Unclear  # "the word CAT on red blocks": they could lie below its letters
    if (
        set(word.value) <= _INITIALS
        and "spell" not in kinds
        and not any(said in word.words for said in ("word", "name", "letters"))
    ):
        raise Unclear  # "an RGB tower"
    letters = sorted(glyph for piece in pieces if piece.kind == "glyphs" for glyph in piece.value)
    if (letters and letters != sorted(word.value)) or (count and count.value != len(word.value)):
        raise Unclear
    vertical = "tower" in kinds or order is not None
    if vertical and ("row" in kinds or gaps):
        raise Unclear
    way = order.value if order else ""
    for side, glyph in (piece.value for piece in pieces if piece.kind == "end"):
        if (side in ("left", "right", "leftmost", "rightmost")) is vertical:
            raise Unclear
        turned = way == "from bottom to top"
        if glyph != ((word.value[0] if (side in _FIRST) is not turned else word.value[-1]),):
            raise Unclear
    if vertical and word.value[0] != word.value[-1] and not way and "end" not in kinds:
        way = ""
    text = f"Spell {word.value}"
    text += f" in a tower{' ' if way else ''}{way}." if vertical else "."
    text += _tints(pieces, word.value)
    for piece in pieces:
        if piece.kind == "upside":
            if word.value.count(piece.value[0]) != 1:
                raise Unclear
            text += f" The {piece.value[0]} is upside down."
    text += f" {gaps.value}" if gaps else ""
    return text + (f" The word is {where.value}." if where else "")


def _by_letters(pieces: Sequence[Piece]) -> list[Piece]:
    """A word that is told letter by letter: "spell D, O, G"."""
    listed = [n for n, piece in enumerate(pieces) if piece.kind == "glyphs" and len(piece.value) > 1]
    spelt = any(_VERB.match(piece.words) for piece in pieces if piece.kind == "spell")
    before = pieces[listed[0] - 1].words if len(listed) == 1 else ""
    ahead = [piece for n, piece in enumerate(pieces) if not (before in _WORDS and n == listed[0] - 1)]
    named = any(piece.kind == "word" or piece.words in _NOUNS for piece in ahead)
    if (
        len(listed) != 1
        or not (spelt or before in _WORDS)
        or named
        or not _LETTERS_ALONE.fullmatch(pieces[listed[0]].words)
    ):
        return list(pieces)
    word = "".join(pieces[listed[0]].value)
    return [Piece("word", piece.words, word) if n == listed[0] else piece for n, piece in enumerate(pieces)]


def _tints(pieces: Sequence[Piece], word: str) -> str:
    """The colours of the letters, letter by letter.

    Raises:
        Unclear: letters that the word does not have, or a letter with two colours.
    """
    said = [piece.value for piece in pieces if piece.kind == "tint"]
    at: dict[int, str] = {}
    some: list[tuple[str, int, str]] = []
    for who, color, *count in sorted(said, key=lambda tint: _is_rest(tint[0])):
        places = _places(who, word, set(at))
        shown = {word[n] for n in places}
        many = count[0] if count else _MANY.get(who.split()[0], len(places))
        if not places or any(n in at for n in places) or many > len(places) or (some and _is_rest(who)):
            raise Unclear
        if many == len(places) and shown.isdisjoint(glyph for glyph, _, _ in some):
            at |= dict.fromkeys(places, color)
            continue
        glyph = min(shown)
        some.append((glyph, many, color))
        if len(shown) > 1 or sum(n for other, n, _ in some if other == glyph) > len(places):
            raise Unclear
    if len(at) == len(word) and len(set(at.values())) == 1:
        return f" The letters are {at[0]}."
    text = ""
    for glyph in dict.fromkeys(word):
        of = [n for n in range(len(word)) if word[n] == glyph]
        colors = {at.get(n) for n in of}
        if len(colors) > 1:
            raise Unclear
        color = colors.pop()
        if color:
            text += f" The {glyph} is {color}." if len(of) == 1 else f" The {glyph} blocks are {color}."
    for glyph, many, color in some:
        text += f" {many} of the {glyph} blocks {'is' if many == 1 else 'are'} {color}."
    return text


_MANY = {"a": 1, "an": 1, "one": 1, **{str(n): n for n in range(2, 10)}}
"""How many of the letters that look alike are told of."""


def _is_rest(who: str) -> bool:
    """Whether letters are told by what was told of the others."""
    return bool({"rest", "other", "others", "remaining"} & set(who.split()))


def _places(who: str, word: str, told_of: set[int]) -> set[int]:
    """The places in the word of the letters that are told."""
    words = [said.strip("'") for said in who.split()]
    every = set(range(len(word)))
    if _is_rest(who):
        return every - told_of
    if {"vowel", "vowels", "consonant", "consonants"} & set(words):
        vowels = {n for n in every if word[n] in "AEIOU"}
        return vowels if words[-1].startswith("vowel") else every - vowels
    parts = [said for said in words if said in _PART.split("|")]
    if parts:
        numbers = {
            "first": 0,
            "initial": 0,
            "second": 1,
            "third": 2,
            "fourth": 3,
            "fifth": 4,
            "last": len(word) - 1,
            "final": len(word) - 1,
        }
        middle = {len(word) // 2} if len(word) % 2 else set()
        return set.union(*(middle if part == "middle" else {numbers[part]} for part in parts)) & every
    words = [said[:1] if re.fullmatch("[A-Z]s", said) else said for said in words]
    named = [said for said in words if len(said) == 1 and said.isupper()]
    if not named:
        return every
    if not set(named) <= set(word):
        return set()
    return {n for n in every if word[n] in named}
