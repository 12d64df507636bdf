"""Names of figures: "build a tower of three and call it the keep; put a cube beside the keep"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.nicknames import named_so, said
from rpg.language.tokens import Token

_CALLED = frozenset({"called", "named", "dubbed"})
_CALL = frozenset({"call", "name", "dub"})
_IT = frozenset({"it", "this", "that"})
_CLOSED = frozenset({",", ".", ";", "!", "?", "and", ")", ":"})
_SET_OFF = frozenset({",", "and", ".", ";", "("})
_LONGEST = 2


def with_figures(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with the one figure that there is for what it is called, and a note of it."""
    words = [token.word for token in tokens]
    at = next((n for n, word in enumerate(words) if word in _CALLED or word in _CALL), 0)
    figures = [n for n, word in enumerate(words) if lexicon.STRUCTURE.get(word, ("", True))[1] is False]
    if not at or len(figures) != 1 or figures[0] > at:
        return tokens, []
    begin = at + 1 + (words[at] in _CALL)
    if words[at] in _CALL and words[at + 1 : at + 2] != [] and words[at + 1] not in _IT:
        return tokens, []
    name = begin + (words[begin : begin + 1] == ["the"])
    end = name
    while end < len(words) and end < name + _LONGEST and named_so(tokens[end]):
        end += 1
    if end == name or (end < len(words) and words[end] not in _CLOSED):
        return tokens, []
    article, called = words[begin:name], words[name:end]
    whole = [*article, *called]
    if not any(words[n : n + len(whole)] == whole for n in range(end, len(words))):
        return tokens, []
    first = at
    while first and words[first - 1] in _SET_OFF - ({"."} if words[at] in _CALLED else set()):
        first -= 1
    end += words[end : end + 1] == [")"]
    stop = [tokens[end - 1].saying(".")] if words[at] in _CALL and words[end : end + 1] not in ([], ["."]) else []
    end += bool(stop) and words[end] in (",", "and")
    out = [*tokens[:first], *stop]
    figure = tokens[figures[0]]
    while end < len(words):
        if words[end : end + len(whole)] == whole:
            out += [tokens[end].saying("the"), tokens[end].saying(figure.word)]
            end += len(whole)
        else:
            out.append(tokens[end])
            end += 1
    return out, [f"'{said(tokens[name : name + len(called)])}' is the {figure.word}"]
