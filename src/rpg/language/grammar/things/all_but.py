""" "All gray except the top one, which is orange": the top one orange and the others gray, as it is said elsewhere."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.tokens import Token

_EXCEPT = (("with", "the", "exception", "of"), ("except", "for"), ("apart", "from"), ("save", "for"), ("but", "for"),
           ("other", "than"), ("except",), ("but",), ("save",), ("besides",))  # fmt: skip
_PLACES = frozenset({"top", "bottom", "middle", "first", "last", "second", "third", "fourth", "fifth", "left", "right",
                     "leftmost", "rightmost", "center", "lowest", "highest", "topmost", "uppermost", "lowermost",
                     "front", "back", "upper", "lower", "end", "ends", "outer", "inner", "central",
                     "bottommost"})  # fmt: skip
_IN = frozenset({"with", "in", "using"})
_OF_THEM = frozenset({"letters", "of", "them", "the", "these", "blocks", "cubes", "bricks", "are", "is", "in", "being",
                      "should", "must", "be", "shall"})  # fmt: skip
_IS = frozenset({",", "which", "that", "it", "is", "are", "being", "should", "must", "be", "in", "shall"})
_ONES = frozenset({"one", "ones", "block", "blocks", "cube", "cubes", "brick", "bricks"})
_FEW = frozenset({"a", "an", "one", "two", "three", "exactly", "single", "just"})
_THEY = frozenset({"they", "these"})
_WHOLES = frozenset({"one", "other"})
"""Ahead of "all blue except for a green one" these are one of several figures."""
_PART = 12
"""So many words name a part at most: "the second one from the left"."""


def exceptions_first(tokens: list[Token]) -> list[Token]:
    """The tokens with such exceptions told as two parts."""
    tokens = _behind_all(_told_last(tokens))
    for start, token in enumerate(tokens):
        if token.word in _IN and (told := _but_one_letter(tokens, start)) is not None:
            return told
        whole = start > 0 and tokens[start - 1].word in _WHOLES
        if token.word == "all" and not whole and (found := _at(tokens, start)) is not None:
            part, end, color, other = found
            rest = [_word(word, tokens[start]) for word in ("and", "the", "others")]
            said = [*part, replace(other, kind="word"), *rest, color]
            lead = tokens[:start]
            they = [t.word for t in lead[-3:]]
            if they[-1:] == ["are"] and they[-2] in _THEY:
                lead = lead[:-2]
            elif they[-1:] == ["be"] and they[0] in _THEY:
                lead = lead[:-3]
            return [*lead, *said, *tokens[end:]]
    return tokens


_STOPS = frozenset({".", "!", "?", ";"})
_EVERY = frozenset({"all", "every", "everything", "each"})
_OTHERWISE = (("but",), ("besides",))
"""In front of a sentence these say something else."""


def _told_last(tokens: list[Token]) -> list[Token]:
    """ "Except for the red one, which stays off it, all go on the mat": what is told of the exception comes last, where
    it stands ahead of all the others or of what "it" is."""
    words = [t.word for t in tokens]
    which = next((n for n in range(3, len(words)) if words[n] == "which" and words[n - 1] == ","), 0)
    leads = (x for x in _EXCEPT if x not in _OTHERWISE) if which else ()
    found = ((n, n + len(x)) for x in leads for n in range(which) if tuple(words[n : n + len(x)]) == x)
    start, named = max(found, default=(0, 0))
    comma = next((n for n in range(which, len(words)) if words[n] in _STOPS | {","}), 0)
    if not named or words[named] != "the" or "," in words[named : which - 1] or not comma or words[comma] != ",":
        return tokens
    first = start == 0 or words[start - 1] in _STOPS
    if not first and "it" not in words[which:comma]:
        return tokens
    stop = next((n for n in range(comma, len(words)) if words[n] in _STOPS), len(words))
    one, told = tokens[named : which - 1], tokens[which + 1 : comma]
    kept = [*tokens[: which - 1], *tokens[comma + (not first) : stop]]
    return [*kept, replace(tokens[comma], word=";", raw=";"), *one, *told, *tokens[stop:]]


def _behind_all(tokens: list[Token]) -> list[Token]:
    """ "Except for the red one, all blocks go ...": the exception behind what it is one to."""
    words = [t.word for t in tokens]
    for start in (n for n in range(len(words)) if n == 0 or words[n - 1] in _STOPS):
        lead = next((x for x in _EXCEPT if x not in _OTHERWISE and tuple(words[start : start + len(x)]) == x), None)
        comma = next((n for n in range(start, len(words)) if words[n] in _STOPS | {","}), 0) if lead else 0
        every = next((n for n in range(comma, len(words)) if words[n] in _STOPS | _EVERY), 0) if comma else 0
        if not every or words[comma] != "," or words[every] in _STOPS:
            continue
        end = every + 1 + (words[every + 1 : every + 2] == ["the"])
        others = words[end : end + 1] in (["other"], ["others"])
        after = end + others
        after += after < len(words) and words[after] in lexicon.COLOR
        after += after < len(words) and words[after] in lexicon.BLOCK
        head = [*tokens[comma + 1 : end], *tokens[end + others : after]]
        return [*tokens[:start], *head, *tokens[start:comma], *tokens[after:]]
    return tokens


def _but_one_letter(tokens: list[Token], start: int) -> list[Token] | None:
    """ "(spell SEA) with blue cubes except for the E, which is white": with the E white and the others blue."""
    words = [t.word for t in tokens]
    if words[start + 1 : start + 2] == [] or words[start + 1] not in lexicon.COLOR:
        return None
    every = [replace(tokens[start], word="all", raw="all"), *tokens[start + 1 :]]
    named = [t for n, t in enumerate(every) if not (n in (2, 3) and t.word in _SHOWN)]
    found = _at(named, 0)
    if found is None or len(found[0]) != 2 or len(found[0][1].raw) != 1:
        return None
    part, end, color, other = found
    rest = [_word(word, tokens[start]) for word in ("and", "the", "others")]
    return [*tokens[:start], _word("with", tokens[start]), *part, other, *rest, color, *named[end:]]


_SHOWN = frozenset({"letter", "letters", "cubes", "blocks", "bodies", "cube", "block", "bricks"})


def _at(tokens: list[Token], start: int) -> tuple[list[Token], int, Token, Token] | None:
    """The words for the part, the position behind it all, the colour of all, and that of the part."""
    words = [t.word for t in tokens]
    at = start + 1
    while at < len(words) and words[at] in _OF_THEM:
        at += 1
    if at >= len(words) or words[at] not in lexicon.COLOR:
        return None
    color = tokens[at]
    at += 1
    at += words[at : at + 1] == ["ones"] or (words[at : at + 1] != [] and words[at] in lexicon.BLOCK)
    at += words[at : at + 1] == [","]
    lead = next((x for x in _EXCEPT if tuple(words[at : at + len(x)]) == x), None)
    if lead is None:
        return None
    begun = at + len(lead)
    end = next((n for n in range(begun, min(begun + _PART, len(words))) if words[n] in lexicon.COLOR), 0)
    if not end:
        return None
    told = begun + next((n for n, word in enumerate(words[begun:end]) if word in _IS and n), end - begun)
    if words[begun] == "the":
        lettered = told == begun + 2 and len(tokens[begun + 1].raw) == 1 and tokens[begun + 1].raw.isupper()
        fits = (lettered or bool(_PLACES & {*words[begun:told]})) and all(word in _IS for word in words[told:end])
        fits = fits and lexicon.COLOR[words[end]] != lexicon.COLOR[color.word]
    else:
        fits = told > begun and all(word in _FEW for word in words[begun:told])
        fits = fits and all(word in _IS for word in words[told:end])
    after = end + 1
    after += words[after : after + 1] != [] and words[after] in _ONES
    if fits and _SINGLE.issuperset(words[begun:end]) and (place := _placed(words, after)):
        part = [_word(word, tokens[begun]) for word in ("the", place[0], "one")]
        return part, place[1], color, tokens[end]
    return (tokens[begun : min(told, end)], after, color, tokens[end]) if fits else None


_SINGLE = frozenset({"a", "an", "one", "single", "just", "exactly"})
_AT = {"top": "top", "bottom": "bottom", "left": "leftmost", "right": "rightmost", "middle": "middle",
       "center": "middle"}  # fmt: skip
_ENDED = frozenset({"", ",", ".", ";", "!", "please"})


def _placed(words: list[str], at: int) -> tuple[str, int] | None:
    """ "(all green except for a red one) on the very top": which one that is, and the position behind it."""
    if words[at : at + 1] not in (["on"], ["at"], ["in"]):
        return None
    side = at + 1 + (words[at + 1 : at + 2] == ["the"])
    side += words[side : side + 1] == ["very"]
    if side >= len(words) or words[side] not in _AT:
        return None
    end = side + 1 + (words[side + 1 : side + 2] == ["end"] and words[side] in ("left", "right"))
    return (_AT[words[side]], end) if (words[end] if end < len(words) else "") in _ENDED else None


def _word(word: str, like: Token) -> Token:
    return replace(like, kind="word", word=word, raw=word, value=None)
