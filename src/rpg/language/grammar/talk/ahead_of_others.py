"""Some blocks ahead of others: "in a row, the vowels A, E and I come before the consonants R, S and T" is a row of all
of them, and these to the left of those; of the order among the vowels nothing is said."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.grammar.rows.vocabulary import COLOR, MUST
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

AHEAD = frozenset({"before", "ahead", "precede", "precedes"})
_ONE = f"(?:\\w|(?:the )?{COLOR}(?: (?:one|block|cube))?)"
_LIST = f"(?:{_ONE} (?:, and|,|and) )*{_ONE}"
_ALL = "(?:(?:all|both|the|all the|all of|both of|each of|all of the|these|those) )*"
_KINDS = "(?:(?:letters?|vowels?|consonants?|digits?|numbers?|even|odd|blocks?|cubes?|ones) )*"
_COME = f"(?:{MUST} )?(?:all )?(?:(?:be|come|comes|stand|stands|go|goes|are|is|lie) )?"
_SOME = f"{_ALL}{_KINDS}\\(? ?{_LIST}(?: \\))?"
_AHEAD = f"(?P<one>{_SOME}) {_COME}(?:before|ahead of|precedes?) (?P<other>{_SOME})"
_ROW = "(?:single |straight |left to right )*(?:row|line)(?: from left to right)?"
_SUCCESS = "(?:success (?:iff|if and only if|only if|when|if|means(?: that)?) (?:, )?)?"
_TOLD = tuple(map(on_demand, (
    f"{_SUCCESS}(?:in (?:an?|one) {_ROW}(?: ,)?|an? {_ROW}(?: ,)? (?:in which|where|so that|with)) {_AHEAD}$",
    f"{_SUCCESS}(?:put |place |line up |arrange )?{_AHEAD}(?: ,)? in (?:an?|one|the same) {_ROW}$",
)))  # fmt: skip


def ahead_of_others(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with the row of all these blocks, and with those that are to the left of the others."""
    begin = 0
    for end in [*(n for n, word in enumerate(words) if word in STOPS), len(words)]:
        text = " ".join(words[begin:end])
        if match := next((found for row in _TOLD if (found := row.match(text))), None):
            one, other = (_named(tokens[begin:end], text, match.span(part)) for part in ("one", "other"))
            say = tokens[begin].saying
            lined = [say("put"), *_listed([*one, *other]), *map(say, ("in", "a", "row", "."))]
            ahead = [*_listed(one), *map(say, ("must", "be", "to", "the", "left", "of")), *_listed(other)]
            return [*tokens[:begin], *lined, *ahead, *tokens[end:]]
        begin = end + 1
    return None


def _named(tokens: Sequence[Token], text: str, span: tuple[int, int]) -> list[Token]:
    """The labels and colours in a stretch of a sentence."""
    first, last = (text[:at].count(" ") for at in span)
    said = tokens[first : last + 1]
    return [t for t in said if t.word in lexicon.COLOR or (len(t.word) == 1 and t.word.isalnum())]


def _listed(named: list[Token]) -> list[Token]:
    """ "A, B and C"."""
    joints = ["", *[","] * (len(named) - 2), "and"]
    told = zip(joints, named, strict=False)
    return [token for joint, one in told for token in ((one.saying(joint), one) if joint else (one,))]
