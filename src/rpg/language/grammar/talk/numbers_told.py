"""Numbers and ends told as nouns: "the number of red cubes on the mat is two", "both of three blocks", "on the tip",
"the three on the five"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

NUMBER = frozenset({"number", "count"})
_PLACES = frozenset({"on", "in", "inside", "within", "at"})
_IS = (("is",), ("must", "be"), ("should", "be"), ("shall", "be"), ("has", "to", "be"), ("equals",), ("is", "to", "be"),
       ("must", "equal"), (":",))  # fmt: skip
_BOUNDS = (("exactly",), ("at", "least"), ("at", "most"), ("precisely",), ("just",), ("only",))
_STOPS = frozenset({".", "!", "?", ";", ",", ":"})
_LATER = frozenset({"blocks", "cubes", "times", "as", "more", "less", "than", "of"})
TIPS = frozenset({"tip", "peak", "summit", "apex"})
_TALL = frozenset({"pyramid", "tower", "stack", "pile"})
_BUILT = frozenset({"towers", "stacks", "rows", "lines", "columns", "piles"})


def number_is(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "The number of red cubes on the mat is exactly two": exactly two red cubes must be on the mat."""
    for at in range(len(words) - 6):
        if words[at] not in NUMBER or words[at + 1] != "of":
            continue
        place = next((n for n in range(at + 2, len(words)) if words[n] in _PLACES | _STOPS), len(words))
        found = [
            (n, n + len(x)) for n in range(place + 1, len(words)) for x in _IS if tuple(words[n : n + len(x)]) == x
        ]
        verb, after = max(found[:1], default=(0, 0))
        plain = verb and words[place] in _PLACES and _STOPS.isdisjoint(words[place:verb])
        bound = length_at(words, after, _BOUNDS)
        many = after + bound
        counted = many < len(words) and (tokens[many].kind == "number" or words[many] in lexicon.NUMBER)
        if not plain or not counted or (many + 1 < len(words) and words[many + 1] in _LATER):
            continue
        begin = at - (at > 0 and words[at - 1] == "the")
        begin -= begin > 0 and words[begin - 1] in ("and", ",")
        lead = [tokens[at].saying(".")] if begin > 0 and words[begin - 1] not in _STOPS else []
        how = tokens[after:many] if bound else [tokens[at].saying("exactly")]
        must = [tokens[verb].saying(word) for word in ("must", "be")]
        told = [*how, tokens[many], *tokens[at + 2 : place], *must, *tokens[place:verb]]
        plainer = [*tokens[:begin], *lead, *told, *tokens[many + 1 :]]
        return number_is(plainer, [token.word for token in plainer]) or plainer
    return None


def both_of_so_many(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Two towers, both of three blocks": each of three blocks."""
    for at in range(2, len(words) - 2):
        after = words[at - 1] == "," and words[at - 2] in _BUILT and words[at] == "both"
        number = at + 1 + (words[at + 1] == "of")
        if after and (tokens[number].kind == "number" or words[number] in lexicon.NUMBER):
            return [*tokens[:at], tokens[at].saying("each"), *tokens[at + 1 :]]
    return None


def digits_named(tokens: list[Token]) -> list[Token] | None:
    """ "The three on the five": the 3 on the 5, where no number is how many there are of something."""
    at = [n for n, token in enumerate(tokens) if token.many]
    named = [n for n in at if n and tokens[n - 1].word == "the" and not _counts(tokens[n + 1 : n + 2])]
    if len({tokens[n].word for n in named}) < 2 or len(named) < len(at) or any(tokens[n].many > 9 for n in at):
        return None
    return [
        replace(token, kind="number", word=str(token.many), raw=str(token.many), value=float(token.many))
        if n in named else token
        for n, token in enumerate(tokens)
    ]  # fmt: skip


def _counts(after: list[Token]) -> bool:
    """Whether a number in front of it is how many of these there are."""
    return any(t.word in _COUNTED or t.word in lexicon.COLOR or t.word in lexicon.COLOR_PLURAL for t in after)


_COUNTED = lexicon.BLOCK.keys() | lexicon.PATCH.keys() | lexicon.LETTER.keys() | lexicon.STRUCTURE.keys() | {
    "of", "ones", "others", "other", "more", "remaining", "small", "big", "large",
}  # fmt: skip


def on_the_tip(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A pyramid with a pink one on the tip": at the top."""
    at = next((n for n in range(2, len(words)) if words[n] in TIPS and words[n - 1] in ("the", "its")), 0)
    if at and words[at - 2] in ("on", "at") and not _TALL.isdisjoint(words) and words[at + 1 : at + 2] != ["of"]:
        return [*tokens[: at - 2], *(tokens[at].saying(word) for word in ("at", "the", "top")), *tokens[at + 1 :]]
    return None
