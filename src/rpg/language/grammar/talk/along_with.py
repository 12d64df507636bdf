"""Who is named along with others is one of them: "A, B and C, along with D, form a tower", "stack red, together with
blue"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

ALONG = frozenset({"together", "along"})
_STOPS = frozenset({".", ";", "!", "?", ":", "…"})
_JOINED = frozenset({"and", ","})
_WORDS = frozenset({
    "the", "a", "an", "one", "ones", "all", "both", "letter", "letters", "digit", "digits", "number", "numbers", "sign",
    "signs", "plus", "minus", "equals", "times", "symbols", *lexicon.BLOCK, *lexicon.COLOR, *lexicon.SIZE,
    *lexicon.NUMBER, *lexicon.LETTER, *lexicon.DIGIT, *lexicon.STRUCTURE, "of", *_JOINED,
})  # fmt: skip
"""Of such words are lists of blocks, or of what is built of them."""
_BUILT = frozenset(lexicon.STRUCTURE) - {"plus"}


def along_with(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with those that are named along with others in one list with them."""
    for at in range(1, len(words) - 3):
        if words[at] != "," or words[at + 1] not in ALONG or words[at + 2] != "with":
            continue
        begin = max((n + 1 for n in range(at) if words[n] in _STOPS), default=0)
        begin += words[begin] in lexicon.COMMANDS
        ends = (n for n in range(at + 3, len(words)) if words[n] in _STOPS or words[n] == ",")
        end = next(ends, len(words))
        lists = (tokens[begin:at], tokens[at + 3 : end])
        if not all(part and all(map(_of_a_list, part)) for part in lists):
            continue
        before, added = lists
        built = [any(token.word in _BUILT for token in part) for part in lists]
        if built[0] != built[1]:
            continue  # "a tower of two red blocks, together with a blue one": in it, or near it?
        more = any(token.word == "and" for token in added)
        last = max((n for n, token in enumerate(before) if token.word == "and" and not built[0]), default=None)
        if last is not None:
            before = [*before[:last], tokens[at], *before[last + 1 :]]
        joint = [tokens[at]] if more else [tokens[at].saying("and")]
        closed = end + (words[end : end + 1] == [","])
        rest = tokens[closed:]
        rest = [_of_several(rest[0]), *rest[1:]] if rest else rest
        return [*tokens[:begin], *before, *joint, *added, *rest]
    return None


def _of_a_list(token: Token) -> bool:
    return token.word in _WORDS or token.kind != "word" or len(token.raw) == 1


def _of_several(verb: Token) -> Token:
    """ "(The red one, along with the blue one,) is": are."""
    if verb.word in ("is", "has"):
        return verb.saying({"is": "are", "has": "have"}[verb.word])
    base = verb.word.removesuffix("s")
    return verb.saying(base) if base != verb.word and base in lexicon.VERB else verb
