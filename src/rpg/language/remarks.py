"""Remarks with words that mean nothing here: "in a row on the red mat, like taxis", "(which always gets lost)".

A comparison says once more what is told in plain words; a sentence with nothing of blocks, patches and places asks for
nothing. Both are left out, with a note; where a comparison may be all that tells of a shape, it stays to be asked for.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from rpg.core.diagnostics import Diagnostic
from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_ENDS = frozenset({".", "!", "?", ";", "…"})
_BREAKS = _ENDS | {",", ":", "(", ")", "-"}
_LIKE = (("like",), ("just", "like"), ("a", "bit", "like"), ("sort", "of", "like"), ("kind", "of", "like"),
         ("as", "in"), ("as", "on"), ("as", "if"), ("as", "though"), ("looking", "like"),
         ("similar", "to"), ("resembling",),
         *((*just, "as", who, *would) for just in ((), ("just",), ("exactly",))
           for who in ("one", "you", "we", "people", "they", "i") for would in (("would",), ("do",), ("might",), ())
           if would or who != "one"),
         *(("so", *that, who, *look, "like") for that in (("that",), ()) for who in ("it", "they", "this")
           for look in (("looks",), ("look",), ("looks", "a", "bit"), ("will", "look"))))  # fmt: skip
"""What leads to something that it is compared with."""
_TELLING: tuple[Collection[str], ...] = (
    lexicon.COLOR, lexicon.COLOR_PLURAL, lexicon.BLOCK, lexicon.PATCH, lexicon.STRUCTURE, lexicon.NUMBER,
    lexicon.ORDINAL, lexicon.LETTER, lexicon.DIGIT, lexicon.SYMBOL, lexicon.SIZE,
    frozenset({
        "left", "right", "top", "bottom", "middle", "center", "front", "back", "behind", "order", "first", "last",
        "not", "no", "never", "without", "none", "upside", "reversed", "reverse", "touching", "apart", "each", "every",
    }),
)  # fmt: skip
"""What tells of the task, wherever it stands."""
_OF_THE_REST = frozenset({
    "it", "they", "them", "this", "that", "these", "those", "its", "their", "others", "other", "rest", "same", "all",
    "both", "everything", "one", "ones", "must", "should", "shall", "on", "onto", "under", "above", "below", "beside",
    "next", "between", "near", "in", "at", "until", "unless", "if",
})  # fmt: skip
"""What may speak of blocks that were told of before, in a sentence of its own."""
_ASKING = frozenset(
    word for word, forms in lexicon.VERB.items() if any(form == "base" for _, _, form in forms)
) - {"let", "show"}  # fmt: skip


def without_remarks(tokens: list[Token], unknown: Sequence[Diagnostic]) -> tuple[list[Token], list[str]] | None:
    """The tokens without such remarks and notes of them; None where an unknown word stands elsewhere."""
    strange = {one.span for one in unknown}
    gone: set[int] = set()
    notes: list[str] = []
    for begin, end in (*_comparisons(tokens), *_in_brackets(tokens), *_sentences(tokens)):
        if gone.isdisjoint(range(begin, end)) and any(token.span in strange for token in tokens[begin:end]):
            told = [t for t in tokens[begin:end] if t.word not in _BREAKS]
            notes.append(f"left out, for it asks for nothing: '{' '.join(t.raw for t in told)}'")
            gone.update(range(begin, end))
    rest = [token for n, token in enumerate(tokens) if n not in gone]
    if any(token.span in strange for token in rest) or not any(map(_tells, rest)):
        return None
    return _closed(rest), notes


def _comparisons(tokens: list[Token]) -> Iterator[tuple[int, int]]:
    """Where "like taxis" stands, with the comma that sets it off."""
    words = [token.word for token in tokens]
    plain = any(w in lexicon.STRUCTURE or w in _STACKED or t.kind == "dims" for w, t in zip(words, tokens, strict=True))
    if not plain and any(lexicon.BLOCK.get(word) for word in words):
        return
    for at in range(len(words)):
        lead = length_at(words, at, _LIKE)
        end = _break(words, at)
        if lead and end > at + lead and not any(map(_tells, tokens[at + lead : end])):
            opened = at == 0 or words[at - 1] in _BREAKS
            set_off = at > 0 and words[at - 1] in (",", "-")
            yield at - set_off, end + (opened and not set_off and end < len(words))


_STACKED = frozenset({"stack", "stacked", "stacking", "line", "lined"})


def _in_brackets(tokens: list[Token]) -> Iterator[tuple[int, int]]:
    """Where "(which always gets lost)" stands."""
    for at in (n for n, token in enumerate(tokens) if token.word == "("):
        end = next((n for n in range(at, len(tokens)) if tokens[n].word == ")"), at)
        if end > at + 1 and not any(map(_tells, tokens[at + 1 : end])):
            yield at, end + 1


def _sentences(tokens: list[Token]) -> Iterator[tuple[int, int]]:
    """Where sentences stand in which nothing tells of the task."""
    begin = 0
    for end in [*(n for n, token in enumerate(tokens) if token.word in _ENDS), len(tokens)]:
        said = tokens[begin:end]
        if said and said[0].word not in _ASKING and not any(t.word in _OF_THE_REST or _tells(t) for t in said):
            yield begin, min(end + 1, len(tokens))
        begin = end + 1


def _tells(token: Token) -> bool:
    shown = token.kind in ("number", "dims", "literal", "quote") or (len(token.raw) == 1 and token.raw.isupper())
    return (shown and token.word != "a") or any(token.word in table for table in _TELLING)


def _break(words: list[str], at: int) -> int:
    return next((n for n in range(at, len(words)) if words[n] in _BREAKS), len(words))


def _closed(tokens: list[Token]) -> list[Token]:
    """The tokens without breaks that set off nothing any more."""
    out: list[Token] = []
    for token in tokens:
        if token.word in _BREAKS - {"(", "-"} and (not out or out[-1].word in _BREAKS - {")"}):
            if out and token.word in _ENDS:
                out[-1] = token
            continue
        out.append(token)
    return out
