"""A text cut into pieces, each one part of what may be said of a figure; no word is passed over."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import accumulate
from typing import Any

from rpg.language import lexicon
from rpg.language.tokens import Token


class Unclear(Exception):
    """The pieces do not tell of one figure, or not of all of it."""


@dataclass(frozen=True)
class Piece:
    """A part of what is said: `words` as `coded`, `value` what the pattern says of it, `named` groups of its words."""

    kind: str
    words: str
    value: Any = None
    named: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Pattern:
    """A way to say a part. `text`: a regular expression over words with a space behind each, and names of classes;
    `value`: what it says, or how that is found from the match."""

    kind: str
    text: str
    value: Any = None

    def says(self, match: re.Match[str]) -> Any:
        """What is said by the words of a match."""
        return self.value(match) if callable(self.value) else self.value

    @cached_property
    def expression(self) -> re.Pattern[str]:
        """The expression, compiled where it is first looked for: most texts need none of them."""
        text = _PLAIN.sub(_longest_first, self.text)
        for name, words in CLASSES.items():
            text = re.sub(rf"\b{name}\b", f"(?:{words})".replace("\\", r"\\"), text)
        return re.compile(f"(?:{text}) ")


CLASSES = {
    "COLOR": "|".join(lexicon.COLORS),
    "NUM": r"\d+|one|single|lone",
    "SIZE": "|".join(word for word, size in lexicon.SIZE.items() if size != "medium"),
    "BLOCK": "blocks?|cubes?|pieces?|elements?|tiles?",
    "PATCH": "|".join(lexicon.PATCH_NOUNS.split()),
    "TABLE": "|".join(lexicon.TABLE_NOUNS.split()),
    "BE": "(?:(?:that|which) )?(?:must be|should be|has to be|have to be|will be|shall be|needs to be|to be|is|are|"
    "being|"
    "be|(?:must |should |shall |has to |have to )?(?:go|come|sit|stand|lie|rest|belong)|goes|comes|sits|stands|lies|"
    "rests|belongs|going|sitting|standing|lying|resting)",
}
"""Names of classes of words, in patterns."""


_PLAIN = re.compile(
    r"(?<=\(\?:)[\w ,']+(?:\|[\w ,']+)+(?=\))|(?<=>)[\w ,']+(?:\|[\w ,']+)+(?=\))|^[\w ,']+(?:\|[\w ,']+)+$"
)


def _longest_first(match: re.Match[str]) -> str:
    """Alternatives so that "lay out" is tried before "lay", which is the same up to there."""
    return "|".join(sorted(match[0].split("|"), key=len, reverse=True))


def patterns(kind: str, value: Any, *texts: str) -> list[Pattern]:
    """Patterns of one kind that say the same."""
    return [Pattern(kind, text, value) for text in texts]


def number(said: str) -> int:
    """The number that a word of the class NUM says, or how many times."""
    return int(said) if said.isdigit() else 2 if said == "twice" else lexicon.NUMBER.get(said, 1)


def numbers(*names: str) -> Callable[[re.Match[str]], dict[str, int]]:
    """The numbers that named groups say, by their names."""
    return lambda match: {name: number(match[name]) for name in names}


_BEHIND_SYMBOL = frozenset(
    {
        ",",
        "x",
        "and",
        "on",
        "over",
        "under",
        "above",
        "below",
        "beside",
        "goes",
        "must",
        "should",
        "with",
        "at",
        "in",
        "is",
    }
)
"""Before these an A is no article."""
_SEVERAL = re.compile("[A-Z]s")
_AHEAD = frozenset({"both", "all", "the", *lexicon.COLORS})
"""Behind these and numbers "As" and "Is" are letters."""
_SPELLING = frozenset(
    {
        "say",
        "says",
        "spell",
        "spells",
        "spelled",
        "spelt",
        "spelling",
        "wrote",
        "written",
        "writing",
        "string",
        "read",
        "reads",
        "write",
        "word",
        "name",
        "saying",
        "reading",
    }
)
"""Behind these, words in capitals are to be spelt, whatever they mean."""


def coded(tokens: Sequence[Token]) -> list[str]:
    """Each token as one word that patterns know: numbers in digits, colours by their names ("reds" where several are
    meant), symbols in capitals, words to be spelt in quotation marks, signs and equations in angle brackets;
    `<other>` for what has no such word."""
    return [_code(tokens, n) for n in range(len(tokens))]


def _code(tokens: Sequence[Token], n: int) -> str:
    token = tokens[n]
    word = token.word
    if token.kind in ("literal", "quote"):
        return f"'{str(token.value).upper()}'" if str(token.value).isalnum() else "<other>"
    if token.kind == "dims" and isinstance(token.value, tuple):
        return "x".join(map(str, token.value))
    if token.kind == "number" and isinstance(token.value, float):
        return f"{token.value:g}"
    if token.kind == "punct":
        return word
    if token.kind in ("sign", "equation"):
        return f"<{token.value or word}>"
    if token.kind != "word" or " " in word:
        return "<other>"
    if len(token.raw) > 1 and token.raw.isupper() and token.raw.isalpha() and n and tokens[n - 1].word in _SPELLING:
        return f"'{token.raw}'"
    if len(token.raw) > 1 and token.raw.isupper() and n and tokens[n - 1].kind in ("literal", "quote"):
        return f"'{token.raw}'"  # "spell THANK YOU"
    begins = n == 0 or tokens[n - 1].word in (".", "!", "?", ";", ":")
    before = _code(tokens, n - 1) if _SEVERAL.fullmatch(token.raw) and n else ""
    behind = tokens[n + 1].word if n + 1 < len(tokens) else ""
    listed = [word.raw for word in tokens[n + 1 : n + 3] if len(word.raw) == 1 and word.raw.isupper()]
    begins = begins and not (token.raw == "A" and (behind in _BEHIND_SYMBOL or len(listed) == 2))
    if len(token.raw) == 1 and token.raw.isupper() and not (begins and token.raw in "AI"):
        return token.raw
    if _SEVERAL.fullmatch(token.raw) and (token.raw[0] not in "AIU" or before.isdigit() or before in _AHEAD):
        return token.raw  # "two Es"
    if word != "one" and word in lexicon.NUMBER:
        letters = n + 1 < len(tokens) and len(tokens[n + 1].raw) == 1 and tokens[n + 1].raw.isupper()
        return word if letters else str(lexicon.NUMBER[word])  # "two A" are no 2 and an A
    many = lexicon.COLOR_PLURAL.get(word)
    return f"{many}s" if many else lexicon.COLOR.get(word, word)


def joined(words: Sequence[str]) -> tuple[str, list[int]]:
    """Words as patterns meet them, a space behind each; and where each of them begins, and the last one ends."""
    return "".join(f"{word} " for word in words), [*accumulate((len(word) + 1 for word in words), initial=0)]


def cut(words: Sequence[str], told: Sequence[Pattern]) -> list[Piece] | None:
    """The pieces of a text that is `coded`, at each place the longest one that stands there; None where a word belongs
    to none."""
    text, _ = joined(words)
    found: list[Piece] = []
    at = 0
    while at < len(text):
        matches = [(match.end(), -n, match) for n, p in enumerate(told) if (match := p.expression.match(text, at))]
        if not matches:
            return None
        end, n, match = max(matches, key=lambda item: item[:2])
        pattern = told[-n]
        named = {name: said.strip() for name, said in match.groupdict().items() if said}
        found.append(Piece(pattern.kind, text[at:end].strip(), pattern.says(match), named))
        at = end
    return found
