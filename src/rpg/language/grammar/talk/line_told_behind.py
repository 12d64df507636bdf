"""What a tower or row that is there is made of, told in a sentence of its own: "Unstack the tower. It consists of a red
and a white block."."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.phrases import behind
from rpg.language.tokens import Token

_LINES = frozenset({"tower", "stack", "row", "line", "column"})
_IS_OF = (("consists", "of"), ("is", "made", "of"), ("is", "made", "up", "of"), ("is", "made", "from"), ("has",),
          ("is", "built", "of"), ("is", "built", "from"), ("contains",), ("comprises",), ("is",))  # fmt: skip
_AT = frozenset({"on", "at", "in", "next", "beside", "behind", "left", "right", "there", "made", "built", "standing",
                 "upright"})  # fmt: skip
"""What a tower is not made of: "the tower is next to the red block"."""
_THERE = frozenset({"take", "unstack", "dismantle", "disassemble", "apart", "keep", "leave", "move", "reverse",
                    "remove", "upside", "swap", "off", "rebuild", "invert", "restack"})  # fmt: skip
"""Words of what is done with a tower that is there."""
_ONE = frozenset({"one", *lexicon.BLOCK, *lexicon.COLOR})
_ARTICLES = frozenset({"a", "an", "one", "another", "each", "two", "three", "four", "both"})


def line_told_behind(tokens: list[Token]) -> list[Token] | None:
    """The words with what the tower is made of in front, as it is at the start; None where none is told so."""
    words = [token.word for token in tokens]
    lines = {word for word in words if word in _LINES}
    if len(lines) != 1 or _THERE.isdisjoint(words):
        return None
    line = lines.pop()
    parts = sentences(tokens)
    for n, part in enumerate(parts if len(parts) > 1 else ()):
        made = _made_of(part, line)
        rest = [token for m, other in enumerate(parts) if m != n for token in other]
        if not made or _new_one([token.word for token in rest], line):
            continue
        looks = _looks([token.word for token in rest], line)
        named = [part[0].saying(word) for word in ("at", "the", "start", "there", "is", "a", *looks, line, "of")]
        begun = [*named, *made, part[0].saying(".")]
        first = [] if line in (token.word for token in rest) or n else [part[0].saying("the"), part[0].saying(line)]
        return [*begun, *(_in_place(rest, first) if first else rest)]
    return None


def _made_of(part: list[Token], line: str) -> list[Token]:
    """What a sentence tells the tower to be made of, if it tells no more."""
    words = [token.word for token in part]
    at = behind(words, 0, (("the", line), ("it",), ("this", line), ("that", line), (line,)))
    of = behind(words, at, _IS_OF) if at else 0
    told = part[of:-1] if part[-1].word in STOPS else part[of:]
    plain = of and told and told[0].word not in _AT and not any(t.word in _THERE | lexicon.VERB.keys() for t in told)
    return told if plain and any(t.word in lexicon.BLOCK or t.word in lexicon.COLOR for t in told) else []


def _new_one(words: list[str], line: str) -> bool:
    """Whether such a line is spoken of as one that is to be built: "a tower", "a red tower"."""
    return any(
        word == line and not _ARTICLES.isdisjoint(words[max(0, n - 2) : n]) and words[n - 1] != "the"
        for n, word in enumerate(words)
    )


def _looks(words: list[str], line: str) -> list[str]:
    """ "The blue (tower)"."""
    found = {words[n - 1] for n in range(2, len(words)) if words[n] == line and words[n - 2] == "the"}
    return [word for word in found if word in lexicon.COLOR]


def _in_place(rest: list[Token], name: list[Token]) -> list[Token]:
    """The words with the first "it" by its name, unless that is a block that is named ahead of it."""
    at = next((n for n, token in enumerate(rest) if token.word == "it"), None)
    if at is None or any(token.word in _ONE for token in rest[:at]):
        return rest
    return [*rest[:at], *name, *rest[at + 1 :]]
