"""Clauses in any words that can tell nothing of blocks: "this is the first scenario in my evaluation", "so that I can
verify position tracking", "to see how the policy does", "like a chocolate bar".

Other modules know what people say around a task by its words. Here a clause of which some word is known for nothing is
left out by its form: it is set off, or begins as an aim, a reason or a comparison does; something in it is of people,
of their work or of what they think of it; and no word of it could tell of blocks, deny or take back anything. Only for
texts that make no sense with it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from rpg.language import harmless, lexicon
from rpg.language.not_here import HINTS
from rpg.language.smalltalk import is_strange, takes_back
from rpg.language.spoken_leads import DET, PLACING, TESTS, bends, of_words, tells_nothing
from rpg.language.telling import LAID_OUT, in_its_order, may_tell, may_tell_how, tells
from rpg.language.tokens import Token
from rpg.language.told_again import ordered_again, told_again
from rpg.language.word_lists import listed

_ENDS = frozenset({".", "!", "?", ";", "…"})
_MARKS = _ENDS | {",", ":", "(", ")"}
_AIMS = (("so", "that"), ("so",), ("to",), ("in", "order", "to"), ("so", "as", "to"), ("just", "to"))
_OTHERS = (("because",), ("since",), ("as",), ("like",), ("just", "like"), ("for",), ("within",), ("in", "a"),
           ("in", "one"), ("before",), ("while",), ("this", "is"), ("it", "is"), ("this", "should"))  # fmt: skip
"""What a clause begins with that nothing sets off."""
_TRYING = listed(
    "test check see verify evaluate measure assess validate train study show demonstrate practise practice probe "
    "examine benchmark compare find debug calibrate confirm try learn teach record film win pass succeed complete "
    "solve score earn"
)
"""Behind these it is told what is tried out or won, which may be called as what is done to blocks is."""
_OURS = listed("i we my our he she his her me us you your everybody everyone nobody people someone somebody")
_WORK = (
    TESTS
    | harmless.OCCASIONS
    | listed(
        "level policy agent robot gripper camera timer trick objective marks release sprint figure paper class demo "
        "episode rollout run seed start end study"
    )
)
_SEEN = harmless.OCCASIONS | harmless.THINGS | harmless.ANIMALS
_ANCHORS = _OURS | _WORK | _SEEN | harmless.PEOPLE | harmless.FINE
_NOT = listed(
    "nothing nobody none neither nor only except but unless instead if no not never without until both each all any "
    "every other another different same more less than twice again too also rather either everything anything "
    "something match matching matches read reads reading readable legible says written"
)
"""With these a clause may be about what is asked for, whatever else is said in it."""
_FEWEST, _TITLE = 3, 6
"""A clause has so many words at least, a title so many at most."""


def clauses_left_out(tokens: Sequence[Token]) -> Iterator[tuple[list[Token], str]]:
    """The words without one clause that can only be talk, and what was left out; each clause in turn, from the left."""
    words = [token.word for token in tokens]
    marks = [-1, *(n for n, word in enumerate(words) if word in _MARKS), len(words)]
    for before, behind in pairwise(marks):
        begin = before + 1
        clause, others = tokens[begin:behind], [*tokens[:begin], *tokens[behind:]]
        if (only_talk(clause) and ordered_again(words[begin:behind], tokens[behind:])) or _liked(clause, others):
            yield from _without(tokens, begin, behind)
            continue
        for at in range(begin + 2, behind - 1):
            ordered = in_its_order(words[at:behind], words[:at])
            if _lead(words[at:], (*_AIMS, *_OTHERS)) and not ordered and only_talk(tokens[at:behind]):
                yield from _without(tokens, at, behind)
                break


def _without(tokens: Sequence[Token], begin: int, end: int) -> Iterator[tuple[list[Token], str]]:
    ahead, rest = [*tokens[:begin]], [*tokens[end:]]
    if ahead and ahead[-1].word == "(" and rest and rest[0].word == ")":
        ahead, rest = ahead[:-1], rest[1:]
    elif ahead and ahead[-1].word in _MARKS - _ENDS and (not rest or rest[0].word in _MARKS):
        ahead = ahead[:-1]
    elif rest and (not ahead or ahead[-1].word in _ENDS):
        rest = rest[1:]
    if ahead or rest:
        raws = " ".join({t.span: t.raw for t in tokens[begin:end]}.values())
        yield [*ahead, *rest], f"left out, for it asks for nothing: '{raws}'"


def _lead(words: Sequence[str], leads: Sequence[tuple[str, ...]]) -> int:
    return max((len(lead) for lead in leads if tuple(words[: len(lead)]) == lead), default=0)


def only_talk(tokens: Sequence[Token]) -> bool:
    """Whether a clause can only be talk, whatever some of its words mean."""
    words = [token.word for token in tokens]
    lead = _lead(words, (*_AIMS, *_OTHERS))
    titled = words[:1] != ["this"] and 1 < len(words) <= _TITLE and words[-1] in TESTS and words[-2] not in DET
    if (len(words) < _FEWEST and not titled) or (words[0] in lexicon.COMMANDS and not titled) or takes_back(words):
        return False
    if not lead and _wished_for(words):
        return False
    if words[0] in ("like", "just", "as") and not LAID_OUT.isdisjoint(words):
        return False
    aimed = _lead(words, _AIMS)
    tried = titled or (bool(aimed) and not _TRYING.isdisjoint(words[aimed : aimed + 4]))
    felt = _felt(words)
    if any(n not in felt and not _harmless(token, words, n, tried) for n, token in enumerate(tokens) if n >= lead):
        return False
    return not _ANCHORS.isdisjoint(words) or tried


def _wished_for(words: Sequence[str]) -> bool:
    """ "I want a lighthouse", "a lighthouse would be nice": of what is wished for nobody knows how its blocks stand."""
    for n, word in enumerate(words):
        things = next((k for k in range(n + 1, n + 4) if words[k : k + 1] != [] and words[k] in _ONE), 0)
        begun = n + 1 if n == 0 and word in _ONE else things + 1 if things and word in _WISHING else 0
        if begun and any(map(_not_known, words[begun : begun + 3])):
            return True
    return False


def _not_known(thing: str) -> bool:
    return thing in HINTS or (is_strange(thing) and thing not in harmless.EVERYDAY)


_ONE = listed("a an one some two three")
_WISHING = listed(
    "want wants wanted need needs needed like likes wish wishes dream dreams dreaming give get bring fetch show order "
    "ordered requested asked prefer prefers imagine imagining expect expects"
)


def _felt(words: Sequence[str]) -> frozenset[int]:
    """Where a clause points at what it is about, without telling of it: "(it) soothes my toddler", "(that) always
    cracks me (up)", "grandpa swears by (it)", "because the intern messed (it) (up)"."""
    if words[0] in _REASONS:
        return frozenset(n for n, word in enumerate(words) if word in _POINTING | {"up"} or word.startswith("mess"))
    if words[0] == "while" and words[1] in ("i", "we", "he", "she") and words[-1] in _SEEN:
        return frozenset({2})  # "while I grab a coffee"
    if words[0] == "which" and not any(word in lexicon.VERB and not word.startswith("ma") for word in words):
        return frozenset({0, *(n for n, word in enumerate(words) if word in _MERELY)})
    verb = 1 + (words[1:2] != [] and words[1] in _MERELY)
    moved = words[0] in _POINTING and words[verb : verb + 1] != [] and words[verb].endswith("s")
    if moved and words[verb + 1 : verb + 2] != [] and words[verb + 1] in _WHOM and is_strange(words[verb]):
        return frozenset({0, verb - 1, *([len(words) - 1] if words[-1] in ("up", "down") else [])})
    trusted = (
        words[-1] == "it" and words[-2] in ("by", "about", "of", "for") and not harmless.PEOPLE.isdisjoint(words[:2])
    )
    return frozenset({len(words) - 1} if trusted else ())


def _liked(clause: Sequence[Token], others: Sequence[Token]) -> bool:
    """ "My gripper hates tight gaps": what somebody likes or hates, if all of it is told besides."""
    words = [token.word for token in clause]
    verb = next((n for n in range(2, 4) if words[n : n + 1] != [] and words[n] in _LIKING), 0)
    whose = verb > 0 and words[0] in DET and all(tells_nothing(word) for word in words[1:verb])
    told = words[verb + 1 :]
    plain = whose and bool(told) and of_words(clause) and (PLACING | _NOT).isdisjoint(told)
    return plain and all(tells_nothing(word) or told_again(told, n, others) for n, word in enumerate(told))


_LIKING = listed("likes loves prefers hates dislikes adores enjoys fears detests")
_REASONS = listed("because since cause cos coz")
_POINTING = listed("it this that")
_MERELY = listed("always just really simply actually")
_WHOM = _OURS - listed("i we he she nobody") | {"them", "him"}


def _harmless(token: Token, words: Sequence[str], n: int, tried: bool) -> bool:
    word, after = token.word, words[n + 1 : n + 3]
    if word == "i" and (after[:1] in (["is"], ["goes"], ["sits"], ["stands"]) or words[max(0, n - 1) : n] == ["on"]):
        return False  # "i is on a": a letter
    if word in ("i", "a", "an"):
        return token.kind == "word"
    if token.kind != "word" or (len(token.raw) > 1 and token.raw.isupper() and word in lexicon.COLOR):
        return word in ("'s", "-")
    if len(token.raw) == 1 and token.raw.isupper():
        return False
    if word in lexicon.ORDINAL or word in ("first", "last", "next"):
        return not _WORK.isdisjoint(after)
    if word in lexicon.SIZE:
        return not _SEEN.isdisjoint(after)
    if word.endswith("ing") and words[n - 1] in ("on", "of", "about", "for") and not _WORK.isdisjoint(words[:n]):
        return True
    if word in _NOT or word in harmless.TIMES or (bends(word) and not tried):
        return False
    if is_strange(word) and may_tell_how(word):
        return False
    return not (tells(token) if tried else may_tell(word))
