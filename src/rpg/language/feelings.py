"""How a block feels, or two feel for each other: "the yellow block is lonely", "the black and the white block hate each
other". It asks for nothing, and says only that there are such blocks."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

from rpg.language import lexicon
from rpg.language.nicknames import thing_at
from rpg.language.not_here import FEELINGS
from rpg.language.phrases import length_at
from rpg.language.stories.character import TELLING_NOTHING
from rpg.language.tokens import Token

_VERBS = ("like", "love", "hate", "dislike", "adore", "detest", "miss", "fear", "envy", "despise")
_EACH_OTHER = ("each other", "one another")
_DEGREES = ("good ", "best ", "close ", "old ", "great ", "bad ", "sworn ", "arch ", "")
_TIES = ("friends", "buddies", "pals", "enemies", "rivals", "lovers", "foes")
_OF_EACH = ("fond of", "in love with", "afraid of", "scared of", "jealous of", "angry with", "mad at", "friends with")
_NOT = ("do not ", "can not ", "")
_FIGHTS = ("quarrel", "fight", "argue", "bicker", "squabble")
_FIGHTING = ("quarrelling", "quarreling", "fighting", "arguing", "bickering", "squabbling", "at war", "at odds")
_A_FIGHT = ("a fight", "a quarrel", "an argument", "a falling - out", "a row")
_MUTUAL = frozenset({
    *(f"{no}{verb} {other}" for no, verb, other in product(_NOT, (*_VERBS, "stand", "bear"), _EACH_OTHER)),
    *(f"are {no}{degree}{tie}" for no, degree, tie in product(("not ", ""), _DEGREES, _TIES)),
    *(f"are {no}{how} {other}" for no, how, other in product(("not ", ""), _OF_EACH, _EACH_OTHER)),
    *_FIGHTS, *(f"{be} {fighting}" for be, fighting in product(("are", "were", "keep"), _FIGHTING)),
    *(f"{had} {fight}" for had, fight in product(("had", "have had", "are having"), _A_FIGHT)),
    "are in love", "are a couple", "are married", "do not get along", "do not get on", "get along",
})  # fmt: skip
"""What is said of two."""
_OF_ANOTHER = (
    *(f"{verb}s" for verb in _VERBS if verb[-1] != "s"), "misses", "envies", "does not like", "can not stand",
    *(f"is {how}" for how in _OF_EACH), "is in love with", "is a friend of", "is an enemy of",
)  # fmt: skip
"""What is said of one towards another."""
_FEELS = (("is",), ("feels",), ("looks",), ("seems",), ("gets",))
_HOW = frozenset({"so", "very", "really", "a", "bit", "little", "all", "always", "quite", "too"})
_ALONE = TELLING_NOTHING | frozenset({
    *FEELINGS, "cold", "lost", "ugly", "chipped", "sticky", "dirty", "dusty", "scratched", "worn", "fragile",
    "delicate", "valuable", "broken", "greasy", "slippery", "smelly", "antique", "rusty",
})  # fmt: skip
"""What no block is."""
_ADDED = frozenset({"today", "again", "there", "here", "now"})
_ALWAYS = tuple(
    (*words.split(),) for words in ("all the time", "all day", "all day long", "constantly", "lately", *_ADDED)
)
"""What is added to what two feel."""
_ARTICLES = frozenset({"the", "my", "our", "your", "a", "an"})
_BREAKS = frozenset({".", "!", "?", ";", ",", ":", "-", "…"})
_BEHIND = _BREAKS | {"so"}


def without_feelings(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with "there is" for what blocks feel, and notes of that."""
    tokens, words = [*tokens], [token.word for token in tokens]
    out: list[Token] = []
    notes: list[str] = []
    at = 0
    while at < len(tokens):
        things, end = _felt(words, at)
        if not things:
            thing, more = _and_more(words, at)
            if more > at:
                del tokens[thing:more], words[thing:more]
                continue
            out.append(tokens[at])
            at += 1
            continue
        told = " ".join({token.span: token.raw for token in tokens[at:end]}.values())
        notes.append(f"left out, for it asks for nothing: '{told}'")
        out += [tokens[at].saying("there"), tokens[at].saying("is")]
        for n, (begin, behind) in enumerate(things):
            joint = [tokens[behind - 1].saying("and")] if n else []
            out += [*joint, *_one_such(tokens[begin:behind])]
        if words[end : end + 1] == ["so"]:
            out.append(replace(tokens[end], kind="punct", word=",", raw=","))
        at = end
    return out, notes


def _and_more(words: list[str], at: int) -> tuple[int, int]:
    """Where a block ends of which it is told how it feels "and" what else, and where that else begins: "the red block
    (is tired and) wants to sleep"; the beginning where nothing like it stands here."""
    if at and words[at - 1] not in _BREAKS | {"and", "because", "so"}:
        return at, at
    thing = at + 1 if words[at] in ("it", "he", "she") else max(thing_at(words, at), _block(words, at))
    how = thing + length_at(words, thing, _FEELS)
    while how < len(words) and words[how] in _HOW:
        how += 1
    told = thing > at and how > thing and words[how : how + 1] != [] and words[how] in TELLING_NOTHING
    more = how + 2 if told and words[how + 1 : how + 2] in (["and"], ["but"]) else len(words)
    predicate = more < len(words) and (words[more] in _PREDICATES or words[more] in lexicon.POSTURE)
    return (thing, more) if predicate else (at, at)


_PREDICATES = frozenset({"wants", "would", "must", "should", "will", "needs", "likes", "has", "does", "can", "may",
                         "shall", "takes", "loves", "prefers", "hates", "climbs", "hides"})  # fmt: skip
_Range = tuple[int, int]


def _felt(words: list[str], at: int) -> tuple[tuple[_Range, ...], int]:
    """The blocks that feel something, and the end of what is said of them; none where this does not begin here."""
    if at and words[at - 1] not in _BREAKS | {"and"}:
        return (), at
    thing = max(thing_at(words, at), _block(words, at))
    if thing > at and (end := _lonely(words, thing)):
        return ((at, thing),), end
    return _for_each_other(words, at) if at == 0 or words[at - 1] in _BREAKS else ((), at)


def _lonely(words: list[str], at: int) -> int:
    """The position behind "is very lonely today", "wants a friend"; 0 where this is something else."""
    end = at + length_at(words, at, _MISSES)
    if end > at and (end == len(words) or words[end] in _BREAKS):
        return end
    if (apart := at + length_at(words, at, _WANTS_ROOM)) > at:  # and what follows from that is told
        return apart if words[apart : apart + 1] in ([":"], ["so"]) or words[apart : apart + 2] == [",", "so"] else 0
    verb = length_at(words, at, _FEELS)
    end = at + verb
    while verb and end + 1 < len(words) and words[end] in _HOW and words[end + 1] not in (".", ",", "!"):
        end += 1
    if not verb or end >= len(words) or words[end] not in _ALONE:
        return 0
    end += 1
    while words[end : end + 1] == ["and"] and words[end + 1 : end + 2] != [] and words[end + 1] in _ALONE:
        end += 2
    end += words[end : end + 1] != [] and words[end] in _ADDED
    if afraid := length_at(words, end, _OF_WHAT):  # and what follows from that is told
        so = end + afraid + (words[end + afraid : end + afraid + 1] == [","])
        return end + afraid if words[so : so + 1] == ["so"] else 0
    end += length_at(words, end, _BECAUSE)
    return end if end >= len(words) or words[end] in _BEHIND else 0


_MISSES = tuple(
    (*wants.split(), *what.split())
    for wants in ("wants", "needs", "would like", "could use", "misses", "is looking for", "has no", "longs for")
    for what in ("company", "some company", "a friend", "friends", "a companion", "somebody to play with",
                 "someone to play with", "a playmate", "one to play with")
)  # fmt: skip
"""What is said of one that is alone."""
_WANTS_ROOM = tuple(
    (*wants.split(), *what.split())
    for wants in ("wants", "needs", "would like", "prefers", "likes")
    for what in ("to be left alone", "to be alone", "some peace", "peace and quiet", "some peace and quiet", "quiet",
                 "some space", "some room", "space", "its own space", "to be left in peace", "no company", "privacy",
                 "some privacy")
)  # fmt: skip
"""What is said of one that others are to keep away from."""
_BECAUSE = tuple(
    ("because", *who.split(), *why.split())
    for who in ("it is", "he is", "she is", "it feels", "he feels", "she feels")
    for why in ("alone", "all alone", "so alone", "lonely", "so lonely", "on its own", "tired", "cold")
)
_OF_WHAT = tuple(("of", *what.split()) for what in (
    "heights", "the height", "the dark", "falling", "falling down", "being alone", "ghosts", "spiders", "thunder",
    "water", "everything", "storms", "noise", "monsters",
))  # fmt: skip
"""What one is afraid of that is in no task."""


def _for_each_other(words: list[str], at: int) -> tuple[tuple[_Range, ...], int]:
    """Two blocks of which the one feels something for the other."""
    end = next((n for n in range(at, len(words)) if words[n] in _BEHIND), len(words))
    one = _block(words, at)
    if one == at:
        return (), at
    if words[one : one + 1] == ["and"]:
        other = _block(words, one + 1, plural=True)
        added = next((len(said) for said in _ALWAYS if (*words[end - len(said) : end],) == said), 0)
        mutual = other > one + 1 and " ".join(words[other : end - added]) in _MUTUAL
        return (((at, one), (one + 1, other)), end) if mutual else ((), at)
    end = next((n for n in range(at, len(words)) if words[n] in _BREAKS), len(words))
    for feels in _OF_ANOTHER:
        begin = one + len(feels.split())
        if words[one:begin] == feels.split() and begin < _block(words, begin) == end:
            return ((at, one), (begin, end)), end
    return (), at


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
    noun = looks[-1] if looks[-1].word in lexicon.PATCH else looks[-1].saying("block")
    bare = looks[-1].word in lexicon.COLOR or looks[-1].word in lexicon.SIZE
    return [block[0].saying("a"), *(looks if bare else looks[:-1]), noun]
