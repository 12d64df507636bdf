"""What stands out of its place: "must at all times be there", "10 cm maximum", "the others can be anywhere"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.talk.exactly_so_many import LEAST, MOST
from rpg.language.phrases import behind, length_at
from rpg.language.tokens import Token

_MODALS = frozenset({"must", "should", "shall", "will", "may"})
_AMID = {
    "always": (("at", "all", "times"), ("at", "any", "time"), ("all", "the", "time"), ("the", "whole", "time")),
    "never": (("under", "no", "circumstances"), ("in", "no", "case"), ("at", "no", "point")),
    "": (("in", "the", "end"), ("at", "the", "end"), ("by", "the", "end"), ("at", "the", "very", "end"),
         ("in", "the", "final", "state"), ("when", "all", "is", "done"), ("at", "the", "end", "of", "the", "episode"),
         ("at", "the", "end", "of", "the", "task")),
}  # fmt: skip
"""Times told between "must" and what must be, and the word for each that stands there."""
BETWEEN = frozenset({"times", "time", "circumstances", "case", "point", "end", "state", "done"})
_DENIED = frozenset({"not", "never", "no", "neither", "nor", "none", "nothing"})
_UTMOST = {**dict.fromkeys(MOST, "most"), **dict.fromkeys(LEAST, "least")}
UTMOST = frozenset(phrase[-1] for phrase in _UTMOST)
_UNITS = frozenset({"cm", "mm", "centimeter", "centimeters", "centimetre", "centimetres", "millimeters"})
_BOUNDED = frozenset({"most", "least", "than", "within", "max", "maximum", "min", "minimum", "about", "to", "exactly"})
_ENDS = frozenset({".", "!", "?", ";", ","})


def amid_the_verb(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Must at all times be on the mat": must always be on it; "must, in the end, be": it must be."""
    for at in range(1, len(words) - 3):
        comma = words[at + 1] == ","
        start = at + 1 + comma
        if words[at] not in _MODALS or not _DENIED.isdisjoint(words[max(0, at - 2) : at]):
            continue
        for word, phrases in _AMID.items():
            end = behind(words, start, phrases)
            end += bool(end) and words[end : end + 1] == [","]
            if end and end < len(words) and _verb(words[end]) and words[end - 1 : end] != [","] * (not comma):
                said = [tokens[start].saying(word)] if word else []
                plain = [*tokens[: at + 1], *said, *tokens[end:]]
                return amid_the_verb(plain, [token.word for token in plain]) or plain
    return None


def _verb(word: str) -> bool:
    return word == "be" or word in lexicon.POSTURE or word in lexicon.VERB


def measured_last(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "10 cm maximum": at most 10 cm."""
    for at in range(1, len(words) - 2):
        number = tokens[at].kind == "number" or words[at] in lexicon.NUMBER
        if not number or words[at + 1] not in _UNITS or words[at - 1] in _BOUNDED:
            continue
        apart = words[at + 2] in ("apart", "away")
        after = at + 2 + apart
        after += words[after : after + 1] == [","]
        for phrase, bound in _UTMOST.items():
            if tuple(words[after : after + len(phrase)]) == phrase:
                told = [tokens[at].saying(word) for word in ("at", bound)]
                alone = words[at - 1] == "," and words[after + len(phrase) :][:1] in ([], [","], ["."], ["!"], [";"])
                away = [tokens[at + 1].saying("away")] if alone and not apart else []  # "near it, 10 cm maximum"
                return [*tokens[:at], *told, *tokens[at : at + 2 + apart], *away, *tokens[after + len(phrase) :]]
    return None


def not_touching(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Near the blue one, but not touching": not touching it."""
    for at in range(2, len(words) - 2):
        ended = words[at + 3 : at + 4] == [] or words[at + 3] in _ENDS
        if words[at : at + 3] == ["but", "not", "touching"] and ended:
            comma = [] if words[at - 1] == "," else [tokens[at].saying(",")]
            return [*tokens[:at], *comma, *tokens[at + 1 :]]
    return None


_OTHERS = frozenset({"others", "rest", "other", "remaining"})
_NOUNS = frozenset({"blocks", "cubes", "ones", "digits", "numbers", "letters", "bricks", "boxes"})
_MAY = frozenset({"can", "may", "could", "might"})
_BE = frozenset({"be", "stay", "go", "lie", "stand", "remain", "sit", "rest", "end"})
ANYWHERE = frozenset({"anywhere", "wherever"})
_LIKED = (("you", "like"), ("you", "want"), ("they", "like"), ("they", "want"), ("they", "are"), ("on", "the", "table"))


def others_anywhere(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The other digits can be wherever, put the 9 on the 6": so they are the others, and told behind it."""
    for at in range(len(words) - 3):
        noun = at + 1 + (words[at + 1] in _NOUNS)
        if words[at] not in _OTHERS or words[noun] not in _MAY or words[noun + 1 : noun + 2] in ([], ["not"]):
            continue
        where = noun + 1 + (words[noun + 1] in _BE)
        where += words[where : where + 1] == ["up"]
        if words[where : where + 1] not in (["anywhere"], ["wherever"]):
            continue
        end = where + 1 + length_at(words, where + 1, _LIKED)
        begin = at - (at > 0 and words[at - 1] == "the")
        said = ("the", "others", "can", "be", "anywhere")
        told = [tokens[at].saying(word) for word in said]
        if begin and words[begin - 1] not in (*_ENDS, "and", "but", "("):
            continue
        if begin or end >= len(words) - 2:
            same = tuple(words[begin:end]) == said
            return None if same else [*tokens[:begin], *told, *tokens[end:]]
        if words[end] not in (",", ";", "."):
            return None
        rest = end + 1 + (words[end + 1] in ("but", "and"))
        stop = next((n for n in range(rest, len(words)) if words[n] in (".", "!", "?", ";", "(")), len(words))
        mark = tokens[at].saying(".")
        return [*tokens[rest:stop], mark, *told, *([mark] if words[stop : stop + 1] == ["("] else []), *tokens[stop:]]
    return None
