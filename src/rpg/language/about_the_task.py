"""What is told of the task itself and of who will try it, and of no block: "The task has two stages.", "initial poses
are random", "the episode ends after 30 seconds", "any order is OK", "Does the policy generalize?".

It says nothing of how the blocks are to be. Where it could, it is none of this.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.language.harmless import FINE, PEOPLE
from rpg.language.lexicon import plural_of
from rpg.language.smalltalk import is_strange
from rpg.language.telling import may_tell, may_tell_how, tells
from rpg.language.tokens import Token
from rpg.language.word_lists import listed

_TRIED = listed("policy policies agent agents model models learner controller planner baseline network method approach")
"""What tries a task."""
_TASK = _TRIED | listed(
    "task tasks stage stages phase phases episode episodes trial trials rollout rollouts run runs benchmark evaluation "
    "experiment experiments attempt attempts timeout horizon reward rewards score scores criterion criteria "
    "camera cameras lighting simulator simulation seed seeds noise difficulty curriculum instruction instructions "
    "prompt dataset demonstration demonstrations video videos"
)
"""What a task has about it."""
_MADE = listed("outcome outcomes result results solution solutions")
_JUDGED = listed(
    "unique count counts counting as passed pass correct checked scored graded judged evaluated rated automatically by "
    "script success the a with visually later logged stored"
)
"""What comes of a task, which is made of blocks, and what may be said of it."""
_SOME = listed("no only first second third last next other one two three four five new old same")
"""With these not all of that is spoken of."""
_LIKE = re.compile("(?:ic|ical|al|ous|ed|ular|ar)$")
"""How words end that tell what something is like."""
_AHEAD = listed(
    "the a an this that our my your its their both each every all no any one two three four five first second third "
    "last final next initial starting start random whole entire only same other new old current"
)
"""What may stand in front of these."""
_OPEN = listed(
    "order ordering sequence position positions location locations placement orientation orientations yaw rotation "
    "direction directions color colors pose poses arrangement way layout"
)
"""What may be left open."""
_WEIGHTY = listed("important essential crucial vital urgent serious real true special")
"""With these something is just not left open."""
_FREE = (FINE - _WEIGHTY) | listed(
    "ok okay free random arbitrary irrelevant open accepted allowed acceptable valid unimportant unspecified "
    "unconstrained possible randomized permitted admissible"
)
_WHOSE = listed("any the its their whose every initial starting start exact final")
_IS = listed("is are 's will be was were counts as remains stays")
_COUNTED = listed(
    "second seconds minute minutes month months year years day days week weeks step steps try tries "
    "attempt attempts time times hour hours"
)
_ASKED = listed("does do did is are was were has have")
_TRIES = listed("do handle solve manage complete pass achieve this that it")
_BINDING = listed("must should shall may not never without unless until if only except but instead")
_LONGEST = 20


def of_the_task(tokens: Sequence[Token]) -> bool:
    """Whether all of this is told of the task, or of what is left open in it."""
    words = [token.word for token in tokens]
    if not 2 < len(words) <= _LONGEST or any(token.kind not in ("word", "number", "punct") for token in tokens):
        return False
    return _left_open(words) or _asks_of_who_tries(tokens, words) or _told(tokens, words) or _studied(tokens, words)


def _left_open(words: list[str]) -> bool:
    """ "Any order is OK", "position is free", "initial poses are random"."""
    at = next((n for n, word in enumerate(words) if word not in _WHOSE), len(words))
    named = words[at : at + 1] and words[at] in _OPEN
    behind = words[at + 1 :]
    return bool(named) and len(behind) > 1 and behind[0] in _IS and all(word in _FREE | _IS for word in behind)


def _asks_of_who_tries(tokens: Sequence[Token], words: list[str]) -> bool:
    """ "Does the policy generalize to spelling?"; "can the policy do this?", which asks for no more than the task."""
    if _TRIED.isdisjoint(words[1:4]) or any(map(tells, tokens)):
        return False
    at = next(n for n, word in enumerate(words) if word in _TRIED)
    return words[0] in _ASKED or (words[0] in ("can", "could", "will") and _TRIES.issuperset(words[at + 1 :]))


def _told(tokens: Sequence[Token], words: list[str]) -> bool:
    """ "The task has two stages", "no reward is given for partial success", "this is stage two of the curriculum"."""
    begin = 2 if words[0] in ("this", "it", "that") and words[1] in ("is", "was", "'s") else 0
    subject = next((n for n in range(begin, len(words)) if words[n] not in _AHEAD), len(words))
    if subject >= len(words) or not _BINDING.isdisjoint(words):
        return False
    if words[subject] in _MADE and _SOME.isdisjoint(words[begin:subject]):
        return all(word in _JUDGED | _FREE | _IS for word in words[subject + 1 :])
    how = words[subject + 2 :] if words[subject + 1 : subject + 2] and words[subject + 1] in _IS else []
    if words[subject] not in _TASK or any(_LIKE.search(word) for word in how[:2] if word not in _FREE):
        return False  # "the task is palindromic"
    return not any(_of_blocks(tokens, words, n) for n in range(subject + 1, len(words)))


def _of_blocks(tokens: Sequence[Token], words: list[str], n: int) -> bool:
    """Whether a word could tell of blocks where it stands; "two stages" and "30 seconds" do not."""
    if not (tells(tokens[n]) or may_tell(words[n])) or words[n] in _TASK:
        return False
    counts = words[n + 1 : n + 2] and words[n + 1] in _TASK | _COUNTED
    return not (counts or (words[n - 1] in _TASK and tokens[n].many))


_STUDIES = frozenset(
    form
    for verb in listed(
        "probe test check measure assess study examine investigate describe discuss report mention propose master "
        "learn know teach train evaluate publish analyze explain love enjoy like"
    )
    for form in (verb, plural_of(verb), f"{verb}d" if verb.endswith("e") else f"{verb}ed")
) | listed("studied taught knew")
_TOPICS = listed("object objects this it that")


def _studied(tokens: Sequence[Token], words: list[str]) -> bool:
    """ "This probes object permanence", "Piaget described this", "toddlers master this at 18 months": who deals with
    it, or what it is good for."""
    begin = 1 if words[0] in ("the", "our", "my", "many", "most", "some") else 0
    verb = next((n for n in range(begin + 1, begin + 4) if words[n : n + 1] != [] and words[n] in _STUDIES), 0)
    who = words[begin:verb]
    known = who in (["this"], ["it"], ["that"]) or all(is_strange(word) or word in PEOPLE for word in who)
    behind = range(verb + 1, len(words))
    if not verb or not known or not behind or not _BINDING.isdisjoint(words):
        return False
    return not any(
        words[n] not in _TOPICS and (_of_blocks(tokens, words, n) or (is_strange(words[n]) and may_tell_how(words[n])))
        for n in behind
    )
