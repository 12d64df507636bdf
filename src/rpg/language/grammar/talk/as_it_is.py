"""How things are before what is to be done, told as news: "the red block has been put on the mat. Move it ...",
"imagine that it is there. Move it ..."."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.headings import commanded
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_ENDS = frozenset({".", "!", "?", ";"})
_SUPPOSED = (("imagine", "that"), ("picture", "this", ":"), ("imagine", "this", ":"), ("you", "will", "see", "that"),
             ("note", "that"), ("notice", "that"))  # fmt: skip
_SUBJECTS = frozenset({"the", "a", "an", "all", "both", "one", "this", "these", *lexicon.NUMBER})
_OTHERWISE = frozenset({"once", "when", "after", "if", "until", "should", "must", "shall", "may", "can", "to", "which",
                        "by", "before", "not", "never", "always"})  # fmt: skip
"""With these it is no news of how things are."""
_HAS_BEEN = (["has", "been"], ["have", "been"])
_START = ["at", "the", "start"]
_IS = frozenset({"is", "are", "sits", "sit", "stands", "stand", "lies", "lie", "rests", "rest"})
TELLING = frozenset({"imagine", "picture", "see", "note", "notice", "been", "start"})


def as_it_is(tokens: list[Token]) -> list[Token]:
    """The tokens with such news told of the start, where a command stands in another sentence."""
    words = [token.word for token in tokens]
    begins = [0, *(n + 1 for n, word in enumerate(words[:-1]) if word in _ENDS)]
    out = list(tokens)
    for begin, end in reversed([*zip(begins, [*begins[1:], len(words)], strict=True)]):
        lead = length_at(words, begin, _SUPPOSED)
        told = words[begin + lead : end]
        news = _OTHERWISE.isdisjoint(told)
        been = next((n for n in range(begin + 2, end) if words[n - 1 : n + 1] in _HAS_BEEN), 0)
        now = next((n for n in range(begin + 1, end - 3) if words[n : n + 3] == _START and words[n + 3] in _IS), 0)
        if lead and news and not _IS.isdisjoint(told) and commanded([*tokens[:begin], *tokens[end:]]):
            out[begin : begin + lead] = [tokens[begin].saying(word) for word in ("suppose", "that")]
        elif been and news and told[0] in _SUBJECTS and commanded(tokens[end:]):
            out[been - 1 : been + 1] = [tokens[been].saying("was" if words[been - 1] == "has" else "were")]
        elif now and tokens[now - 1].kind == "word":  # "the red block at the start is there"
            out[now : now + 3] = [tokens[now].saying("initially")]
    return out
