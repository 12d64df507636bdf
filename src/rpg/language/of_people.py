"""Clauses of people: "my back hurts", "we do not miss the bus", "you look strong today", "the inspector comes at noon".

What is told of somebody, of his body or of what he has about him can be in any words but those that could be meant of
blocks: those are known. So words that mean nothing here are let pass; none that points to what was told, or wishes for
something, for that may be told in such words as well.
"""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import harmless, lexicon
from rpg.language.smalltalk import (
    ACTING,
    BEING,
    DEMANDED,
    LOOKS_OF_PEOPLE,
    PERSONS,
    SAID_OF_SCENES,
    THING,
    asks,
    harmless_word,
    is_strange,
    takes_back,
)
from rpg.language.spelling import vocabulary
from rpg.language.telling import may_tell
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_AHEAD = (
    (harmless.ADVERBS - listed("once again later only"))
    | harmless.INTERJECTIONS
    | listed("and but well okay ok also that otherwise")
)
_SPEAKERS = listed("i we he she")
_ANYBODY = listed("everybody everyone somebody someone nobody people who")
_DET = listed("my our his her their your the a an this")
_OWN = listed("my our his her your")
_BODY = listed(
    "arm arms hand hands finger fingers leg legs foot feet knee knees back neck head eye eyes eyesight ear ears "
    "hearing sight memory joints bones muscles tummy stomach heart brain nerves voice hip hips shoulder shoulders "
    "thumb thumbs wrist battery patience time schedule shift flight appetite english"
)
_FOLK = PERSONS - listed("robot robots machine computer")
_ABOUT = (harmless.THINGS | harmless.ANIMALS | harmless.OCCASIONS | harmless.TIMES) - SAID_OF_SCENES - {"second"}
_TO_YOU = listed(
    "are 're look looked looks seem seemed sound did were deserve rock know knew deserved do amaze rule make"
)
"""What is said of whom a command is for that is none."""
_PHRASAL = listed(
    "down up over away around through across short long low high tall all any some few many more than enough only far "
    "back alone both together inside outside free once deep wide touch rest steady neatly tidy firm"
)
"""They could be meant of blocks, but not where somebody is told of."""
_MEASURED = listed("year years old o'clock sharp today now tomorrow already")
_OF_AGE = listed("is am are turns turned at just almost nearly only")
_LOOKED_ON = listed(
    "film films filming record records recording photograph photographing watch watches watching admire admires "
    "admiring broadcast tape taping study studies studying discuss show showing shows love loves enjoy enjoys about "
    "promised bought inherited received got"
)
"""What is looked at and shown may be what is asked for."""
_ANOTHER = listed("other another every each same different")
_LEFT_OUT = listed("allowed supposed permitted serious mean meant care")
_DENYING = listed("not never no nothing none without neither nor")
_BEFORE_NOT = listed("can could do does did is am are was were will would 'm 're has have")
_DOING = (
    harmless.DOINGS
    | BEING
    | _TO_YOU
    | listed(
        "start starts started begin begins began ends ended closes closed opens opened broke breaks lost ate failed "
        "fails"
    )
)
_BEFORE_VERBS = harmless.ADVERBS | {"all", "both"}
_ASKING = DEMANDED | listed("must should may might")


def of_people(tokens: Sequence[Token], *, denied: bool = False, anything: bool = False) -> bool:
    """Whether only somebody is told of. `denied`: what he is or does not may be told, as in reasons; `anything`: so may
    what any thing does that means nothing here, "the bell rings"."""
    words = [token.word for token in tokens]
    begin = next((n for n, word in enumerate(words) if word not in _AHEAD), len(words))
    strange = anything and words[begin : begin + 1] == ["the"] and any(map(is_strange, words[begin + 1 : begin + 2]))
    at = begin + (2 if strange else subject_of(words[begin:]))
    if at == begin or at >= len(words) or _asks(words, begin, at):
        return False
    denied = denied or not _BODY.isdisjoint(words[begin:at])
    doing = next((n for n in range(at, len(words)) if words[n] not in _BEFORE_VERBS), len(words) - 1)
    if not _does(words[doing], words[at - 1]) or not _ASKING.isdisjoint(words[begin:]):
        return False
    if not _no_task(words[begin], words[begin:at], words[at : at + 2]):
        return False
    if words[begin] == "you" and (
        words[at] not in _TO_YOU | ({"have"} if denied else set()) or words[at + 1 : at + 2] in (["to"], ["not"])
    ):
        return False
    return all(fits(tokens, n, denied) for n in range(at, len(words)))


def subject_of(words: Sequence[str]) -> int:
    """How many of the first words say of whom it is told."""
    if not words:
        return 0
    if words[0] in _SPEAKERS | _ANYBODY | {"you"} | harmless.NAMES:
        return 1
    at = 1 if words[0] in _DET else 0
    while at < min(4, len(words)) and words[at] in LOOKS_OF_PEOPLE and words[at] not in PERSONS:
        at += 1
    noun = words[at] if at < len(words) else ""
    person = noun in _FOLK and (words[0] in _DET or not noun.endswith("er"))
    about = words[0] in _DET and (noun in _ABOUT or (words[0] in _OWN and noun in _BODY))
    end = at + 1
    while (person or about) and end < len(words) and (words[end] in PERSONS | _ABOUT or words[end] == "'s"):
        end += 1
    return end if person or about else 0


def _does(word: str, subject: str) -> bool:
    """Whether a word tells what somebody does; one that means nothing here does by its ending, or behind many."""
    many = subject.endswith("s") or subject in ("i", "we", "you", "children", "people")
    strange = is_strange(word) and (many or word.endswith(("s", "ed", "ing"))) and word not in _THINGS
    return strange or word in _DOING or word in lexicon.VERB


_THINGS = harmless.THINGS | harmless.ANIMALS | harmless.OCCASIONS


def _asks(words: Sequence[str], begin: int, at: int) -> bool:
    """Whether they ask for something; "you look strong" is no command, nor is anything asked for "again" where it is
    told how somebody is."""
    if words[begin] == "you":
        return takes_back(words)
    return asks([word for word in words if word != "again"] if words[at] in BEING else words)


def _no_task(first: str, subject: Sequence[str], verb: Sequence[str]) -> bool:
    """ "The child sings a song" may be asked for; what "my child" does, and what the child "is singing", is not."""
    return first in _SPEAKERS | _OWN or ACTING.isdisjoint(subject) or not BEING.isdisjoint(verb)


def fits(tokens: Sequence[Token], n: int, denied: bool = False) -> bool:
    """Whether a word can only be of people, where one is told of."""
    words, token = [token.word for token in tokens], tokens[n]
    word, before, after = token.word, words[n - 1], words[n + 1 : n + 3]
    if token.kind == "number" or word in lexicon.NUMBER:
        if after and after[0] in harmless.TIMES:
            return True
        return before in _OF_AGE and (not after or after[0] in _MEASURED | harmless.TIMES | {"and"})
    if token.kind != "word" or (len(token.raw) > 1 and token.raw.isupper()):
        return word == "'s"
    if word in THING and before in _LOOKED_ON:
        return True
    if word in THING:
        return (
            word in ("this", "that", "these", "those") and bool(after) and after[0] in harmless.TIMES | {"far", "much"}
        )
    if word in _DENYING:
        able = before in ("can", "could")
        return word in ("not", "never") and before in _BEFORE_NOT and (able or denied) and _LEFT_OUT.isdisjoint(after)
    if word == "left":
        return before in harmless.TIMES
    if word == "right":
        return before in BEING or after[:1] in (["now"], ["away"])
    if word in _ANOTHER:
        return False
    if word == "back":
        return before in BEING | _OWN | listed("come comes came coming go went goes got get gets")
    plain = word in _PHRASAL or harmless_word(tokens, n) or is_strange(word)
    return plain or word in harmless.EVERYDAY or (word in vocabulary() and not may_tell(word))
