"""Short turns of phrase: "into the gap between" is between, "make 12 with the digit cubes" is the number 12."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_GAPS = frozenset({"gap", "space", "room"})
_INTO = frozenset({"in", "into", "inside"})
_ANYWHERE = frozenset({"anywhere", "somewhere"})
_MAKING = frozenset({"make", "build", "form", "show", "write", "lay"})
_OUT_OF = frozenset({"with", "from", "using", "out"})
_DIGITS = frozenset({"digit", "digits", "number", "numbers"})
_TWO_DIGITS = 10
_NONE_ELSE = frozenset({"of", "them", "the", "these"})


def between_them(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Into the gap between the two blue ones": between them."""
    for at in range(1, len(words) - 3):
        gap = words[at + 1] in ("the", "a") and words[at + 2] in _GAPS and words[at + 3] == "between"
        if gap and words[at] in _INTO:
            return [*tokens[:at], *tokens[at + 3 :]]
    return None


def without_stacking(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Without stacking any of them": without stacking them."""
    for at in range(1, len(words) - 2):
        if words[at : at + 3] == ["without", "stacking", "any"]:
            end = at + 3
            while end < len(words) and (words[end] in _NONE_ELSE or words[end] in lexicon.BLOCK):
                end += 1
            return [*tokens[: at + 2], tokens[at + 2].saying("them"), *tokens[end:]]
    return None


def without_letting(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Without letting them touch": without them touching."""
    for at in range(1, len(words) - 3):
        if words[at] != "without" or words[at + 1] not in LETTING:
            continue
        touch = next((n for n in range(at + 2, min(at + 8, len(words))) if words[n] in ("touch", "touching")), 0)
        if touch:
            begin = touch - (words[touch - 1] == "to")
            return [*tokens[: at + 1], *tokens[at + 2 : begin], tokens[touch].saying("touching"), *tokens[touch + 1 :]]
    return None


LETTING = frozenset({"letting", "having", "allowing", "making"})


_FLAT = ("lie", "lying", "laid", "lay")
_NOT_STACKED = (("not", "stacked"), ("no", "stacking"), ("no", "stack"), ("no", "stacks"), ("no", "piling"),
                ("without", "stacking"), ("without", "any", "stacking"),
                *((*lead, lie, "flat") for lead in (("just",), ("only",), ("must",), ("they", "must"), ("should",),
                                                    ("they", "should"), ("they", "just"), ("they",), ())
                  for lie in _FLAT))  # fmt: skip


def not_stacked(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "(All three on the mat,) not stacked", "no stacking", "they must lie flat": without stacking them."""
    for at in range(1, len(words) - 1):
        end = at + length_at(words, at, _NOT_STACKED)
        ends = end == len(words) or words[end] in (".", ",", "!", ";", "and", "please")
        set_off = words[at - 1] in (",", "but") or words[at - 1] in lexicon.PATCH
        if end > at and ends and set_off and not (words[end - 1] == "flat" and _upright(words[:at])):
            said = [tokens[at].saying(word) for word in ("without", "stacking", "them")]
            return [*tokens[: at - (words[at - 1] == "but")], *said, *tokens[end:]]
    return None


def _upright(words: list[str]) -> bool:
    """Whether it may be a figure that lies flat, and does not stand."""
    return not {"letter", "shape", "wall", "pyramid", "triangle", "grid", "square", "staircase"}.isdisjoint(words)


def anywhere_but(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Anywhere, but not on the mat": anywhere but on it."""
    for at in range(2, len(words) - 2):
        comma = words[at + 1] == ","
        if words[at] in _ANYWHERE and words[at + 1 + comma : at + 4 + comma] == ["but", "not", "on"]:
            but = tokens[at + 1 + comma]
            return [*tokens[:at], tokens[at].saying("anywhere"), but, *tokens[at + 3 + comma :]]
    return None


def number_made(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Make 12 with the digit cubes": make the number 12."""
    for at in range(len(words) - 3):
        value = tokens[at + 1].value if tokens[at + 1].kind == "number" else None
        several = isinstance(value, float) and value >= _TWO_DIGITS and value.is_integer()
        if words[at] in _MAKING and several and words[at + 2] in _OUT_OF and not _DIGITS.isdisjoint(words[at + 3 :]):
            number = [tokens[at + 1].saying(word) for word in ("the", "number")]
            return [*tokens[: at + 1], *number, *tokens[at + 1 :]]
    return None


_TURNS = frozenset({"turn", "rotate", "spin", "flip", "twist"})


def turned_in_place(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Turn the E upside down on the spot": in place, where a patch is not called a spot besides."""
    for at in range(2, len(words) - 2):
        if words[at : at + 3] == ["on", "the", "spot"]:
            done = next((word for word in reversed(words[:at]) if word in lexicon.VERB), "")
            named = not {*words[at + 3 : at + 4]} <= {",", ".", "and", "!", ";", "by", "upside"}
            if done in _TURNS and not named and words.count("spot") == 1:
                return [*tokens[:at], tokens[at].saying("in"), tokens[at + 2].saying("place"), *tokens[at + 3 :]]
    return None


def center_of_patch(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The yellow patch's center": the center of the yellow patch."""
    for at in (n for n in range(2, len(words) - 1) if words[n] == "'s" and words[n + 1] in ("center", "middle")):
        begin = at - 1
        while begin > 0 and words[begin - 1] in lexicon.COLOR:
            begin -= 1
        if words[at - 1] in lexicon.PATCH and begin and words[begin - 1] == "the":
            center = [tokens[begin - 1], tokens[at + 1], tokens[at].saying("of"), tokens[begin - 1].saying("the")]
            return [*tokens[: begin - 1], *center, *tokens[begin:at], *tokens[at + 2 :]]
    return None
