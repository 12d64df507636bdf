"""A big cube that is built of small ones: these are the blocks there are, and no small ones among them."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import Token

SMALL = frozenset({"small", "little", "smaller", "tiny", "big", "large", "bigger", "larger", "huge", "great"})
_BIG = frozenset({"big", "large", "bigger", "larger", "huge", "great"})
_ONES = frozenset({"ones", "cubes", "blocks"})
_MAKE = (("make", "up"), ("make",), ("form",), ("build",), ("give",), ("become",), ("should", "form"), ("must", "form"))
_FOUR = {("four", "below"): "bottom", ("four", "above"): "top", ("lower", "four"): "bottom", ("upper", "four"): "top",
         ("bottom", "four"): "bottom", ("top", "four"): "top", ("four", "at", "the", "bottom"): "bottom",
         ("four", "on", "top"): "top", ("four", "lower", "ones"): "bottom", ("four", "upper", "ones"): "top",
         ("four", "underneath"): "bottom"}  # fmt: skip
_SIDES = (8, 27)


def cube_of_small_ones(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "A big cube from eight small ones", "eight small cubes make up a big cube": a cube of eight cubes."""
    for at in range(1, len(words) - 1):
        if words[at] != "cube" or words[at - 1] not in _BIG or at < 2 or words[at - 2] not in ("a", "one", "the"):
            continue
        out = _plain([*tokens[: at - 1], tokens[at - 1].saying("big"), *tokens[at:]])
        said = [token.word for token in out]
        counted = any(_small_ones(tokens, words, n) for n in range(len(words) - 1))
        if sum(word in SMALL for word in said) > 1 or not (
            counted or "by" in words or any(t.kind == "dims" for t in tokens)
        ):
            return None
        return _built(out, said) or out
    return None


def _small_ones(tokens: list[Token], words: list[str], n: int) -> bool:
    """ "Eight small ones", "eight cubes"."""
    small = n + 1 + (words[n + 1] in SMALL - _BIG)
    return tokens[n].many in _SIDES and words[small : small + 1] != [] and words[small] in _ONES


def _plain(tokens: list[Token]) -> list[Token]:
    """The words without the sizes of blocks that are so many."""
    out: list[Token] = []
    for n, token in enumerate(tokens):
        after = tokens[n + 1].word if n + 1 < len(tokens) else ""
        if token.word in SMALL - _BIG and after in _ONES and n and tokens[n - 1].many:
            continue
        ones = token.word == "ones" and out and out[-1].many
        out.append(token.saying("cubes") if ones else token)
    return out


def _built(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "Eight cubes make up a big cube. The four below are red ...": build one, of which the bottom layer is."""
    if not tokens[0].many or len(words) < 5 or words[1] not in _ONES:
        return None
    verb = next((x for x in _MAKE if tuple(words[2 : 2 + len(x)]) == x), ())
    at = 2 + len(verb)
    if not verb or words[at : at + 1] not in (["a"], ["one"]) or words[at + 1 : at + 3] != ["big", "cube"]:
        return None
    head = [tokens[0].saying("build"), tokens[0].saying("a"), *tokens[at + 1 : at + 3], tokens[0].saying("of")]
    return [*head, *tokens[:2], *tokens[at + 3 :]]


def four_below(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "(A cube of eight blocks.) The four below are red": the bottom layer is."""
    if "cube" not in words and not any(t.kind == "dims" for t in tokens):
        return None
    found = [(n, x) for n in range(1, len(words)) for x in _FOUR if tuple(words[n : n + len(x)]) == x]
    if {_FOUR[x] for _, x in found} != {"bottom", "top"} or any(words[n - 1] != "the" for n, _ in found):
        return None
    for n, said in reversed(found):
        are = n + len(said)
        layer = [tokens[n].saying(_FOUR[said]), tokens[n].saying("layer")]
        verb = [tokens[n].saying("is")] if words[are : are + 1] in (["are"], ["is"]) else []
        hue = are + bool(verb)
        if hue >= len(words) or words[hue] not in lexicon.COLOR:
            return None
        tokens = [*tokens[:n], *layer, *verb, *tokens[hue:]]
    return tokens
