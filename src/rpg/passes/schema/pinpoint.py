"""Which part of a sentence is not understood, where its words are known and do not add up.

What would be read without the end of the sentence, or without its beginning, shows which part is to blame; what would
be read with more behind it, that it stops too early. Each try is a reading of its own: only a refusal is worth that.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from rpg.core.diagnostics import Diagnostic
from rpg.language.tokens import tokenize

_JOINTS = frozenset({
    "and", "but", "or", "so", "then", "while", "with", "without", "which", "that", "where", "whose", "as", "at", "by",
    "for", "from", "in", "into", "on", "onto", "to", "until", "before", "after", "except", "not", "also", "each", "all",
    "both", "none", "is", "are", "has", "have", "must", "should",
})  # fmt: skip
"""What a part of a sentence begins with."""
_MARKS = frozenset({",", ":", ";", "-", "–", "—", "("})
_SET_OFF = " ,:;-–—("
_ENDS = ".!?;"
_MORE = (" on the mat", " are on the mat", " the blue block are on the mat", " in a row")
"""With these a sentence that stopped too early says what should be done."""
_MOST = 12
"""So many parts are left out in turn."""
_LONGEST = 400
"""In longer texts (characters) no part is looked for."""
_SHOWN = 60
"""A longer part is not repeated."""


def pinpointed(text: str, found: Diagnostic, reads: Callable[[str], bool]) -> Diagnostic:
    """The diagnostic with the part of the sentence that is to blame. `reads`: whether a text is understood."""
    if found.span is None or found.code not in ("incomplete", "misplaced-word") or len(text) > _LONGEST:
        return found
    if found.code == "misplaced-word":
        return _around_the_word(text, found, found.span, reads)
    begin, end = found.span
    if any(reads(text[:end] + more) for more in _MORE):
        return found
    cuts = [*_cuts(text, begin, end)]
    for n in range(len(cuts) - 1, max(-1, len(cuts) - 1 - _MOST), -1):
        if reads(text[: cuts[n]].rstrip(_SET_OFF)):
            while n and text[cuts[n - 1] : cuts[n]].strip(_SET_OFF) in ("", *_JOINTS):
                n -= 1  # "..., but not on the mat": from the comma on
            return _blamed(text, found, (cuts[n], end), text[begin : cuts[n]])
    for cut in cuts[:_MOST]:
        if reads(text[:begin] + text[cut:end].lstrip(_SET_OFF)):
            return _blamed(text, found, (begin, cut), text[cut:end])
    message = "the words of this are known, but not what they mean together"
    return found.model_copy(update={"message": message, "hint": "say it in several short sentences"})


def _around_the_word(text: str, found: Diagnostic, word: tuple[int, int], reads: Callable[[str], bool]) -> Diagnostic:
    """The part of its sentence that a word stands in, where all that stands ahead of that part is understood."""
    begin = max(text.rfind(mark, 0, word[0]) for mark in _ENDS) + 1
    end = min((at for mark in _ENDS if (at := text.find(mark, word[1])) > 0), default=len(text))
    for cut in [*_cuts(text, begin, word[1])][: -_MOST - 1 : -1]:
        if reads(text[:cut].rstrip(_SET_OFF)):
            part = text[cut:end].strip(_SET_OFF)
            said = (
                f"say '{part}' in a sentence of its own" if len(part) <= _SHOWN else "say it in a sentence of its own"
            )
            return found.model_copy(update={"hint": f"{said}, or in other words; what stands before it is understood"})
    return found


def _blamed(text: str, found: Diagnostic, span: tuple[int, int], understood: str) -> Diagnostic:
    begin, end = span
    part = text[begin:end].strip(_SET_OFF)
    begin = text.index(part, begin)
    known = understood.strip(_SET_OFF)
    rest = f"the rest is understood: '{known}'" if len(known) <= _SHOWN else "the rest is understood"
    return found.model_copy(
        update={
            "message": f"{part!r} is not understood with the rest of this",
            "span": (begin, begin + len(part)),
            "hint": f"say it in a sentence of its own, or in other words; {rest}",
        }
    )


def _cuts(text: str, begin: int, end: int) -> Iterator[int]:
    """Where parts of a sentence begin."""
    for token in tokenize(text)[0]:
        if begin < token.span[0] < end and (token.word in _MARKS or token.word in _JOINTS):
            yield token.span[0]
