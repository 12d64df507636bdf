"""Corrections in the middle of a sentence: "the green - no, the blue one", "three, sorry, four", "on, I mean under"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.talk.same_again import same_again
from rpg.language.grammar.talk.taken_back import taken_back
from rpg.language.tokens import Token

_REPAIRS = (
    "no", "sorry", "wait", "oops", "whoops", "i mean", "i meant", "or rather", "scratch that", "strike that",
    "make that", "correction", "my mistake", "my bad", "actually no", "no wait", "hang on", "hold on", "i mean to say",
)  # fmt: skip
_BESIDE = frozenset({",", "uh", "um", "er", "erm", "uhm", "hmm", "oh", "ah", "actually", "rather", "not that", "…"})
"""What stands among these words without being one of them."""
_STOPS = frozenset({".", ";", ":", "!", "?"})
_ARTICLES = frozenset({"the", "a", "an", "this", "that", "my"})
_WHERE = frozenset({"on", "onto", "in", "into", "under", "beneath", "behind", "beside", "next", "near", "to", "above",
                    "below", "at", "between", "upon"})  # fmt: skip
_LEADS = frozenset({"next", "close", "right", "up", "directly", "just", "over"})
"""What belongs to the word of place behind it."""
_FAR = 9
"""So many words before it at most is what is taken back."""


_APART = frozenset({",", "…"})


def corrected(tokens: list[Token]) -> list[Token]:
    """The tokens with what was taken back left out, where it is clear what that is; else as they were."""
    tokens, at = same_again(taken_back(_set_off(tokens))), 0
    while at < len(tokens):
        end = _repair(tokens, at) if at and tokens[at].word in _APART else 0
        if end and (mended := _mended(tokens, at, end)) is not None:
            tokens = mended
            continue
        at = max(at + 1, end)
    return tokens


_TAKING_BACK = frozenset({"no", "sorry", "wait", "oops", "whoops"})


def _set_off(tokens: list[Token]) -> list[Token]:
    """ "On the green one no sorry on the red one": commas around two or more words that only take something back."""
    for at in range(2, len(tokens) - 2):
        if tokens[at].word not in _TAKING_BACK or tokens[at - 1].word in _APART | _STOPS:
            continue
        end = at
        while many := max((len(r) for r in _SPLIT if [t.word for t in tokens[end : end + len(r)]] == [*r]), default=0):
            end += many
        if end >= at + 2 and tokens[end : end + 1] and tokens[end].word not in _APART | _STOPS:
            begin = next(n for n in range(at, 0, -1) if tokens[n - 1].word not in _BESIDE)
            comma = tokens[at].saying(",")
            return [*tokens[:begin], comma, *tokens[begin:end], comma, *tokens[end:]]
    return tokens


def _repair(tokens: list[Token], at: int) -> int:
    """The position behind words that take something back, set off by a comma or dash on both sides; 0 without any."""
    end, repairs = at, 0
    while end < len(tokens):
        words = [t.word for t in tokens[end : end + 4]]
        many = max((len(r) for r in _SPLIT if words[: len(r)] == [*r]), default=0)
        repairs += bool(many)
        if not many and tokens[end].word not in _BESIDE:
            break
        end += many or 1
    last = tokens[end - 1].word
    repairs += not repairs and _said_anew(tokens, at, end)
    bare = last in ("no", "wait") and tokens[end - 2].word == ","  # ", no blocks on the mat"
    return end if repairs and end < len(tokens) and not bare else 0


_HESITATIONS = frozenset({"uh", "um", "er", "erm", "uhm", "…"})
_KINDS = (lexicon.COLOR, lexicon.BLOCK, lexicon.STRUCTURE, lexicon.SIZE)


def _said_anew(tokens: list[Token], at: int, end: int) -> bool:
    """ "a tower of three, er, four purple blocks": another number in front of what is counted, and no list of them."""
    alone = at > 1 and tokens[at - 2].word not in (",", "and") and _kind(tokens, at - 2) != "number"
    hesitant = not _HESITATIONS.isdisjoint(t.word for t in tokens[at:end])
    counted = alone and hesitant and _kind(tokens, at - 1) == "number"
    if not counted or end + 1 >= len(tokens) or _kind(tokens, end) != "number":
        return False
    return any(tokens[end + 1].word in words for words in _KINDS)


_SPLIT = tuple(tuple(phrase.split()) for phrase in _REPAIRS)


def _mended(tokens: list[Token], at: int, end: int) -> list[Token] | None:
    """The sentence as it was meant; None where it is not clear what was taken back."""
    begun = max((n + 1 for n in range(at) if tokens[n].word in _STOPS), default=0)
    before = range(at - 1, max(begun, at - _FAR) - 1, -1)
    kind = _kind(tokens, end)
    back = next((n for n in before if _kind(tokens, n) == kind), None)
    stop = next((n for n in range(end, len(tokens)) if tokens[n].word in (_STOPS | {","})), len(tokens))
    places = {t.word for t in tokens[end + 1 : stop] if t.word in _WHERE}
    if kind in ("article", "color", "number", "name") and _is_list(tokens, end, stop):
        begin = at - (stop - end)  # "red and green, no, red and blue": all that is listed is taken back
        kinds = [[_kind(tokens, n + k) for k in range(stop - end)] for n in (begin, end)]
        return [*tokens[:begin], *tokens[end:]] if begin > begun and kinds[0] == kinds[1] else None
    if back is None or any(t.word in places for t in tokens[begun:at]):
        return None
    while back > begun and kind == "place" and tokens[back - 1].word in _LEADS:
        back -= 1
    closed = stop < len(tokens) and tokens[stop].word == ","
    if kind in ("number", "color") and stop == end + 1 and back < at - 1:
        rest = tokens[stop + closed :]
        return [*tokens[:back], tokens[end], *tokens[back + 1 : at], *rest]
    onward = stop + 1 < len(tokens) and tokens[stop + 1].word in _WHERE
    rest = [*_with_its_noun(tokens[end:stop], tokens[at - 1]), *tokens[stop + (closed and onward) :]]
    return [*tokens[:back], *rest]


def _is_list(tokens: list[Token], begin: int, end: int) -> bool:
    """ "Red and blue", "a red and a blue one": what follows an "and" is of the kind that it begins with."""
    ands = [n for n in range(begin + 1, end - 1) if tokens[n].word == "and"]
    return any(_kind(tokens, n + 1) == _kind(tokens, begin) for n in ands)


def _with_its_noun(said: list[Token], noun: Token) -> list[Token]:
    """ "(on the white mat, no,) the black one": a mat, as what was taken back."""
    kinds = [_kind(said, n) for n in range(min(2, len(said)))]
    one = kinds == ["article", "color"] and len(said) > 2 and said[2].word == "one"
    told = lexicon.PATCH.get(noun.word) is False
    return [*said[:2], said[2].saying(noun.word), *said[3:]] if one and told else said


def _kind(tokens: list[Token], at: int) -> str:
    """What a word may be replaced by: another of its kind."""
    token = tokens[at]
    if token.word == "one" and at and tokens[at - 1].word in lexicon.COLOR:
        return "noun"
    if token.kind == "number" or token.word in lexicon.NUMBER:
        return "number"
    if token.word in lexicon.COLOR:
        return "color"
    if token.word in _ARTICLES:
        return "article"
    if token.word in _WHERE:
        return "place"
    return "name" if len(token.raw) > 1 and token.raw.isupper() else token.word
