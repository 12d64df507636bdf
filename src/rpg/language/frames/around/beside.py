"""Distractors that are told in the middle of something else: taken out, and told in a sentence of their own."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from rpg.language import lexicon
from rpg.language.frames.pieces import coded, joined, patterns
from rpg.language.tokens import Token

_ITEM = (
    "(?:(?:a|an|NUM|some) )?(?:(?:other|extra|further|more|additional|single) )?(?:SIZE )?COLOR(?: (?:letter "
    ")?BLOCK)?|"
    "(?:(?:a|an|the) )?(?:letters? |digits? |numbers? )?(?:BLOCK )?(?:[A-Z]|\\d)(?: BLOCK)?"
)
_ITEMS = f"(?P<items>(?:{_ITEM})(?:(?: ,)?(?: and)? (?:{_ITEM}))*)"
_COUNTED = "(?:a|an|NUM) (?:SIZE )?COLOR"
_D = "(?:distractors?|distraction|decoys?)"
_LEAD = (
    r"(?:(?:[,;.:]|and|with|plus|amid|among|also|please|now|but|besides|additionally|in addition|furthermore|"
    r"there (?:is|are|should be|must be|shall be)(?: also)?|add|include|spawn|scatter|have|put|place|set|drop|i "
    r"want|we have|"
    r"in the scene|on the TABLE) )*"
)
_TAIL = (
    r"(?: (?:somewhere|anywhere|lying|lies|lie|stands|stand|standing|placed|scattered|around|about|on the TABLE|in "
    r"the scene|too|as well|"
    r"(?:that|which) (?:play|plays|have|has) no (?:role|part|function|meaning)|"
    r"(?:that|which) (?:have|has) nothing to do with (?:it|this|the task)|to (?:be )?ignored?|"
    r"(?:and|but|that|which) (?:must|should|may|shall|are|is) not (?:to )?be (?:touched|moved|disturbed)))*"
)
TOLD = [
    *patterns("items", None,
        rf"{_LEAD}{_ITEMS}{_TAIL} (?:(?:serving|acting|there|just|only|merely) )*(?:as|for) (?:(?:a|the|mere) "
        rf")?{_D}{_TAIL}",
        rf"{_LEAD}(?:the )?{_D}(?: (?:is|are))? : {_ITEMS}{_TAIL}",
        rf"{_LEAD}(?:(?:a|an|NUM|some) )?{_D} : {_ITEMS}{_TAIL}",
        rf"{_LEAD}(?:as|for) (?:(?:a|the|mere) )?{_D}(?: :| ,)?(?: there (?:is|are))?(?: also)? {_ITEMS}{_TAIL}"),
    *patterns("count", None,
        rf"{_LEAD}(?P<items>{_COUNTED}(?:(?: ,)?(?: and)? {_COUNTED})*) {_D}(?: BLOCK)?{_TAIL}",
        rf"(?:[,;.] )?(?:and )?(?:(?:with|plus|amid|among|add|include|also|spawn|there (?:is|are)) )+"
        rf"(?P<items>(?:a|an|NUM)) {_D}(?: BLOCK)?{_TAIL}"),
]  # fmt: skip
_ENDS = frozenset({".", "!", "?", ";", ","})
_LINKS = frozenset({"with", "and", "but", "while", "where"})


def without_distractors(tokens: Sequence[Token]) -> Iterator[tuple[list[Token], list[Token], str]]:
    """The text without the one stretch of it that tells of distractors; that stretch, and what it says."""
    words = coded(tokens)
    text, places = joined(words)
    if "distract" not in text and "decoy" not in text:
        return
    for n, at in enumerate(places[:-1]):
        ends = [match for pattern in TOLD if (match := pattern.expression.match(text, at)) and match.end() in places]
        if not ends:
            continue
        match = max(ends, key=lambda found: found.end())
        m = places.index(match.end())
        if words[m : m + 1] and (words[m] in _MORE or _named(words, m)):
            return  # "a distractor block in black", "two distractors, one green and one yellow"
        rest = [*stopped(tokens[:n], tokens[n]), *stopped(tokens[m:], tokens[n])]
        if sum("distract" in word or "decoy" in word for word in words) == sum(
            "distract" in word or "decoy" in word for word in words[n:m]
        ):
            items = match["items"].strip()
            last = items.split()[-1]
            bare = last in lexicon.COLORS or last in _ONE or (last.isdigit() and last == items)
            noun = (" block" if items.split()[0] in _ONE else " blocks") if bare else ""
            said = f"There are also {items}{noun} as distractors."
            if re.search(r"not (?:to )?be (?:touched|moved|disturbed)", match[0]):
                if not re.match(r"(?:an?|one|1) ", items):
                    return
                known = re.sub(r"\b(?:an?|one|1) ", "the ", f"{items}{noun}")
                stays = "they are" if " and " in items else "it is"
                said = f"There are also {items}{noun}. {known.capitalize()} must stay where {stays}."
            yield rest, list(tokens[n:m]), said
        return


def _named(words: Sequence[str], at: int) -> bool:
    """Whether it is told behind a mark what they look like."""
    return words[at] in (",", "(") and (words[at + 1 : at + 2] or [""])[0] in _ONE | lexicon.NUMBER.keys()


def stopped(tokens: Sequence[Token], mark: Token) -> list[Token]:
    """Words with a full stop behind them, and no marks around them."""
    begin = next((n for n, token in enumerate(tokens) if token.word not in _ENDS | _LINKS), len(tokens))
    end = next((n for n in range(len(tokens), begin, -1) if tokens[n - 1].word not in _ENDS | _LINKS), begin)
    return [*tokens[begin:end], mark.saying(".")] if begin < end else []


_MORE = frozenset({
    "in", "of", "letter", "letters", "digit", "digits", "number", "numbers", "symbol", "symbols", "that", "which",
})  # fmt: skip
"""Behind these more is said of the distractors."""
_ONE = frozenset({"a", "an", "one", "1"})
