"""Amounts told by fingers and hands: "a finger's width between them" is about 2 cm, "a hand's width" about 10 cm."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.tokens import Token

_WIDTHS = {"finger": 2, "fingers": 2, "thumb": 2, "thumbs": 2, "hand": 10, "hands": 10, "palm": 10, "palms": 10}
"""In centimetres."""
_WIDE = frozenset({"width", "widths", "breadth", "breadths", "thickness", "wide"})
_ALONE = frozenset({"finger", "fingers"})
"""These are amounts by themselves, behind a number: "two fingers apart"."""
_BOUNDS = frozenset({"about", "roughly", "approximately", "at", "least", "most", "more", "less", "than"})
_TO_IT = (["from"], ["to"], ["left"], ["right"], ["behind"], ["in"])
_GAP = ("with", "a", "gap", "of")
"""What is apart by a finger is so from face to face."""


def in_centimetres(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with centimetres for such amounts, and notes of them."""
    out: list[Token] = []
    notes: list[str] = []
    at = 0
    while at < len(tokens):
        end, wide = _amount(tokens, at)
        if end == at:
            out.append(tokens[at])
            at += 1
            continue
        begin = next(n for n in range(len(out), -1, -1) if n == 0 or out[n - 1].word not in _BOUNDS)
        bounds = out[begin:] or [tokens[at].saying("about")]
        behind = [token.word for token in tokens[end : end + 2]]
        apart, away = behind[:1] == ["apart"], behind == ["away", "from"] or behind[:1] in _TO_IT
        gap = [tokens[at].saying(word) for word in _GAP] if apart or away else []
        number = f"{wide:g}"
        length = [replace(tokens[at], kind="number", word=number, raw=number, value=wide), tokens[at].saying("cm")]
        between = [tokens[at].saying(word) for word in ("between", "them")] if apart else []
        out[begin:] = [*gap, *bounds, *length, *between]
        said = " ".join(token.raw for token in tokens[at:end]).replace(" '", "'")
        notes.append(f"'{said}' is taken for about {number} cm{' between the faces' if gap else ''}")
        at = end + (apart or behind == ["away", "from"])
    return out, notes


def _amount(tokens: list[Token], at: int) -> tuple[int, float]:
    """The position behind "a finger's width", and how wide that is; `at` where none begins."""
    words = [token.word for token in tokens[at : at + 5]]
    many = 1 if words[0] == "a" else tokens[at].many
    part = words[1] if len(words) > 1 else ""
    if not many or part not in _WIDTHS:
        return at, 0.0
    end = 2 + (words[2:3] in (["'s"], ["'"]))
    if words[end : end + 1] and words[end] in _WIDE:
        return at + end + 1, float(many * _WIDTHS[part])
    counted = part in _ALONE and end == 2 and words[2:3] not in (["to"], ["on"])
    return (at + 2, float(many * _WIDTHS[part])) if counted else (at, 0.0)
