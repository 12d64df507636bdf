"""Headlines of many parts: "Adapted from put-block-in-zone:", "Sorting by parity:", "Port of the classic three-block
stacking task:", "Bedtime for the blocks, sweetie:", "Traffic light (on the black pad: ...)".

They are names of what is told behind them, and tell nothing themselves, or nothing but what is told again there; a
place at their end is where all of it is, and stays.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.smalltalk import is_strange
from rpg.language.spoken_leads import LONGEST, PLACING, TESTS, bends, of_words, sets_off, tells_nothing
from rpg.language.telling import may_tell_how
from rpg.language.tokens import Token
from rpg.language.told_again import CHANGES, ordered_again, so_many, told_again
from rpg.language.word_lists import listed

_BY = listed("parity color colour size letter letters number numbers kind type shape height digit digits")
"""What blocks are sorted by, in a headline."""
_DOINGS = ("sort", "group", "stack", "arrang", "order", "align", "plac", "build", "spell", "classif", "count", "compar")
"""How words begin for what is done in the task."""
_TURNED = (*CHANGES, "invers")
"""Such a task begins with what is told of its start."""
_STARTS = listed("initial initially start starts starting begin begins beginning before setup given swap exchange")
_BLOCKS = frozenset(lexicon.BLOCK)
_NUMBERED = TESTS | listed("case item requirement version req no ticket spec specification example question layout "
                           "config configuration setting order job lot run split suite "
                           "attempt day week batch entry session")  # fmt: skip
"""What has a number or a letter for its name."""


def headline(tokens: Sequence[Token]) -> int:
    """How many of the first words are a headline; a place at its end is none of them."""
    end = next((n for n in range(1, min(2 * LONGEST, len(tokens) - 3)) if sets_off(tokens, n)), 0)
    told = _without_numbers(tokens[:end])
    if not told:  # "TC - 041:" alone
        return end + 1 if end and _by_itself(tokens[end + 1 :]) else 0
    if not of_words([token for token in told if token.word != ","]) or told[-1].word == ",":
        return 0
    behind = tokens[end + 1 :]
    place = _placed(told)
    words = [token.word for token in told[:place]]
    named = not _NUMBERED.isdisjoint(words) or any(is_strange(word) or _done(word) for word in words)
    plain = all(tells_nothing_else(told[:place], n, behind) for n in range(place))
    if not named or not plain or not ordered_again(words, behind):
        return 0
    if place < len(told):
        return 0 if len(told) < end or behind[0].word in lexicon.COMMANDS else place  # a command has a place of its own
    return end + 1


def _without_numbers(told: Sequence[Token]) -> list[Token]:
    """A headline without what only numbers it: "case 41", "requirement R-7", "TC-041", "variant B"."""
    left: list[Token] = []
    for n, token in enumerate(told):
        before = told[n - 1] if n else None
        lettered = before is not None and before.raw.isupper() and token.kind == "number"
        if lettered and left[-1:] == [before]:
            left.pop()
        named = before is not None and before.word in _NUMBERED
        if not lettered and not (named and (token.kind == "number" or (len(token.raw) == 1 and token.raw.isupper()))):
            left.append(token)
    return left


def _by_itself(behind: Sequence[Token]) -> bool:
    """Whether a command stands behind a number, so that this is no block's."""
    return bool(behind) and behind[0].word in lexicon.COMMANDS


def named_errand(tokens: Sequence[Token], behind: Sequence[Token]) -> bool:
    """Whether a first sentence names what sort of task the others tell: "Unstacking task."."""
    words = [token.word for token in tokens]
    sort = len(words) == 2 and words[1] in TESTS and _done(words[0])
    return sort and tells_nothing_else(tokens, 0, behind) and ordered_again(words, behind)


def _placed(told: Sequence[Token]) -> int:
    """Where a place at the end of a headline begins, "(...) on the black pad"; its length if there is none."""
    for n in range(1, len(told) - 1):
        if told[n].word in PLACING and not told[n].joined:
            mat = told[-1].word in lexicon.PATCH and any(t.word in lexicon.COLOR for t in told[n:])
            return n if mat and told[n].word in ("on", "onto") else len(told)
    return len(told)


def tells_nothing_else(told: Sequence[Token], n: int, behind: Sequence[Token]) -> bool:
    """Whether a word of a headline tells nothing, or nothing but what is told again behind it."""
    word = told[n].word
    if word == ",":
        return True
    first = next(k for k in range(n, -1, -1) if not told[k].joined)
    last = next((k for k in range(n + 1, len(told)) if not told[k].joined), len(told))
    compound = [token.word for token in told[first:last]]
    if len(compound) > 1:
        if (many := lexicon.NUMBER.get(compound[0], 0)) and compound[1] in _BLOCKS:
            return so_many(many, behind)
        if len(compound) > 2 and not any(part in lexicon.NUMBER or bends(part) for part in compound):
            return True  # the name of an environment
    if word in _BY and n > 0 and told[n - 1].word == "by":
        return True
    if word.startswith(_TURNED):
        return any(token.word in _STARTS for token in behind)
    if bends(word):
        return False
    nothing = tells_nothing(word) and not (is_strange(word) and may_tell_how(word))
    return nothing or _done(word) or told_again([token.word for token in told], n, behind)


def _done(word: str) -> bool:
    return word.startswith((*_DOINGS, *_TURNED)) and word.endswith(("ing", "sion", "ion", "al"))
