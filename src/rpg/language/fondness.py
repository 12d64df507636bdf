"""What two blocks feel for each other: "the black block and the white block hate each other". It asks for nothing, and
says only that there are such blocks."""

from __future__ import annotations

from itertools import product

from rpg.language import lexicon
from rpg.language.tokens import Token

_VERBS = ("like", "love", "hate", "dislike", "adore", "detest", "miss", "fear", "envy", "despise")
_EACH_OTHER = ("each other", "one another")
_DEGREES = ("good ", "best ", "close ", "old ", "great ", "bad ", "sworn ", "arch ", "")
_TIES = ("friends", "buddies", "pals", "enemies", "rivals", "lovers", "foes")
_OF_EACH = ("fond of", "in love with", "afraid of", "scared of", "jealous of", "angry with", "mad at", "friends with")
_NOT = ("do not ", "can not ", "")
_MUTUAL = frozenset({
    *(f"{no}{verb} {other}" for no, verb, other in product(_NOT, (*_VERBS, "stand", "bear"), _EACH_OTHER)),
    *(f"are {no}{degree}{tie}" for no, degree, tie in product(("not ", ""), _DEGREES, _TIES)),
    *(f"are {no}{how} {other}" for no, how, other in product(("not ", ""), _OF_EACH, _EACH_OTHER)),
    "are in love", "are a couple", "are married", "do not get along", "do not get on", "get along",
})  # fmt: skip
"""What is said of two."""
_OF_ANOTHER = (
    *(f"{verb}s" for verb in _VERBS if verb[-1] != "s"), "misses", "envies", "does not like", "can not stand",
    *(f"is {how}" for how in _OF_EACH), "is in love with", "is a friend of", "is an enemy of",
)  # fmt: skip
"""What is said of one towards another."""
_ARTICLES = frozenset({"the", "my", "our", "your", "a", "an"})
_BREAKS = frozenset({".", "!", "?", ";", ",", ":", "-", "…"})


def without_feelings(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with "there is" before two blocks that feel something for each other, and notes of that."""
    words = [token.word for token in tokens]
    out: list[Token] = []
    notes: list[str] = []
    at = 0
    while at < len(tokens):
        found = _felt(words, at) if at == 0 or words[at - 1] in _BREAKS else None
        if found is None:
            out.append(tokens[at])
            at += 1
            continue
        one, other, end = found
        said = " ".join({token.span: token.raw for token in tokens[at:end]}.values())
        notes.append(f"left out, for it asks for nothing: '{said}'")
        joint = tokens[one[1] - 1].saying("and")
        out += [tokens[at].saying("there"), tokens[at].saying("is"), *_one_such(tokens[slice(*one)]), joint,
                *_one_such(tokens[slice(*other)])]  # fmt: skip
        at = end
    return out, notes


_Range = tuple[int, int]


def _felt(words: list[str], at: int) -> tuple[_Range, _Range, int] | None:
    """The two blocks, and the end of what is said of them, where this begins here."""
    end = next((n for n in range(at, len(words)) if words[n] in _BREAKS), len(words))
    one = _block(words, at)
    if one == at:
        return None
    if words[one : one + 1] == ["and"]:
        other = _block(words, one + 1, plural=True)
        mutual = other > one + 1 and " ".join(words[other:end]) in _MUTUAL
        return ((at, one), (one + 1, other), end) if mutual else None
    for feels in _OF_ANOTHER:
        begin = one + len(feels.split())
        if words[one:begin] == feels.split() and begin < _block(words, begin) == end:
            return (at, one), (begin, end), end
    return None


def _block(words: list[str], at: int, plural: bool = False) -> int:
    """The position behind "the red block", "the red"; `at` where nothing like it begins. `plural`: "blocks" will do."""
    end = at + (words[at : at + 1] != [] and words[at] in _ARTICLES)
    looks = end
    while end < len(words) and (words[end] in lexicon.COLOR or words[end] in lexicon.SIZE):
        end += 1
    if end == looks:
        return at
    noun = words[end] if end < len(words) else ""
    return end + (noun == "one" or lexicon.BLOCK.get(noun) in (False, plural))


def _one_such(block: list[Token]) -> list[Token]:
    """ "The red one" as "a red block"."""
    looks = block[1:] if block[0].word in _ARTICLES else block
    looks = looks[:-1] if looks[-1].word == "one" or looks[-1].word in lexicon.BLOCK else looks
    return [block[0].saying("a"), *looks, block[-1].saying("block")]
