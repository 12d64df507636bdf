""" "Everything stays as it is, only red goes on blue": red goes on blue, and everything else stays where it is."""

from __future__ import annotations

from rpg.language.phrases import behind
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
_STAYS = (("stays",), ("remains",), ("stay",), ("remain",), ("looks",), ("is",), ("should", "stay"), ("must", "stay"),
          ("should", "remain"), ("must", "remain"), ("should", "be"), ("should", "look"))  # fmt: skip
_LEFT = (("leave",), ("keep",), ("please", "leave"))
_SO = (("where", "it", "is"), ("where", "they", "are"), ("as", "they", "are"), ("put",), ("as", "it", "is"),
       ("as", "it", "was"), ("the", "same"), ("the", "same", "as", "before"), ("as", "before"), ("in", "place"),
       ("the", "way", "it", "is"), ("exactly", "as", "it", "is"))  # fmt: skip
_BUT = (("except", "that"), ("only", "that"), ("just",), ("only",), ("but",), ("apart", "from", "that"))
_EVERYTHING = (("everything",), *(("all", *the, *noun) for the in ((), ("the",), ("of", "the"), ("of", "them"))
                                  for noun in (("blocks",), ("cubes",), ("bricks",), ("ones",), ())))  # fmt: skip
_OTHERS = ("everything", "else", "stays", "where", "it", "is")
_CHANGED = {"changed": "change", "swapped": "swap", "traded": "trade", "exchanged": "exchange", "switched": "switch"}


def all_as_before(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with what is done in front."""
    for start in (n for n in range(len(words)) if n == 0 or words[n - 1] in _STOPS):
        so = _all_so(words, start)
        begun = so + (words[so : so + 1] == [","]) if so else 0
        but = behind(words, begun, _BUT) if so else 0
        end = next((n for n in range(begun, len(words)) if words[n] in _STOPS), len(words))
        if not but or end - but < 3 or words[but] == "for":
            continue
        told = [t.saying(_CHANGED.get(t.word, t.word)) if t.word in _CHANGED else t for t in tokens[but:end]]
        rest = [tokens[start].saying(word) for word in (",", *_OTHERS)]
        return [*tokens[:start], *told, *rest, *tokens[end:]]
    return None


def _all_so(words: list[str], start: int) -> int:
    """The position behind "everything stays as it is", "leave everything as it is", or 0."""
    if every := behind(words, start, _EVERYTHING):
        stays = behind(words, every, _STAYS)
        return behind(words, stays, _SO) if stays else 0
    left = behind(words, start, _LEFT)
    every = behind(words, left, _EVERYTHING) if left else 0
    return behind(words, every, _SO) if every else 0
